// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// The rule for cocircular points (tie_rule2.h): d, in the circle of a, b, c if the lexicographically largest of the
/// four is lifted a little. Not if d is the largest; if a is, exactly when d is on a's side of the line through b and
/// c.
bool is_in_circle_by_tie(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// The largest unit 2^k of which all coordinates are multiples, if it is of use to predicates: at most 2^40 times are
/// the largest, and fourth powers of it are doubles. O(n), less if there is none.
std::optional<int> grid_unit(std::span<const Point2> points, const Context& context);

/// What the insertion asks about points of a Delaunay triangulation: turns, and whether a point is in the circle of a
/// triangle.
///
/// Exact for all finite doubles: filters inline; where all points lie on a grid, a double whose parts stay below 2^53
/// units is the value itself; then the exact tiers of predicates2.h. Cocircular points are decided as if each were
/// lifted by an infinitesimal, far larger for lexicographically larger points: so there is one triangulation, a
/// function of the set of points (Devillers and Teillaud 2011).
///
/// The point at the index of the infinite vertex must be (NaN, NaN): filters never decide about it, so the ordinary
/// case need not ask whether a triangle is infinite.
class DelaunayPredicates2 {
 public:
  static constexpr bool may_hide = false;
  using Query = Point2;

  /// Point views stay the caller's; `points` ends with the infinite one. O(n), less if no grid is found.
  DelaunayPredicates2(std::span<const Point2> points, const Context& context);
  /// The same with another infinite vertex, without a search for a grid. O(1).
  DelaunayPredicates2(std::span<const Point2> points, Vertex2 infinite) : points_(points), infinite_(infinite.value) {}

  const Point2& point(std::uint32_t v) const { return points_[v]; }

  /// Side of the circle through three finite vertices on which a fourth lies, without the rule for ties: the same as
  /// in_circle of the points, fast on grids.
  Sign circle_side(const std::array<Vertex2, 3>& t, Vertex2 d) const;

  /// Turn of two finite vertices and a point. The error of a cross product is that of filter::cross.
  Sign turn(std::uint32_t a, std::uint32_t b, const Point2& p) const {
    const Point2& pa = points_[a];
    const Point2& pb = points_[b];
    const double left = (pb.x - pa.x) * (p.y - pa.y);
    const double right = (pb.y - pa.y) * (p.x - pa.x);
    const double value = left - right;
    const double size = std::fabs(left) + std::fabs(right);
    if (std::fabs(value) > 4.45e-16 * size + 0x1p-1000) [[likely]]
      return value > 0 ? Sign::positive : Sign::negative;
    if (size < turn_exact_below_) return sign_of(value);
    return orientation(pa, pb, p);
  }

  /// Whether the point is in the open circle of the triangle; of an infinite one, in the open half-plane beyond its
  /// edge, or in the edge.
  ///
  /// The filter is that of filter::in_circle with the sum S of the three lifts in the place of the maxima: XY <= M^2 <=
  /// S (1 + u), so the error is at most 1.43e-14 S^2; where 8 S^2 is finite, all parts are. Underflow: 2^-1075 in each
  /// of 12 products times lifts or minors, at most 2^-1070 (1 + S) < 2^-1000 + 1e-16 S^2. On a grid of unit g, all
  /// parts are multiples of g^2 or g^4 of at most 12 S^2, exact below 2^53 g^4: for S < 2^24 g^2.
  bool in_conflict(const TriangleLinks2& t, const Point2& d) const {
    const Point2& a = points_[t.corner[0]];
    const Point2& b = points_[t.corner[1]];
    const Point2& c = points_[t.corner[2]];
    const double ax = a.x - d.x;
    const double ay = a.y - d.y;
    const double bx = b.x - d.x;
    const double by = b.y - d.y;
    const double cx = c.x - d.x;
    const double cy = c.y - d.y;
    const double la = ax * ax + ay * ay;
    const double lb = bx * bx + by * by;
    const double lc = cx * cx + cy * cy;
    const double bc = bx * cy - by * cx;
    const double ca = cx * ay - cy * ax;
    const double ab = ax * by - ay * bx;
    const double value = la * bc + lb * ca + lc * ab;
    const double size = la + lb + lc;
    if (std::fabs(value) > 8 * size * size * (1.5e-14 / 8) + 0x1p-1000) [[likely]]
      return value > 0;
    if (size < circle_exact_below_) {
      if (value != 0) return value > 0;
      return is_tie_in({place(ax, ay), place(bx, by), place(cx, cy)}, {bc, ca, ab});
    }
    return decide_slowly(t, d);
  }

 private:
  /// Coordinates below 2^12 units in lexicographic order, as one number; d is at 0.
  static double place(double x, double y) { return 0x1p14 * x + y; }
  /// is_in_circle_by_tie with the turns of d and two corners, exact.
  static bool is_tie_in(const std::array<double, 3>& places, const std::array<double, 3>& turns) {
    double largest = places[0];
    double turn = turns[0];
    for (const unsigned k : {1U, 2U}) {
      const bool is_larger = places[k] > largest;
      largest = is_larger ? places[k] : largest;
      turn = is_larger ? turns[k] : turn;
    }
    return (largest > 0) & (turn > 0);
  }
  bool decide_slowly(const TriangleLinks2& t, const Point2& d) const;

  std::span<const Point2> points_;
  std::uint32_t infinite_;
  double turn_exact_below_ = 0;
  double circle_exact_below_ = 0;
};

}  // namespace quoin
