// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/flow/flow_cells.h"

// Delone faces of more than one simplex: cells of cospherical simplices, polygons of their coplanar facets.
namespace quoin {

namespace {

/// Whether the value was not yet in the ascending list.
bool insert(std::vector<std::uint32_t>& sorted, std::uint32_t value) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (place != sorted.end() && *place == value) return false;
  sorted.insert(place, value);
  return true;
}

void sort_once(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

/// A polygon is more than a triangle only between two cells that are more than a simplex, or on the hull.
bool FlowCells::is_triangle(CellFacet facet) const {
  const std::uint32_t other = mate(facet).cell;
  return inner(facet.cell) == 0 || (!is_ghost(other) && inner(other) == 0);
}

/// From a side of a facet of a Delone cell, through the cell: the other facet of the cell there.
CellSide FlowCells::turned_inside(CellSide side) const {
  RingPlace at{side.facet.cell, side.corner, side.facet.slot};
  while ((inner(at.cell) >> at.behind & 1) != 0) at = at.next(cells_);
  return {{at.cell, at.behind}, at.ahead};
}

// The polygon goes on where both cells, turned around the edge, come to the same facet. On the hull there is no other
// cell: there it goes on in the plane.
bool FlowCells::is_inside_polygon(CellSide side) const {
  if ((inner(side.facet.cell) >> side.corner & 1) == 0) return false;
  const CellSide here = turned_inside(side);
  const CellFacet other = mate(side.facet);
  const std::uint32_t corner = cells_[side.facet.cell].vertices[side.corner];
  const CellFacet there = mate(here.facet);
  if (is_ghost(other.cell) != is_ghost(there.cell)) return false;
  if (is_ghost(other.cell)) {
    const std::array<std::uint32_t, 4>& v = cells_[other.cell].vertices;
    return signs_.orientation(v[0], v[1], v[2], cells_[here.facet.cell].vertices[here.corner]) == 0;
  }
  unsigned slot = 0;
  while (cells_[other.cell].vertices[slot] != corner) ++slot;
  return turned_inside({other, slot}).facet == there;
}

std::vector<CellFacet> FlowCells::polygon(CellFacet facet) const {
  std::vector<CellFacet> found{facet};
  if (is_triangle(facet)) return found;
  std::vector<std::uint32_t> sorted{facet.number()};
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (unsigned corner = 0; corner < 4; ++corner) {
      const CellFacet here = found[at];
      if (corner == here.slot || !is_inside_polygon({here, corner})) continue;
      const CellFacet next = turned_inside({here, corner}).facet;
      if (insert(sorted, next.number())) found.push_back(next);
    }
  }
  return found;
}

NamedPolygon FlowCells::named(CellFacet facet) const {
  NamedPolygon best{facet, true};
  const auto add = [&](const CellFacet& part) {
    if (part.number() < best.facet.number()) best = {part, true};
    const CellFacet back = mate(part);
    if (!is_ghost(back.cell) && back.number() < best.facet.number()) best = {back, false};
  };
  if (is_triangle(facet)) {
    add(facet);
  } else {
    for (const CellFacet& part : polygon(facet)) add(part);
  }
  return best;
}

std::vector<std::uint32_t> FlowCells::cluster(std::uint32_t cell) const {
  std::vector<std::uint32_t> found{cell};
  std::vector<std::uint32_t> sorted{cell};
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (unsigned i = 0; i < 4; ++i) {
      if ((inner(found[at]) >> i & 1) == 0) continue;
      const std::uint32_t next = cells_[found[at]].neighbours[i] >> 2;
      if (insert(sorted, next)) found.push_back(next);
    }
  }
  return found;
}

/// All facets between the Delone cell and others.
std::vector<CellFacet> FlowCells::polygons_of(std::uint32_t cell) const {
  std::vector<CellFacet> facets;
  for (const std::uint32_t c : cluster(cell)) {
    for (unsigned i = 0; i < 4; ++i) {
      if ((inner(c) >> i & 1) == 0) facets.push_back({c, i});
    }
  }
  return facets;
}

std::vector<std::uint32_t> FlowCells::vertices_of(std::uint32_t cell) const {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t c : cluster(cell)) {
    vertices.insert(vertices.end(), cells_[c].vertices.begin(), cells_[c].vertices.end());
  }
  sort_once(vertices);
  return vertices;
}

std::vector<std::uint32_t> FlowCells::vertices_of_polygon(CellFacet facet) const {
  std::vector<std::uint32_t> vertices;
  for (const CellFacet& part : polygon(facet)) {
    for (const unsigned slot : facet_slots[part.slot]) vertices.push_back(cells_[part.cell].vertices[slot]);
  }
  sort_once(vertices);
  return vertices;
}

bool FlowCells::is_before(std::uint32_t cell, std::uint32_t other) const {
  return vertices_of(cell) < vertices_of(other);
}

CellFacet FlowCells::way_past(std::uint32_t cell) const {
  CellFacet best{};
  bool has_best = false;
  for (const CellFacet& f : polygons_of(cell)) {
    if (shape(f.cell).centre_sign(f.slot) != Sign::zero) continue;
    const std::uint32_t behind = mate(f).cell;
    const bool is_better =
        !has_best || (!is_ghost(behind) && (is_ghost(mate(best).cell) || is_before(behind, mate(best).cell)));
    if (is_better) best = f;
    has_best = true;
  }
  return best;
}

// Across the side of the longest distance to the centre; triangles behind others are behind inner sides.
CellSide FlowCells::way_of_polygon(CellFacet facet) const {
  const unsigned corner = shape(facet.cell).obtuse_corner(facet.slot);
  if (corner == facet.slot && is_triangle(facet)) return {facet, corner};
  if (corner != facet.slot && !is_inside_polygon({facet, corner})) return {facet, corner};
  for (const CellFacet& part : polygon(facet)) {
    const unsigned wide = shape(part.cell).obtuse_corner(part.slot);
    if (wide != part.slot && !is_inside_polygon({part, wide})) return {part, wide};
  }
  return {facet, facet.slot};
}

bool FlowCells::is_critical_polygon(CellFacet facet) const {
  const CellFacet other = mate(facet);
  if (shape(facet.cell).centre_sign(facet.slot) != Sign::positive) return false;
  if (!is_ghost(other.cell) && shape(other.cell).centre_sign(other.slot) != Sign::positive) return false;
  const std::vector<CellFacet> parts = polygon(facet);
  return std::all_of(parts.begin(), parts.end(), [&](const CellFacet& part) {
    const unsigned wide = shape(part.cell).wide_corner(part.slot);
    return wide == part.slot || is_inside_polygon({part, wide});
  });
}

void FlowCells::entering_sides(CellFacet facet, std::vector<CellSide>& sides) const {
  sides.clear();
  const auto add = [&](const CellFacet& part, bool is_alone) {
    const unsigned wide = shape(part.cell).wide_corner(part.slot);
    for (unsigned corner = 0; corner < 4; ++corner) {
      if (corner == part.slot || corner == wide || (!is_alone && is_inside_polygon({part, corner}))) continue;
      sides.push_back({part, corner});
    }
  };
  if (is_triangle(facet)) {
    add(facet, true);
    return;
  }
  for (const CellFacet& part : polygon(facet)) add(part, false);
}

void FlowCells::entering_edges(std::uint32_t cell, std::vector<CellSide>& sides) const {
  sides.clear();
  for (const CellFacet& f : polygons_of(cell)) {
    const unsigned wide = shape(f.cell).wide_corner(f.slot);
    for (unsigned corner = 0; corner < 4; ++corner) {
      if (corner == f.slot || corner == wide || is_inside_polygon({f, corner})) continue;
      const CellSide other = turned_inside({f, corner});
      if (shape(other.facet.cell).wide_corner(other.facet.slot) == other.corner) continue;
      if (f.number() < other.facet.number()) sides.push_back({f, corner});
    }
  }
}

bool FlowCells::has_entering_polygon(std::uint32_t cell) const {
  for (const CellFacet& f : polygons_of(cell)) {
    if (shape(f.cell).centre_sign(f.slot) != Sign::positive) continue;
    if (way_of_polygon(f).corner == way_of_polygon(f).facet.slot) return true;
  }
  return false;
}

}  // namespace quoin
