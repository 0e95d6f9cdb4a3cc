// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/kernel/constructions.h"

namespace quoin {

/// A point strictly inside a planar polygon with holes and slits, rational. O(n) rational operations.
///
/// Loops in any order. Projected along `axis` the polygon has a nonzero area, and loops have it on their
/// left where `orientation` is positive, else on their right. @throws InternalError  the loop has no convex corner
RationalPoint3 interior_point(const Constructions& table, std::span<const std::span<const PointId>> loops,
                              unsigned axis, Sign orientation);

}  // namespace quoin
