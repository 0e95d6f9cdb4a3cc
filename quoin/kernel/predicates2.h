// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/predicate_filters.h"
#include "quoin/kernel/tier.h"

namespace quoin {

namespace detail {

Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c, Tier& tier);
Sign exact_in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d, Tier& tier);

}  // namespace detail

/// Turn of a, b, c: positive when counterclockwise, that is det(b - a, c - a) > 0.
///
/// Exact for all finite doubles: filter (bound derived in constructions_filters.h), then exact products where the
/// differences are exact, then integers on the grid of the call. Properties, each a test:
///   - swapping two arguments negates the sign;
///   - zero if and only if the three points lie on one line;
///   - scaling by a power of two and translation, where exact, keep it.
/// O(1), allocates only for coordinates that span more than 124 bits. Source: Shewchuk 1997, section 4.
inline Sign orientation(const Point2& a, const Point2& b, const Point2& c, Tier& tier) {
  tier = Tier::filter;
  const int sign = filter::orientation(a, b, c);
  return sign != 0 ? static_cast<Sign>(sign) : detail::exact_orientation(a, b, c, tier);
}
inline Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
  Tier ignored;
  return orientation(a, b, c, ignored);
}

/// Side of the circle through a, b, c on which d lies: positive inside if a, b, c turn counterclockwise.
///
/// The sign of the determinant of rows (x, y, x^2 + y^2) of a - d, b - d, c - d. Exact for all finite doubles: filter
/// (bound derived in predicate_filters.h), then integers on the grid of the call. Properties, each a test:
///   - swapping two arguments negates the sign;
///   - zero if and only if the four points lie on one circle or line, or two are equal;
///   - scaling by a power of two and translation, where exact, keep it.
/// O(1), allocation as above. Source: Shewchuk 1997, section 4.
inline Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d, Tier& tier) {
  tier = Tier::filter;
  const int sign = filter::in_circle(a, b, c, d);
  return sign != 0 ? static_cast<Sign>(sign) : detail::exact_in_circle(a, b, c, d, tier);
}
inline Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  Tier ignored;
  return in_circle(a, b, c, d, ignored);
}

}  // namespace quoin
