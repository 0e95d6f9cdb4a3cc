// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "quoin/arrangement/location/naive_locator.h"
#include "quoin/arrangement/location/trapezoid_map.h"

namespace quoin {

/// Point location and vertical rays by a trapezoidal map: expected O(log n) a query for any arrangement on any surface,
/// expected O(n log n) to build, about 250 bytes an edge.
///
/// The map is drawn from the seed of the context, and drawn anew while its longest path is far above what is expected.
template <CurveFamily F>
class TrapezoidLocator {
 public:
  using Point = typename F::Point;

  /// @throws Cancelled
  explicit TrapezoidLocator(const Arrangement<F>& arrangement, const Context& context = Context())
      : arrangement_(&arrangement), outer_(arrangement) {
    rebuild(context);
  }

  Location locate(const Point& p) const;
  /// See RayShooter. A template, so that families without vertical rays can be instantiated.
  template <class G = F>
  requires VerticalFamily<G> Location shoot(const Point& p, Direction direction)
  const {
    const Arrangement<G>& a = *arrangement_;
    if (is_stale_) return NaiveLocator<G>(a).shoot(p, direction);
    const Ahead ahead = look(p, direction);
    const bool is_straight = !ahead.vertex.is_none() && a.cells().is_real(ahead.vertex) &&
                             a.family().compare_x(a.point(ahead.vertex), p) == Sign::zero;
    const dcel::VertexId vertex = is_straight ? ahead.vertex : dcel::VertexId();
    if (!ahead.edge.is_none() || is_straight) return first_met(a, direction, ahead.edge, vertex);
    return direction == Direction::up ? outer_.top(a, p) : outer_.bottom(a, p);
  }

  bool is_stale() const { return is_stale_; }
  void mark_stale() { is_stale_ = true; }
  /// @throws Cancelled
  void rebuild(const Context& context);

  /// Longest path from the root to a leaf.
  std::size_t depth() const { return map_.depth; }
  std::size_t trapezoid_count() const { return map_.trapezoids.size(); }
  std::size_t node_count() const { return map_.nodes.size(); }
  /// Nodes on the path of one query.
  std::size_t steps(const Point& p) const;

 private:
  /// A point as queries see it: comparisons of keys decide where they differ by more than the margin.
  struct Query {
    const Point& point;
    double key;
    double margin;
  };
  struct Ahead {
    dcel::EdgeId edge;      // next on the leaning line
    dcel::VertexId vertex;  // on the wall that follows
  };
  Ahead look(const Point& p, Direction direction) const;
  Query prepare(const Point& p) const;
  Sign compare(const Query& query, const SearchNode& node) const;
  std::uint32_t descend(const Query& query, Direction direction) const;
  dcel::FaceId face_of(const Trapezoid& trapezoid) const;
  dcel::EdgeId edge_id(std::uint32_t edge) const {
    return edge == Trapezoid::none ? dcel::EdgeId() : edges_.edges[edge].id;
  }

  const Arrangement<F>* arrangement_;
  OuterFaces<F> outer_;
  RankedEdges<Point> edges_;
  TrapezoidMap map_;
  std::vector<dcel::FaceId> faces_;  // of trapezoids
  bool is_stale_ = false;
};

}  // namespace quoin
