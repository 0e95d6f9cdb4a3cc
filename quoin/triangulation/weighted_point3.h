// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/point.h"

namespace quoin {

/// A point of space with a weight, the square of a radius (or less than nothing).
struct WeightedPoint3 {
  Point3 point;
  double weight = 0;
  friend constexpr bool operator==(const WeightedPoint3&, const WeightedPoint3&) = default;
};

}  // namespace quoin
