// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/flow/flow_cells.h"

namespace quoin {

/// A triangle around an edge, by the vertex that is off the edge: its Voronoi edge bounds the facet of the edge.
struct FacetSpoke {
  CellFacet facet{};
  bool is_above = true;  ///< its simplex comes next on the walk around the edge; else it comes before
  std::uint32_t vertex = 0;
  unsigned corner = 0;    ///< slot of the vertex
  bool is_joined = true;  ///< a simplex is between this and the next one; else a gap of the hull
};

/// Calls `visit(FacetSpoke)` around the edge of a side, from its facet on, first through the facet's simplex: of each
/// simplex the triangle with the vertex behind; and before a gap of the hull the last one from below.
template <class Visit>
void for_each_spoke(const FlowCells& flow, const CellSide& side, const Visit& visit) {
  RingPlace at{side.facet.cell, side.corner, side.facet.slot};
  do {
    // The walk leaves through the facet opposite to `behind`.
    const RingPlace next = at.next(flow.cells());
    if (!flow.is_ghost(at.cell)) {
      const std::array<std::uint32_t, 4>& v = flow.cells()[at.cell].vertices;
      const bool ends = flow.is_ghost(next.cell);
      visit(FacetSpoke{{at.cell, at.ahead}, true, v[at.behind], at.behind, true});
      if (ends) visit(FacetSpoke{{at.cell, at.behind}, false, v[at.ahead], at.ahead, false});
    }
    at = next;
  } while (at.cell != side.facet.cell);
}

/// Sign of the power of the spoke's vertex to the sphere that has the edge as a diameter: negative at an obtuse angle.
inline Sign power_of(const FlowCells& flow, const FacetSpoke& spoke) {
  const CellShape& shape = flow.shape(spoke.facet.cell);
  if (shape.wide_corner(spoke.facet.slot) != spoke.corner) return Sign::positive;
  return shape.is_right(spoke.facet.slot) ? Sign::zero : Sign::negative;
}

}  // namespace quoin
