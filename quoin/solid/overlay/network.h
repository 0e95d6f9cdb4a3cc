// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/overlay/clusters.h"
#include "quoin/solid/overlay/point_merger.h"
#include "quoin/solid/overlay/scene.h"

namespace quoin::overlay {

/// A segment strictly inside a facet (its ends may lie on the boundary), along the line in which plane `cut` meets the
/// facet's.
struct Curve {
  std::uint32_t facet;
  PointId from;  ///< from < to
  PointId to;
  PlaneId cut;
  Edge edge;  ///< the edge along which it runs if `cut` is parallel to an axis, else {none, none}

  bool is_along_edge() const { return edge.a != none; }
};

/// All vertices of the overlay but those where curves cross inside facets, and what they lie on.
struct Network {
  std::vector<PointOnEdge> edge_points;    ///< sorted, unique
  std::vector<PointInFacet> facet_points;  ///< sorted, unique
  std::vector<Curve> curves;               ///< by facet; no two with the same facet and ends
  std::vector<bool> involved;              ///< per facet: its boundary takes part in the order of sides about edges
  std::vector<bool> cut;                   ///< per facet: has points or curves, so that it is subdivided
  Clusters clusters;
  PointMerger merger;  ///< holds all points so far

  std::span<const PointOnEdge> points_on(Edge edge) const;
  std::span<const PointInFacet> points_in(std::uint32_t facet) const;
  std::span<const Curve> curves_in(std::uint32_t facet) const;
};

/// Intersects all candidate pairs of the scene, sets planes and constructs the vertices. O(pairs + contacts log
/// contacts).
Network make_network(Scene& scene, const Context& context);

}  // namespace quoin::overlay
