// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/cell_geometry.h"
#include "quoin/arrangement/edit/zone.h"
#include "quoin/arrangement/location/naive_locator.h"
#include "quoin/base/error.h"

/// Bodies of the zone, for the one source file per family that instantiates it.
namespace quoin {

/// The walk along one piece.
template <CurveFamily F>
class ZoneWalk {
 public:
  using Point = typename F::Point;
  using Step = ZoneStep<Point>;

  ZoneWalk(const Arrangement<F>& arrangement, const ZonePiece<Point>& piece)
      : arrangement_(arrangement), family_(arrangement.family()), geometry_(arrangement), piece_(piece) {}

  Location first_cell(const ZoneLocator<Point>& locate) const;
  /// The part of the piece that begins at a point in a cell.
  Step next(const Point& from, const Location& cell);

 private:
  bool is_before(const Point& p, const Point& q) const { return family_.compare_xy(p, q) == Sign::negative; }
  bool is_on(const Point& p, BranchId b) const { return family_.compare_y_at_x(p, b) == Sign::zero; }
  void go_along(dcel::EdgeId e);
  void go_through(dcel::FaceId face);
  void meet_edge(dcel::EdgeId e);
  void meet_isolated(dcel::VertexId v);
  bool is_below_just_right(dcel::EdgeId e, Sign starts_later, bool& overlaps) const;
  void offer(const Point& p, const Location& cell);

  const Arrangement<F>& arrangement_;
  const F& family_;
  CellGeometry<F> geometry_;
  const ZonePiece<Point>& piece_;
  Step step_;
};

template <CurveFamily F>
Location ZoneWalk<F>::first_cell(const ZoneLocator<Point>& locate) const {
  if (family_.side(piece_.left) == Side::interior) {
    return locate ? locate(piece_.left) : NaiveLocator<F>(arrangement_).locate(piece_.left);
  }
  if (!geometry_.first_corner().is_none()) {
    const auto place = geometry_.frame_place(piece_.left);
    if (!place.vertex.is_none()) return place.vertex;
    return arrangement_.cells().face(place.edge);
  }
  return arrangement_.cells().base_face;
}

template <CurveFamily F>
typename ZoneWalk<F>::Step ZoneWalk<F>::next(const Point& from, const Location& cell) {
  step_ = {from, piece_.right, cell, cell, {}, {}};
  if (cell.is_face()) {
    go_through(cell.face());
  } else if (cell.is_edge()) {
    const dcel::EdgeId edge = cell.edge();
    const Sign order = family_.compare_right(piece_.branch, arrangement_.branch(edge), from);
    if (order == Sign::zero) {
      go_along(edge);
    } else {
      go_through(arrangement_.cells().face(dcel::HalfedgeId(edge, order == Sign::negative)));
    }
  } else {
    const RingSearch found = geometry_.place_right(cell.vertex(), piece_.branch);
    if (!found.overlapped.is_none()) {
      go_along(found.overlapped);
    } else if (found.place.arriving.is_none()) {
      go_through(arrangement_.cells()[found.place.vertex].face);
    } else {
      go_through(arrangement_.cells().face(found.place.arriving));
    }
  }
  return step_;
}

template <CurveFamily F>
void ZoneWalk<F>::go_along(dcel::EdgeId e) {
  step_.overlapped = e;
  const Point& end = arrangement_.right_point(e);
  if (is_before(piece_.right, end)) {
    step_.at_right = e;
  } else {
    step_.right = end;
    step_.at_right = arrangement_.right(e);
  }
}

template <CurveFamily F>
void ZoneWalk<F>::go_through(dcel::FaceId face) {
  step_.face = face;
  step_.at_right = face;
  const dcel::Dcel& cells = arrangement_.cells();
  for (dcel::BoundaryId b = cells[face].first_boundary; !b.is_none(); b = cells[b].next) {
    const dcel::HalfedgeId start = cells[b].halfedge;
    dcel::HalfedgeId h = start;
    do {
      const bool is_second_side = !h.is_forward() && cells[h.twin()].boundary == b;
      if (cells.is_real(h.edge()) && !is_second_side) meet_edge(h.edge());
      h = cells.next(h);
    } while (h != start);
  }
  for (dcel::VertexId v = cells[face].first_isolated; !v.is_none(); v = cells[v].next_isolated) meet_isolated(v);
}

/// Keeps the first point; at equal points a vertex, or at the right end of the piece whatever is there.
template <CurveFamily F>
void ZoneWalk<F>::offer(const Point& p, const Location& cell) {
  const Sign order = family_.compare_xy(p, step_.right);
  if (order == Sign::positive) return;
  if (order == Sign::zero && !step_.at_right.is_face() && !cell.is_vertex()) {
    return;
  }
  step_.right = p;
  step_.at_right = cell;
}

template <CurveFamily F>
void ZoneWalk<F>::meet_isolated(dcel::VertexId v) {
  const Point& p = arrangement_.point(v);
  if (is_before(step_.left, p) && !is_before(piece_.right, p) && is_on(p, piece_.branch)) offer(p, v);
}

/// Whether the piece lies below the edge just right of where both have begun.
template <CurveFamily F>
bool ZoneWalk<F>::is_below_just_right(dcel::EdgeId e, Sign starts_later, bool& overlaps) const {
  const BranchId other = arrangement_.branch(e);
  Sign order = Sign::zero;
  if (starts_later == Sign::positive)
    return family_.compare_y_at_x(arrangement_.left_point(e), piece_.branch) == Sign::positive;
  if (starts_later == Sign::negative) order = family_.compare_y_at_x(step_.left, other);
  if (order == Sign::zero) order = family_.compare_right(piece_.branch, other, step_.left);
  overlaps = order == Sign::zero;
  return order == Sign::negative;
}

/// The first point of an edge, right of the step's left end, that lies on the piece.
template <CurveFamily F>
void ZoneWalk<F>::meet_edge(dcel::EdgeId e) {
  const Point& start = arrangement_.left_point(e);
  const Point& end = arrangement_.right_point(e);
  if (!is_before(step_.left, end) || is_before(step_.right, start)) return;
  const Sign starts_later = family_.compare_xy(start, step_.left);
  if (starts_later == Sign::positive && is_on(start, piece_.branch)) {
    offer(start, arrangement_.left(e));
    return;
  }
  if (!is_before(start, piece_.right)) return;
  bool overlaps = false;
  const bool is_below = is_below_just_right(e, starts_later, overlaps);
  if (overlaps) return;
  const BranchId other = arrangement_.branch(e);
  const Point& after = starts_later == Sign::positive ? start : step_.left;
  const Sign ends = family_.compare_xy(end, piece_.right);
  Point meeting;
  const bool meets = is_below ? family_.first_meeting(piece_.branch, piece_.right, other, end, after, meeting)
                              : family_.first_meeting(other, end, piece_.branch, piece_.right, after, meeting);
  if (meets && is_before(meeting, ends == Sign::positive ? piece_.right : end)) {
    offer(meeting, e);
    return;
  }
  if (ends != Sign::positive) {
    if (is_on(end, piece_.branch)) offer(end, arrangement_.right(e));
  } else if (is_on(piece_.right, other)) {
    offer(piece_.right, e);
  }
}

template <CurveFamily F>
void zone(const Arrangement<F>& arrangement, const ZonePiece<typename F::Point>& piece,
          ZoneVisitor<typename F::Point>& visitor, const ZoneLocator<typename F::Point>& locate) {
  if (!F::Surface::has_unbounded_face) throw InputError("zone: not supported on this surface");
  ZoneWalk<F> walk(arrangement, piece);
  typename F::Point from = piece.left;
  Location cell = walk.first_cell(locate);
  for (;;) {
    const auto step = walk.next(from, cell);
    const std::optional<Location> at = visitor.at_step(step);
    if (!at || arrangement.family().compare_xy(step.right, piece.right) == Sign::zero) return;
    cell = *at;
    from = step.right;
  }
}

template <CurveFamily F>
std::vector<ZoneStep<typename F::Point>> zone_steps(const Arrangement<F>& arrangement,
                                                    const ZonePiece<typename F::Point>& piece,
                                                    const ZoneLocator<typename F::Point>& locate) {
  using Step = ZoneStep<typename F::Point>;
  class Collector : public ZoneVisitor<typename F::Point> {
   public:
    std::optional<Location> at_step(const Step& step) override {
      steps.push_back(step);
      return step.at_right;
    }
    std::vector<Step> steps;
  } collector;
  zone(arrangement, piece, collector, locate);
  return std::move(collector.steps);
}

template <CurveFamily F>
bool meets_anything(const Arrangement<F>& arrangement, const ZonePiece<typename F::Point>& piece,
                    const ZoneLocator<typename F::Point>& locate) {
  class Tester : public ZoneVisitor<typename F::Point> {
   public:
    std::optional<Location> at_step(const ZoneStep<typename F::Point>& step) override {
      meets = !step.at_left.is_face() || !step.at_right.is_face();
      return std::nullopt;  // without a meeting there is one step only
    }
    bool meets = false;
  } tester;
  zone(arrangement, piece, tester, locate);
  return tester.meets;
}

}  // namespace quoin
