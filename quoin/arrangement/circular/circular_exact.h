// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/arrangement/circular/circular_support.h"
#include "quoin/base/sign.h"

/// Exact tier of `CircularFamily`: every coordinate is a number with one square root, and signs of those are found by
/// sums and products alone, in fixed-width integers where the operands of a call lie on a common grid, else in
/// rationals.
namespace quoin::circular_exact {

/// Which arithmetic answered, in calls of this thread since it started.
struct Counts {
  std::uint64_t narrow = 0;  ///< the grid of the call spans 25 bits
  std::uint64_t wide = 0;    ///< 60 bits
  std::uint64_t big = 0;     ///< more, or a rational is among the operands
};
const Counts& counts();

Sign compare_x(const CircularPools& pools, const CircularPoint& p, const CircularPoint& q);
Sign compare_y(const CircularPools& pools, const CircularPoint& p, const CircularPoint& q);

/// Sign of the y of p minus that of the centre of a circle.
Sign compare_y_to_centre(const CircularPools& pools, const CircularPoint& p, std::uint32_t circle);

/// Positive outside a circle, or left of a line.
Sign side(const CircularPools& pools, const CircularPoint& p, std::uint32_t support);

/// Sign of the cross product of the tangent of b at p and the tangent of a there, p on both: positive if a turns left
/// from b. Tangents run counterclockwise around a circle, in lexicographic order along a line.
Sign turn(const CircularPools& pools, const CircularPoint& p, std::uint32_t a, std::uint32_t b);

/// Where two supports meet, in doubles that are right up to their rounding: at `middle` plus and minus `half`.
struct Crossing {
  Sign discriminant = Sign::negative;  ///< negative: nowhere; zero: touching circles, or lines; positive: two points
  double middle_x = 0;                 ///< each within 16u of the largest coordinate or radius
  double middle_y = 0;
  double half_x = 0;  ///< lexicographically positive
  double half_y = 0;
  bool in_range = true;  ///< the doubles keep their promise
};
Crossing crossing(const CircularPools& pools, std::uint32_t a, std::uint32_t b);

/// Same circle or line.
bool same_support(const CircularPools& pools, std::uint32_t a, std::uint32_t b);

/// The coordinates of a point rounded, with a relative error of 2^-48 where they have no cancellation.
CircularPoint approximate(const CircularPools& pools, const CircularPoint& p);

/// The coordinates (ax + bx sqrt c) / d and (ay + by sqrt c) / d, d > 0, c >= 0.
struct IntegerPoint {
  Integer ax;
  Integer bx;
  Integer ay;
  Integer by;
  Integer c;
  Integer d;
};
IntegerPoint integers(const CircularPools& pools, const CircularPoint& p);

}  // namespace quoin::circular_exact
