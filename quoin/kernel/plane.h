// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/tier.h"

namespace quoin {

/// The points p with normal . p = offset; four finite doubles that mean exactly what they say, the normal not zero.
/// A plane through given points is in general no such plane: use orientation() or Constructions.
struct Plane3 {
  Vector3 normal;
  double offset = 0;
  friend constexpr bool operator==(const Plane3&, const Plane3&) = default;
};

/// Side of the plane on which p lies: the sign of normal . p - offset, positive where the normal points to.
///
/// Exact for all finite doubles: filter, expansions where every product is in their range, rationals. Properties, each
/// a test: zero if and only if p lies on the plane; negating normal and offset negates the sign. O(1), allocates only
/// in rationals.
Sign side(const Point3& p, const Plane3& plane, Tier& tier);
Sign side(const Point3& p, const Plane3& plane);

}  // namespace quoin
