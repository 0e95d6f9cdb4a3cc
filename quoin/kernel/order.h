// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/tier.h"

/// Orders of explicit points; negative means that the first comes before the second.
namespace quoin {

/// By x, then y. Exact, no arithmetic; -0 equals +0. Zero if and only if the points are equal.
constexpr Sign compare_lexicographically(const Point2& p, const Point2& q) {
  if (p.x != q.x) return p.x < q.x ? Sign::negative : Sign::positive;
  return static_cast<Sign>((p.y > q.y) - (p.y < q.y));
}
/// By x, then y, then z.
constexpr Sign compare_lexicographically(const Point3& p, const Point3& q) {
  if (p.x != q.x) return p.x < q.x ? Sign::negative : Sign::positive;
  if (p.y != q.y) return p.y < q.y ? Sign::negative : Sign::positive;
  return static_cast<Sign>((p.z > q.z) - (p.z < q.z));
}

/// Along the direction d: the sign of d . (p - q).
///
/// Exact for all finite doubles: filter, expansions where every product is in their range, rationals. Properties, each
/// a test: swapping p and q negates the sign; zero if and only if d is normal to p - q; negating d negates the sign.
/// O(1), allocates only in rationals.
Sign compare_along(const Vector2& d, const Point2& p, const Point2& q, Tier& tier);
Sign compare_along(const Vector2& d, const Point2& p, const Point2& q);
Sign compare_along(const Vector3& d, const Point3& p, const Point3& q, Tier& tier);
Sign compare_along(const Vector3& d, const Point3& p, const Point3& q);

/// Along the line from a to b: the sign of (b - a) . (p - q), also where b - a is no vector of doubles.
///
/// Exact for all finite doubles: filter, then integers on the grid of the call. Properties as above.
Sign compare_along_line(const Point3& a, const Point3& b, const Point3& p, const Point3& q, Tier& tier);
Sign compare_along_line(const Point3& a, const Point3& b, const Point3& p, const Point3& q);

}  // namespace quoin
