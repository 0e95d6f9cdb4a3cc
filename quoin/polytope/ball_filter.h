// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/error_free.h"
#include "quoin/polytope/smallest_ball.h"

namespace quoin {

/// Looks for points outside of a ball in doubles, then in pairs of doubles, with certified bounds.
///
/// With a point s on the sphere about c, p is outside where (p - s).(p + s - 2 c) is positive. Coordinates are taken
/// times a power of two that makes the largest at most 1, so that nothing overflows; what that costs at the lower end
/// is below the constants of the bounds. u = 2^-53.
class BallFilter {
 public:
  /// All points finite. @throws Cancelled
  BallFilter(std::span<const Point3> points, const Context& context);
  /// Of rationals, by the nearest doubles after scaling: of any size. What these leave open is not asked in pairs.
  BallFilter(std::span<const RationalPoint3> points, const Context& context);

  static constexpr std::uint32_t nobody = 0xFFFFFFFFU;

  struct Outcome {
    std::uint32_t outside = nobody;        ///< a point that is certainly outside, roughly the furthest
    std::vector<std::uint32_t> open = {};  ///< if there is none: those that may be outside
  };
  /// Of a ball whose center is in the box of the points. O(n). @throws Cancelled
  Outcome find_outside(const SmallestBall& ball, const Context& context) const;

 private:
  struct Sphere {
    Point3 on;
    std::array<TwoDoubles, 3> center;
  };
  Sphere sphere_of(const SmallestBall& ball) const;
  Outcome in_doubles(const Sphere& sphere, const Context& context) const;
  Outcome in_pairs(const Sphere& sphere, const std::vector<std::uint32_t>& candidates, const Context& context) const;

  std::vector<Point3> points_;
  int exponent_ = 0;          // of the power of two
  bool are_rounded_ = false;  // the points
};

}  // namespace quoin
