// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "quoin/base/sign.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// A point with a weight, the square of a radius (or less than nothing).
struct WeightedPoint2 {
  Point2 point;
  double weight = 0;
};

/// Side of the power circle of a, b, c: positive if d, lifted to x^2 + y^2 - weight, lies below the plane through the
/// lifted others and a, b, c turn counterclockwise. in_circle where all weights are equal. Exact for all finite
/// doubles: a filter, then rationals. Swapping two arguments negates it.
Sign in_power_circle(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                     const WeightedPoint2& d);

/// The same on a line: whether d, lifted, lies below the line through lifted a and b; all three are collinear and
/// distinct. Symmetric in a and b.
Sign in_power_segment(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& d);

/// What the insertion asks about weighted points, which may hide each other. Ties are decided by an infinitesimal lift,
/// larger for lexicographically larger points. Of points at one place the heavier is below the lighter. The point of
/// the infinite vertex is not looked at.
class RegularPredicates2 {
 public:
  static constexpr bool may_hide = true;
  using Query = WeightedPoint2;

  /// `points` ends with the infinite one.
  explicit RegularPredicates2(std::span<const WeightedPoint2> points)
      : RegularPredicates2(points, Vertex2(points.size() - 1)) {}
  RegularPredicates2(std::span<const WeightedPoint2> points, Vertex2 infinite)
      : points_(points), infinite_(infinite.value) {}

  const WeightedPoint2& point(std::uint32_t v) const { return points_[v]; }
  Sign turn(std::uint32_t a, std::uint32_t b, const WeightedPoint2& p) const {
    return orientation(points_[a].point, points_[b].point, p.point);
  }
  bool in_conflict(const TriangleLinks2& t, const WeightedPoint2& d) const;

 private:
  std::span<const WeightedPoint2> points_;
  std::uint32_t infinite_;
};

/// Whether the middle of three collinear points, distinct and in order, is a vertex of their regular triangulation.
bool is_seen_between(const WeightedPoint2& before, const WeightedPoint2& middle, const WeightedPoint2& after);

}  // namespace quoin
