// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Turn of a, b, c: positive when counterclockwise, that is det(b - a, c - a) > 0.
///
/// Exact for all finite doubles: filter, then exact products where the differences are exact, then rationals.
/// Properties, each a test:
///   - swapping two arguments negates the sign;
///   - zero if and only if the three points lie on one line;
///   - scaling by a power of two that neither over- nor underflows keeps it.
/// O(1). Source: the filter is Shewchuk 1997, section 4, with its bound derived in predicates2.cc.
Sign orientation(const Point2& a, const Point2& b, const Point2& c);

/// Order of points by x, then y.
constexpr bool lexicographically_less(const Point2& a, const Point2& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

}  // namespace quoin
