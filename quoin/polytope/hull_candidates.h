// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/hull_simplex.h"

namespace quoin {

/// The points that may be corners of the hull, ascending: all but those that are surely inside the hull of a part of
/// them, where such are many. The simplex is of four affinely independent points; no coordinate is larger in magnitude
/// than `largest`. O(n).
/// @throws Cancelled
std::vector<std::uint32_t> hull_candidates(std::span<const Point3> points, double largest, const Simplex& simplex,
                                           const Context& context);

}  // namespace quoin
