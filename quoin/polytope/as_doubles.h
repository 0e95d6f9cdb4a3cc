// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// The same points in doubles, if all coordinates are some. O(n). @throws Cancelled through the context, if
/// there is one
inline std::optional<std::vector<Point3>> as_doubles(std::span<const RationalPoint3> points,
                                                     const Context* context = nullptr) {
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const RationalPoint3& p : points) {
    if (context != nullptr && result.size() % 256 == 0) context->poll();
    const Point3 rounded{p.x.to_double(), p.y.to_double(), p.z.to_double()};
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(rounded[axis]) || Rational(rounded[axis]) != p[axis]) return std::nullopt;
    }
    result.push_back(rounded);
  }
  return result;
}

}  // namespace quoin
