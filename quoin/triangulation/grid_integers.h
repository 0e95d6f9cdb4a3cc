// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/point.h"
#include "quoin/number/integer.h"

namespace quoin::detail {

/// x / 2^lo, where that is an integer.
inline Integer on_grid(double x, int lo) {
  const Parts parts = parts_of(x);
  const int shift = parts.exponent - lo;
  if (shift < 0) return {parts.mantissa >> std::min(-shift, 63)};  // the bits that go are zero
  return Integer(parts.mantissa) << static_cast<std::size_t>(shift);
}

/// The largest lo so that all coordinates are multiples of 2^lo, and all weights of 2^(2 lo); at most 1100.
inline int grid_of_weighted(std::span<const Point3> points, std::span<const double> weights) {
  int lo = 1100;
  for (const Point3& p : points) lo = std::min({lo, lowest_bit(p.x), lowest_bit(p.y), lowest_bit(p.z)});
  for (const double w : weights) {
    const int lowest = lowest_bit(w);
    lo = std::min(lo, (lowest - (lowest & 1)) / 2);  // rounded down
  }
  return lo;
}

}  // namespace quoin::detail
