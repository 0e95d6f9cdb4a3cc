// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/flow/flow_cells.h"

// Stationary points that are not critical: the centre is on its dual, and on the boundary of the hull of its nearest
// input points.
namespace quoin {

std::vector<std::uint32_t> FlowCells::regular_cells(const Context& context) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t c = 0; c < rows_.size(); ++c) {
    if (c % 1024 == 0) context.poll();
    if (is_ghost(c) || shape(c).centre_zero() == 0 || first_of(c) != c) continue;
    if (way(c).kind == CellWay::Kind::regular) found.push_back(c);
  }
  // Those of larger cells, whose first simplex may have no facet through the centre.
  for (const ClusterWay& cluster : cluster_ways_) {
    if (cluster.way.kind == CellWay::Kind::regular && shape(cluster.first).centre_zero() == 0) {
      found.push_back(cluster.first);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool FlowCells::is_regular_polygon(CellFacet facet) const {
  const CellFacet other = mate(facet);
  if (shape(facet.cell).centre_sign(facet.slot) != Sign::positive) return false;
  if (!is_ghost(other.cell) && shape(other.cell).centre_sign(other.slot) != Sign::positive) return false;
  const CellSide way = way_of_polygon(facet);
  return way.corner == way.facet.slot && !is_critical_polygon(facet);
}

std::vector<CellFacet> FlowCells::regular_polygons(const Context& context) const {
  std::vector<CellFacet> found;
  for (std::uint32_t c = 0; c < rows_.size(); ++c) {
    if (c % 1024 == 0) context.poll();
    if (is_ghost(c)) continue;
    for (unsigned i = 0; i < 4; ++i) {
      const CellFacet facet{c, i};
      // A right angle, or a part of a larger polygon whose right angle may be elsewhere.
      if (is_inside_cell(facet) || (is_triangle(facet) && !shape(c).is_right(i))) continue;
      if (named(facet).facet == facet && is_regular_polygon(facet)) found.push_back(facet);
    }
  }
  return found;
}

}  // namespace quoin
