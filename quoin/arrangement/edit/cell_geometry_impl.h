// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/cell_geometry.h"
#include "quoin/base/error.h"

/// Bodies of CellGeometry, for the one source file per family that instantiates it.
namespace quoin {

/// As DcelBuilder decides it: at the smallest vertex of the cycle, coming from the right and leaving to the right.
template <CurveFamily F>
bool CellGeometry<F>::is_outer(dcel::HalfedgeId on_cycle) const {
  dcel::VertexId least;
  bool is_inner = false;
  dcel::HalfedgeId h = on_cycle;
  do {
    if (cells().edges[h.edge().index()] == dcel::CellState::fictitious) return true;
    const dcel::HalfedgeId before = cells().previous(h);
    const dcel::VertexId v = cells().origin(h);
    if (h.is_forward() && !before.is_forward()) {
      const bool turns = before.twin() == h ||
                         family().compare_right(arrangement_.branch(before.edge()), arrangement_.branch(h.edge()),
                                                arrangement_.point(v)) == Sign::negative;
      if (v == least) {
        is_inner = is_inner || turns;
      } else if (least.is_none() || is_before(arrangement_.point(v), arrangement_.point(least))) {
        least = v;
        is_inner = turns;
      }
    }
    h = cells().next(h);
  } while (h != on_cycle);
  return !is_inner;
}

/// By the parity of the halfedges of the cycle below the vertex; those of the frame's bottom are below everything.
template <CurveFamily F>
bool CellGeometry<F>::contains(dcel::HalfedgeId on_cycle, dcel::VertexId v) const {
  const Point& p = arrangement_.point(v);
  bool is_inside = false;
  dcel::HalfedgeId h = on_cycle;
  do {
    const dcel::EdgeId e = h.edge();
    if (!cells().is_real(e)) {
      if (bottom_edge_spans(h, p)) is_inside = !is_inside;
    } else if (spans(arrangement_, e, p) && family().compare_y_at_x(p, arrangement_.branch(e)) == Sign::positive) {
      is_inside = !is_inside;
    }
    h = cells().next(h);
  } while (h != on_cycle);
  return is_inside;
}

template <CurveFamily F>
RingSearch CellGeometry<F>::place_right(dcel::VertexId v, BranchId branch) const {
  const dcel::HalfedgeId start = cells()[v].out;
  if (start.is_none()) return {{v, dcel::HalfedgeId()}, {}};
  if (!cells().is_real(v)) {  // an end at infinity has one curve
    dcel::HalfedgeId real = start;
    while (!cells().is_real(real.edge())) real = cells().clockwise(real);
    return {{}, real.edge()};
  }
  const Point& p = arrangement_.point(v);
  // Counterclockwise: edges to the right from bottom to top, edges to the left from top to bottom.
  dcel::HalfedgeId below;
  dcel::HalfedgeId highest;
  dcel::HalfedgeId lowest_left;
  dcel::HalfedgeId h = start;
  do {
    const BranchId other = arrangement_.branch(h.edge());
    if (h.is_forward()) {
      const Sign order = family().compare_right(branch, other, p);
      if (order == Sign::zero) return {{}, h.edge()};
      const auto is_above_edge = [&](dcel::HalfedgeId than) {
        return than.is_none() || family().compare_right(other, arrangement_.branch(than.edge()), p) == Sign::positive;
      };
      if (is_above_edge(highest)) highest = h;
      if (order == Sign::positive && is_above_edge(below)) below = h;
    } else if (lowest_left.is_none() ||
               family().compare_left(other, arrangement_.branch(lowest_left.edge()), p) == Sign::negative) {
      lowest_left = h;
    }
    h = cells().counterclockwise(h);
  } while (h != start);
  if (below.is_none()) below = lowest_left.is_none() ? highest : lowest_left;
  return {after(v, below), {}};
}

template <CurveFamily F>
RingSearch CellGeometry<F>::place_left(dcel::VertexId v, BranchId branch) const {
  const dcel::HalfedgeId start = cells()[v].out;
  if (start.is_none()) return {{v, dcel::HalfedgeId()}, {}};
  if (!cells().is_real(v)) return place_right(v, branch);
  const Point& p = arrangement_.point(v);
  dcel::HalfedgeId above;
  dcel::HalfedgeId lowest;
  dcel::HalfedgeId highest_right;
  dcel::HalfedgeId h = start;
  do {
    if (!h.is_forward()) {
      const BranchId other = arrangement_.branch(h.edge());
      const Sign order = family().compare_left(branch, other, p);
      if (order == Sign::zero) return {{}, h.edge()};
      const auto is_below_edge = [&](dcel::HalfedgeId than) {
        return than.is_none() || family().compare_left(other, arrangement_.branch(than.edge()), p) == Sign::negative;
      };
      if (is_below_edge(lowest)) lowest = h;
      if (order == Sign::negative && is_below_edge(above)) above = h;
    } else if (highest_right.is_none() ||
               family().compare_right(arrangement_.branch(h.edge()), arrangement_.branch(highest_right.edge()), p) ==
                   Sign::positive) {
      highest_right = h;
    }
    h = cells().counterclockwise(h);
  } while (h != start);
  if (above.is_none()) above = highest_right.is_none() ? lowest : highest_right;
  return {after(v, above), {}};
}

template <CurveFamily F>
bool CellGeometry<F>::bottom_edge_spans(dcel::HalfedgeId h, const Point& p) const {
  if (!h.is_forward()) return false;
  const dcel::VertexId from = cells().origin(h);
  const dcel::VertexId to = cells().target(h);
  if (is_corner(from) ? from != first_corner() : family().side(arrangement_.point(from)) != Side::bottom) return false;
  return (is_corner(from) || is_before(arrangement_.point(from), p)) &&
         (is_corner(to) || is_before(p, arrangement_.point(to)));
}

template <CurveFamily F>
dcel::VertexId CellGeometry<F>::first_corner() const {
  dcel::VertexId first;
  std::size_t corners = 0;
  for (std::size_t i = cells().vertices.size(); i-- > 0 && corners < 4;) {
    if (!is_corner(dcel::VertexId(i))) continue;
    first = dcel::VertexId(i);
    ++corners;
  }
  return first;
}

/// Past the curve that ends at its target, if one does.
template <CurveFamily F>
dcel::HalfedgeId CellGeometry<F>::next_on_frame(dcel::HalfedgeId h) const {
  dcel::HalfedgeId next = h.twin();
  do {
    next = cells().clockwise(next);
  } while (cells().is_real(next.edge()) || !next.is_forward());
  return next;
}

/// Counterclockwise from the bottom left corner: along the bottom and up the right side in the order of points, then
/// against it.
template <CurveFamily F>
typename CellGeometry<F>::FramePlace CellGeometry<F>::frame_place(const Point& end) const {
  const auto turn = [](Side side) {
    return side == Side::bottom ? 0 : side == Side::right ? 1 : side == Side::top ? 2 : 3;
  };
  const int wanted = turn(family().side(end));
  const dcel::VertexId corner = first_corner();
  int side = 0;
  dcel::HalfedgeId h = cells()[corner].out;
  while (cells().is_real(h.edge()) || !h.is_forward()) h = cells().clockwise(h);
  for (;;) {
    const dcel::VertexId to = cells().target(h);
    if (is_corner(to)) {
      if (side == wanted) return {h, dcel::VertexId()};
      ++side;
    } else if (side == wanted) {
      const Sign order = family().compare_xy(end, arrangement_.point(to));
      if (order == Sign::zero) return {h, to};
      if (order == (wanted < 2 ? Sign::negative : Sign::positive)) return {h, dcel::VertexId()};
    }
    if (side > 3) throw InternalError("frame at infinity: no place for an end");
    h = next_on_frame(h);
  }
}

}  // namespace quoin
