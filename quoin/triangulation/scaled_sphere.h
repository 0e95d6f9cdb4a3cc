// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "quoin/kernel/point.h"

namespace quoin::detail {

/// The sphere test of predicates3.h for points whose coordinates times `scale`, a power of two far from underflow, as
/// is its inverse `unit`, are integers of magnitude at most 2^61, as are their differences from those of the last
/// point, but for 2^61 itself: true, and the sign; else false. Quicker than the grid of the call, which has to be
/// found.
bool in_sphere_of_integers(const std::array<const Point3*, 5>& points, double scale, double unit, int& sign);

}  // namespace quoin::detail
