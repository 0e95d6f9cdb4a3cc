// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/location/outer_faces.h"

namespace quoin {

/// Point location by looking at every cell. Nothing is stored; the oracle of the other locators. O(size) a query.
template <CurveFamily F>
class NaiveLocator {
 public:
  using Point = typename F::Point;

  explicit NaiveLocator(const Arrangement<F>& arrangement) : arrangement_(&arrangement) {}

  Location locate(const Point& query) const {
    const Arrangement<F>& a = *arrangement_;
    const F& family = a.family();
    if (is_pole(family, query)) return OuterFaces<F>(a).pole(a, family.side(query));
    const Point p = left_copy_of(family, query);
    for (std::size_t i = 0; i < a.vertex_count(); ++i) {
      const dcel::VertexId v(i);
      if (!is_point_vertex(a, v) || !a.cells().is_real(v)) continue;
      if (family.compare_xy(p, a.point(v)) == Sign::zero) return v;
    }
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const dcel::EdgeId e(i);
      if (a.cells().is_real(e) && spans(a, e, p) && family.compare_y_at_x(p, a.branch(e)) == Sign::zero) return e;
    }
    const dcel::EdgeId below = next_edge(p, Direction::down);
    return below.is_none() ? OuterFaces<F>(a).bottom(a, p) : face_above(a, below);
  }

  /// See RayShooter.
  Location shoot(const Point& p, Direction direction) const requires VerticalFamily<F> {
    const Arrangement<F>& a = *arrangement_;
    const dcel::EdgeId edge = next_edge(p, direction);
    const dcel::VertexId vertex = next_vertex(p, direction);
    if (!edge.is_none() || !vertex.is_none()) return first_met(a, direction, edge, vertex);
    const OuterFaces<F> outer(a);
    return direction == Direction::down ? outer.bottom(a, p) : outer.top(a, p);
  }

  /// The edge that a leaning line meets next above or below p; edges through p do not count.
  dcel::EdgeId next_edge(const Point& p, Direction direction) const {
    const Arrangement<F>& a = *arrangement_;
    const Sign wanted = direction == Direction::down ? Sign::positive : Sign::negative;
    dcel::EdgeId best;
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const dcel::EdgeId e(i);
      if (!a.cells().is_real(e) || !spans(a, e, p)) continue;
      if (a.family().compare_y_at_x(p, a.branch(e)) != wanted) continue;
      if (best.is_none() || order_of_edges(a, e, best) == wanted) best = e;
    }
    return best;
  }

  /// The next real vertex straight above or below p.
  dcel::VertexId next_vertex(const Point& p, Direction direction) const requires VerticalFamily<F> {
    const Arrangement<F>& a = *arrangement_;
    const Sign wanted = direction == Direction::down ? Sign::negative : Sign::positive;
    dcel::VertexId best;
    for (std::size_t i = 0; i < a.vertex_count(); ++i) {
      const dcel::VertexId v(i);
      if (!is_point_vertex(a, v) || !a.cells().is_real(v)) continue;
      if (a.family().compare_x(a.point(v), p) != Sign::zero) continue;
      if (a.family().compare_xy(a.point(v), p) != wanted) continue;
      if (best.is_none() || a.family().compare_xy(a.point(best), a.point(v)) == wanted) best = v;
    }
    return best;
  }

  static constexpr bool is_stale() { return false; }
  void mark_stale() {}
  void rebuild(const Context&) {}

 private:
  const Arrangement<F>* arrangement_;
};

}  // namespace quoin
