// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_points.h"

namespace quoin {

/// Half of what a Voronoi facet contributes to a stable surface: spanned by an input point and a segment of the facet
/// all of whose points flow on to `towards`.
struct StableTriangle {
  std::uint32_t vertex;   ///< an input point: vertex of the complex
  std::uint32_t towards;  ///< among the surface's points, and so
  std::uint32_t from;     ///< is this
};

/// A critical edge that bounds a stable surface.
struct StableSide {
  std::uint32_t edge;
  std::uint32_t point;  ///< its midpoint, among the surface's points
  unsigned depth;       ///< flow segments from there to the saddle
};

/// The points that flow to a critical point of index 2.
struct StableSurface {
  std::uint32_t polygon = 0;  ///< whose centre the critical point is
  FlowPoints points;          ///< the first is the critical point
  std::vector<StableTriangle> triangles;
  std::vector<StableSide> sides;

  // What makes it no ordinary surface; never happens to points in general position.
  bool has_voronoi_vertex = false;  ///< it goes on from a Voronoi vertex along all facets from which the flow enters
  bool has_solid_part = false;      ///< and more flows there along a Voronoi edge: a solid, of which this is a part
  bool has_regular_point = false;   ///< it goes on behind a stationary point that is not critical

  bool is_ordinary() const { return !has_voronoi_vertex && !has_solid_part && !has_regular_point; }
};

/// The stable surface of a critical polygon, by following the flow backwards through Voronoi facets, from the polygon's
/// sides to critical edges. Exact. O(k) for k facets with rings of bounded size.
/// The complex must outlive the surface. @throws InputError if the polygon is not critical; Cancelled
/// Source: Giesen and John 2003; section 2.3 of Cazals, Parameswaran and Pion.
StableSurface stable_surface(const FlowComplex& flow, std::uint32_t polygon, const Context& context,
                             FlowNumbers numbers = FlowNumbers::filtered);

}  // namespace quoin
