// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/polytope/smallest_ball.h"

namespace quoin::ball_basis {

/// The ball whose only support is one point.
SmallestBall of_point(std::span<const Point3> points, std::uint32_t only);

/// The smallest ball of the support of a ball and of a point outside of it; its support is some of them, the point
/// among them. Exact, O(1).
SmallestBall grown(std::span<const Point3> points, const SmallestBall& ball, std::uint32_t outside);

/// Whether a point is outside of a ball. Exact.
bool is_outside(const SmallestBall& ball, const Point3& support, const Point3& p);

}  // namespace quoin::ball_basis
