// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/saddle_sheets.h"

#include <algorithm>
#include <array>

namespace quoin {

const CellSheet& SaddleSheets::follow(std::uint32_t cell, unsigned edge, const Context& context) {
  if (parts_ == SheetParts::all) {
    chain().clear();
    done_.clear();
    exit_of_vertex_.clear();
    exit_of_point_.clear();
    joined_ = 0;
  }
  context.poll();
  open_.clear();
  sheet_.pieces.clear();
  sheet_.corners.clear();
  sheet_.along.clear();
  sheet_.cells.clear();
  sheet_.saddles.clear();
  sheet_.is_infinite = sheet_.has_regular_point = sheet_.has_stationary_end = false;
  const OtherSlots off = other_slots[edge_slots[edge][0]][edge_slots[edge][1]];
  start({{cell, off.ahead}, off.behind});
  for (std::size_t steps = 1; !open_.empty(); ++steps) {
    if (steps % 256 == 0) context.poll();
    const SheetPart next = open_.back();
    open_.pop_back();
    add(next);
  }
  sheet_.parts = joined_;
  const auto sort = [](auto& list, const auto& before) {
    std::sort(list.begin(), list.end(), before);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  sort(sheet_.cells, std::less<>());
  sort(sheet_.saddles, [](CellFacet a, CellFacet b) { return a.number() < b.number(); });
  return sheet_;
}

/// The polygons around the edge of a side. Facets inside Delone cells bound nothing.
void SaddleSheets::gather(const CellSide& side) {
  ring_.clear();
  for_each_spoke(flow_, side, [this](const FacetSpoke& spoke) {
    if (!spoke.is_above || !flow_.is_inside_cell(spoke.facet)) ring_.push_back(spoke);
  });
}

/// The spoke behind which the facet has the Voronoi vertex of a Delone cell.
std::size_t SaddleSheets::place_of_cell(std::uint32_t first) const {
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    if (!is_gap(i) && flow_.first_of(ring_[i].facet.cell) == first) return i;
  }
  return 0;
}

void SaddleSheets::start(const CellSide& side) {
  gather(side);
  const FlowTriangle ends = crosser_.entry(side);
  sheet_.pieces.push_back({.edge = {ends[0], ends[1]}});
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    add_vertex(i);
    open_.push_back(part_of_spoke(i, nullptr, nullptr));
  }
}

int SaddleSheets::compare(const SheetEnd& a, const SheetEnd& b) {
  if (a.side != b.side) return a.side < b.side ? -1 : 1;
  if (a.side != 0 || a.point == b.point) return 0;
  const Sign sign = chain().compare(a.point, b.point);
  return static_cast<int>(a.is_up ? sign : -sign);
}

/// Follows what is left of a part outside those that were followed, and joins it with those that it touches.
void SaddleSheets::add(const SheetPart& part) {
  std::vector<SheetPart>& done = done_[part.polygon.number()];
  auto at = done.begin();
  while (at != done.end() && compare(at->high, part.low) < 0) ++at;
  auto last = at;
  SheetPart joined = part;
  SheetPart left = part;
  std::vector<SheetPart> rest;
  for (; last != done.end() && compare(last->low, part.high) <= 0; ++last) {
    if (compare(left.low, last->low) < 0) rest.push_back({part.polygon, left.low, last->low});
    if (compare(last->low, joined.low) < 0) joined.low = last->low;
    if (compare(joined.high, last->high) < 0) joined.high = last->high;
    left.low = last->high;
  }
  if (compare(left.low, part.high) < 0) rest.push_back(left);
  if (rest.empty()) return;
  joined_ = joined_ + 1 - static_cast<std::size_t>(last - at);
  done.insert(done.erase(at, last), joined);
  for (const SheetPart& piece : rest) follow(piece);
}

void SaddleSheets::follow(const SheetPart& part) {
  const CellSide side = flow_.way_of_polygon(part.polygon);
  if (side.corner == side.facet.slot) {
    follow_along(part);
  } else {
    follow_through(part, side);
  }
}

/// Of the place of an end on the line, from the circumcentre.
Sign SaddleSheets::sign_of(CellFacet polygon, const SheetEnd& end) {
  if (end.side == 0) {
    const Sign sign = chain().side(end.point);
    return end.is_up ? sign : -sign;
  }
  if (end.side > 0) return flow_.shape(polygon.cell).centre_sign(polygon.slot);
  const CellFacet other = flow_.mate(polygon);
  return flow_.is_ghost(other.cell) ? Sign::negative : -flow_.shape(other.cell).centre_sign(other.slot);
}

void SaddleSheets::follow_along(const SheetPart& part) {
  const Sign low = sign_of(part.polygon, part.low);
  const Sign high = sign_of(part.polygon, part.high);
  if (low == Sign::zero || high == Sign::zero) sheet_.has_stationary_end = true;
  if (low == Sign::negative && high == Sign::positive) {
    if (flow_.is_critical_facet(part.polygon.cell, part.polygon.slot)) {
      sheet_.saddles.push_back(part.polygon);
    } else {
      sheet_.has_regular_point = true;
    }
  }
  sheet_.along.push_back(part);
  if (high == Sign::positive) sheet_.cells.push_back(flow_.first_of(part.polygon.cell));
  if (low != Sign::negative) return;
  const std::uint32_t below = flow_.mate(part.polygon).cell;
  sheet_.is_infinite |= flow_.is_ghost(below);
  if (!flow_.is_ghost(below)) sheet_.cells.push_back(flow_.first_of(below));
}

// The rays from the edge's midpoint do not cross: that of the upper end is the first on the walk around the facet.
void SaddleSheets::follow_through(const SheetPart& part, const CellSide& side) {
  gather(side);
  const Exit high = exit(part.high, true, side);
  const Exit low = exit(part.low, false, side);
  const FlowTriangle triangle = crosser_.entry(side);
  sheet_.pieces.push_back({{triangle[0], triangle[1]}, part, sheet_.corners.size(), true});
  add_end(part.polygon, part.low);
  add_end(part.polygon, part.high);
  add_exit(high);
  const std::size_t first = high.is_point() ? high.spoke : high.spoke + 1;
  for (std::size_t i = first; i <= low.spoke; ++i) {
    open_.push_back(part_of_spoke(i, i == high.spoke ? &high.end : nullptr, i == low.spoke ? &low.end : nullptr));
    if (i < low.spoke) add_vertex(i);
  }
  add_exit(low);
  const std::size_t begin = sheet_.pieces.back().first_corner;
  if (sheet_.corners.size() > begin + 1 && sheet_.corners.back() == sheet_.corners[begin]) sheet_.corners.pop_back();
}

SaddleSheets::Exit SaddleSheets::exit(const SheetEnd& end, bool is_high, const CellSide& side) {
  if (end.side != 0) return exit_of_vertex(is_high, side);
  const auto [at, is_new] = exit_of_point_.try_emplace(end.point);
  if (is_new) at->second = crosser_.forward(end.point, side);
  return exit_of(at->second);
}

// Where the next Voronoi edge is on the far side, the ray only touches the facet; where it points to the midpoint, the
// ray goes along it; else it crosses the facet as the orbit of the vertex does. What comes from infinity goes there:
// the entry edge is between the midpoint and the facet, so that far out the rays are inside.
SaddleSheets::Exit SaddleSheets::exit_of_vertex(bool is_high, const CellSide& side) {
  const std::size_t last = ring_.size() - 1;
  const std::size_t own = is_high ? 0 : last;
  if (is_gap(own)) return {own};
  const Sign power = power_of(flow_, ring_[is_high ? 1 : last]);
  if (power == Sign::positive) return {own};
  if (power == Sign::zero) return {is_high ? 1 : last - 1};
  const CellFacet facet = is_high ? side.facet : flow_.mate(side.facet);
  const auto [at, is_new] = exit_of_vertex_.try_emplace(flow_.first_of(facet.cell));
  if (is_new) {
    const std::uint32_t apex = flow_.cells()[facet.cell].vertices[facet.slot];
    at->second = crosser_.forward(chain().add_centre(crosser_.entry(side), apex), side);
  }
  return exit_of(at->second);
}

/// In the ring, which may be walked the other way round than when the exit was found.
SaddleSheets::Exit SaddleSheets::exit_of(const CellExit& found) const {
  if (found.kind == CellExit::Kind::vertex) return {place_of_cell(flow_.first_of(found.cell))};
  std::size_t i = 0;
  if (found.kind == CellExit::Kind::infinity) {
    while (!is_gap(i)) ++i;
    return {i};
  }
  const CellFacet mate = flow_.mate(found.facet);
  while (!(ring_[i].facet == found.facet || ring_[i].facet == mate)) ++i;
  // The normal of the point's triangle points to the facet's simplex where that is above.
  return {i, {0, found.point, found.is_above == flow_.named(found.facet).is_same_side}};
}

/// From one point to another, or from where the facet's boundary comes to the spoke, or to where it leaves it.
SheetPart SaddleSheets::part_of_spoke(std::size_t spoke, const SheetEnd* from, const SheetEnd* to) const {
  const NamedPolygon polygon = flow_.named(ring_[spoke].facet);
  const bool is_up = ring_[spoke].is_above == polygon.is_same_side;
  SheetPart part{polygon.facet};
  if (!is_up) std::swap(from, to);
  if (from != nullptr && from->side == 0) part.low = *from;
  if (to != nullptr && to->side == 0) part.high = *to;
  return part;
}

void SaddleSheets::add_corner(const SheetCorner& corner) {
  const bool is_known = sheet_.corners.size() > sheet_.pieces.back().first_corner && sheet_.corners.back() == corner;
  if (!is_known) sheet_.corners.push_back(corner);
}

void SaddleSheets::leave_open() {
  sheet_.pieces.back().is_bounded = false;
  sheet_.is_infinite = true;
}

/// The Voronoi vertex behind a spoke.
void SaddleSheets::add_vertex(std::size_t spoke) {
  if (is_gap(spoke)) {
    leave_open();
    return;
  }
  const std::uint32_t cell = flow_.first_of(ring_[spoke].facet.cell);
  sheet_.cells.push_back(cell);
  add_corner({false, cell});
}

void SaddleSheets::add_exit(const Exit& exit) {
  if (exit.is_point()) {
    add_corner({true, exit.end.point});
  } else {
    add_vertex(exit.spoke);
  }
}

void SaddleSheets::add_end(CellFacet polygon, const SheetEnd& end) {
  const std::uint32_t cell = end.side > 0 ? polygon.cell : flow_.mate(polygon).cell;
  if (end.side == 0) {
    add_corner({true, end.point});
  } else if (flow_.is_ghost(cell)) {
    leave_open();
  } else {
    add_corner({false, flow_.first_of(cell)});
  }
}

}  // namespace quoin
