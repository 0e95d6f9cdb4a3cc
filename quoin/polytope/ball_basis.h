// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/polytope/smallest_ball.h"

namespace quoin::ball_basis {

// Of points that are doubles or rationals.

/// The ball whose only support is one point.
template <class Point>
SmallestBall of_point(std::span<const Point> points, std::uint32_t only);

/// The smallest ball of the support of a ball and of a point outside of it; its support is some of them, the point
/// among them. Exact, O(1).
template <class Point>
SmallestBall grown(std::span<const Point> points, const SmallestBall& ball, std::uint32_t outside);

/// By how much the squared distance of a point from the center exceeds the squared radius: positive outside. Exact.
template <class Point>
Rational height(const SmallestBall& ball, const Point& support, const Point& p);

}  // namespace quoin::ball_basis
