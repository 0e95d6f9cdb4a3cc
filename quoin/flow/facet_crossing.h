// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/flow/flow_points.h"

namespace quoin {

/// Where a line in a Voronoi facet leaves it.
struct FacetExit {
  enum class Kind {
    edge,      ///< in an open Voronoi edge, dual to a polygon
    vertex,    ///< in a Voronoi vertex, dual to a cell
    infinity,  ///< nowhere
    midpoint   ///< it ends in the midpoint of the edge, which is in the open facet
  };
  Kind kind = Kind::infinity;
  std::uint32_t point = FlowPoints::none;  ///< new; of kinds edge, vertex and midpoint
  /// The point is the midpoint, on the boundary of the facet.
  bool is_at_midpoint = false;
};

/// Follows orbits through the Voronoi facet of an edge from a point on its boundary, or in it, away from the edge's
/// midpoint. They must enter the facet there: `crossed` of the point's face is the edge.
///
/// The other polygons around the edge cut the ray at lambda = power / (y . direction): the least one is the exit, two
/// equal ones are a Voronoi vertex. Intervals decide; where they cannot, rationals do. O(k) for k polygons around the
/// edge. Source: section 4 of Cazals, Parameswaran and Pion; departs from it: least fractions instead of a search among
/// signs, since rings are short, and neither circumcentres nor rays are needed.
FacetExit cross_forward(FlowPoints& points, std::uint32_t point, std::uint32_t edge);

/// The same towards the midpoint, against the flow: all points on the way flow to the given one. The edge must be an
/// entering edge of the point's face.
FacetExit cross_backward(FlowPoints& points, std::uint32_t point, std::uint32_t edge);

}  // namespace quoin
