// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/location/naive_locator.h"

namespace quoin {

/// Point location without a search structure: along the vertical line through the query, from the face at its end to
/// the query, from face to face.
///
/// Stores only the edges that reach the bottom and the top side. A query looks at all boundaries of the faces that the
/// line passes before the point: linear in the zone of the line. In every face it goes on across the edge nearest to
/// the point, so that no face is entered twice.
template <CurveFamily F>
class WalkLocator {
 public:
  using Point = typename F::Point;

  explicit WalkLocator(const Arrangement<F>& arrangement) : arrangement_(&arrangement), outer_(arrangement) {}

  Location locate(const Point& query) const {
    const Arrangement<F>& a = *arrangement_;
    if (is_stale_) return NaiveLocator<F>(a).locate(query);
    if (is_pole(a.family(), query)) return outer_.pole(a, a.family().side(query));
    return walk(left_copy_of(a.family(), query), Direction::down).found;
  }

  /// See RayShooter.
  Location shoot(const Point& p, Direction direction) const requires VerticalFamily<F> {
    const Arrangement<F>& a = *arrangement_;
    if (is_stale_) return NaiveLocator<F>(a).shoot(p, direction);
    const Arrival arrival = walk(p, direction);
    const dcel::VertexId vertex = nearest_vertex(arrival.face, p, direction);
    if (arrival.edge.is_none() && vertex.is_none()) return arrival.face;
    return first_met(a, direction, arrival.edge, vertex);
  }

  bool is_stale() const { return is_stale_; }
  void mark_stale() { is_stale_ = true; }
  void rebuild(const Context&) {
    outer_ = OuterFaces<F>(*arrangement_);
    is_stale_ = false;
  }

 private:
  struct Arrival {
    dcel::FaceId face;  // just below the point, or just above it
    dcel::EdgeId edge;  // the next edge below or above
    Location found;     // the cell of the point
  };

  /// Calls `visit` with every halfedge of the boundaries of a face.
  template <class Visit>
  void for_each_halfedge(dcel::FaceId face, const Visit& visit) const {
    const dcel::Dcel& cells = arrangement_->cells();
    for (dcel::BoundaryId b = cells[face].first_boundary; !b.is_none(); b = cells[b].next) {
      const dcel::HalfedgeId first = cells[b].halfedge;
      if (first.is_none()) continue;
      dcel::HalfedgeId h = first;
      do {
        visit(h);
        h = cells.next(h);
      } while (h != first);
    }
  }
  template <class Visit>
  void for_each_isolated(dcel::FaceId face, const Visit& visit) const {
    const dcel::Dcel& cells = arrangement_->cells();
    for (dcel::VertexId v = cells[face].first_isolated; !v.is_none(); v = cells[v].next_isolated) visit(v);
  }

  Arrival walk(const Point& p, Direction direction) const {
    const Arrangement<F>& a = *arrangement_;
    const bool is_down = direction == Direction::down;
    Arrival arrival;
    arrival.face = is_down ? outer_.bottom(a, p) : outer_.top(a, p);
    for (;;) {
      const dcel::EdgeId nearest = nearest_edge(arrival, p, direction);
      if (nearest.is_none()) break;
      arrival.edge = nearest;
      const dcel::FaceId next = is_down ? face_above(a, nearest) : face_below(a, nearest);
      if (next == arrival.face) break;
      arrival.face = next;
    }
    if (arrival.found.index() != dcel::FaceId::none_value) return arrival;
    for_each_isolated(arrival.face, [&](dcel::VertexId v) {
      if (a.has_point(v) && a.family().compare_xy(a.point(v), p) == Sign::zero) arrival.found = v;
    });
    if (arrival.found.index() == dcel::FaceId::none_value) arrival.found = arrival.face;
    return arrival;
  }

  /// Of the edges around a face, the one nearest to the point; remembers where the point lies on the boundary.
  dcel::EdgeId nearest_edge(Arrival& arrival, const Point& p, Direction direction) const {
    const Arrangement<F>& a = *arrangement_;
    const F& family = a.family();
    const Sign wanted = direction == Direction::down ? Sign::positive : Sign::negative;
    dcel::EdgeId best;
    for_each_halfedge(arrival.face, [&](dcel::HalfedgeId h) {
      const dcel::EdgeId e = h.edge();
      if (!a.cells().is_real(e)) return;
      const dcel::VertexId v = a.cells().origin(h);
      if (family.compare_xy(p, a.point(v)) == Sign::zero) arrival.found = v;
      if (e == best || !spans(a, e, p)) return;
      const Sign side = family.compare_y_at_x(p, a.branch(e));
      if (side == Sign::zero) arrival.found = e;
      if (side == wanted && (best.is_none() || order_of_edges(a, e, best) == wanted)) best = e;
    });
    return best;
  }

  /// The nearest real vertex of a face straight above or below the point.
  dcel::VertexId nearest_vertex(dcel::FaceId face, const Point& p,
                                Direction direction) const requires VerticalFamily<F> {
    const Arrangement<F>& a = *arrangement_;
    const Sign wanted = direction == Direction::down ? Sign::negative : Sign::positive;
    dcel::VertexId best;
    const auto consider = [&](dcel::VertexId v) {
      if (!a.has_point(v) || !a.cells().is_real(v) || a.family().compare_x(a.point(v), p) != Sign::zero) return;
      if (a.family().compare_xy(a.point(v), p) != wanted) return;
      if (best.is_none() || a.family().compare_xy(a.point(best), a.point(v)) == wanted) best = v;
    };
    for_each_halfedge(face, [&](dcel::HalfedgeId h) { consider(a.cells().origin(h)); });
    for_each_isolated(face, consider);
    return best;
  }

  const Arrangement<F>* arrangement_;
  OuterFaces<F> outer_;
  bool is_stale_ = false;
};

}  // namespace quoin
