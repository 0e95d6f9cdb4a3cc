// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Vertices of the convex hull of finite points of the plane, counterclockwise from the lexicographically smallest one;
/// of equal points the first. One if all points are equal, the two ends if they are on a line. O(n log n).
std::vector<std::uint32_t> planar_hull(std::span<const Point2> points, const Context& context);

}  // namespace quoin
