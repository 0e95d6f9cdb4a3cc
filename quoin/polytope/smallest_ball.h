// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/rational.h"

namespace quoin {

/// The ball of least radius that holds all points: there is exactly one.
struct SmallestBall {
  RationalPoint3 center{};
  Rational squared_radius{0};
  /// Up to four of the points (two at least, unless all are equal), by their indices in ascending order: they lie on
  /// the sphere, their simplex has the center in its interior, and so no smaller ball holds them.
  std::vector<std::uint32_t> support{};
  std::size_t steps = 0;  ///< smaller balls of some of the points that came before it
};

/// Exact for all finite doubles, in any position: equal, collinear, coplanar and cospherical points are ordinary.
///
/// From ball to larger ball: the point furthest outside enters the support, until none is outside. Which side of the
/// sphere a point is on is decided in doubles, then in pairs of doubles, and in rationals where both leave it open; the
/// ball of a support and one more point is found in rationals. A step takes O(n). A few steps are mostly enough for any
/// number of points, as each takes the one furthest outside (where doubles decide, but for their rounding); that there
/// are finitely many is certain, as the radius grows.
/// Source: Welzl 1991 (bases); Gaertner 1999 (furthest points as pivots).
/// @throws InputError  there is no point, or one is not finite (names it); Cancelled
SmallestBall smallest_ball(std::span<const Point3> points, const Context& context);

/// Of rationals of any size, beyond the range of doubles too. Exact; where all are doubles, as fast as of these, else
/// what the nearest doubles do not tell is decided in rationals.
/// @throws InputError  there is no point; Cancelled
SmallestBall smallest_ball(std::span<const RationalPoint3> points, const Context& context);

}  // namespace quoin
