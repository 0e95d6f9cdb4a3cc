// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/predicate_filters.h"
#include "quoin/kernel/tier.h"

namespace quoin {

namespace detail {

Sign exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d, Tier& tier);
Sign orientation_of_any_size(const Point3& a, const Point3& b, const Point3& c, const Point3& d, Tier& tier);
Sign exact_in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e, Tier& tier);

}  // namespace detail

/// Side of the plane through a, b, c, seen counterclockwise from its positive side, on which d lies.
///
/// Positive exactly when det(b - a, c - a, d - a) > 0. Exact for all finite doubles: filters (bounds derived in
/// predicate_filters.h; six times a volume below 2^-45 passes two of them), then integers on the grid of the call.
/// Properties, each a test:
///   - swapping two arguments negates the sign;
///   - zero if and only if the four points lie in one plane;
///   - scaling by a power of two and translation, where exact, keep it.
/// O(1), allocates only for coordinates that span more than 124 bits. Source: Shewchuk 1997, section 4.
inline Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d, Tier& tier) {
  tier = Tier::filter;
  const int sign = filter::orientation_of_size(a, b, c, d);
  return sign != 0 ? static_cast<Sign>(sign) : detail::orientation_of_any_size(a, b, c, d, tier);
}
inline Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  Tier ignored;
  return orientation(a, b, c, d, ignored);
}

/// Side of the sphere through a, b, c, d on which e lies: positive inside if orientation(a, b, c, d) is positive.
///
/// Minus the sign of the determinant of rows (x, y, z, x^2 + y^2 + z^2) of a - e, ..., d - e. Exact for all finite
/// doubles: filter (bound derived in predicate_filters.h), then integers on the grid of the call. Properties, each a
/// test:
///   - swapping two arguments negates the sign;
///   - zero if and only if the five points lie on one sphere or plane, or four of them on one circle or line, or two
///     are equal;
///   - scaling by a power of two and translation, where exact, keep it.
/// O(1), allocation as above. Source: Shewchuk 1997, section 4.
inline Sign in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e, Tier& tier) {
  tier = Tier::filter;
  const int sign = filter::in_sphere(a, b, c, d, e);
  return sign != 0 ? static_cast<Sign>(sign) : detail::exact_in_sphere(a, b, c, d, e, tier);
}
inline Sign in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  Tier ignored;
  return in_sphere(a, b, c, d, e, ignored);
}

}  // namespace quoin
