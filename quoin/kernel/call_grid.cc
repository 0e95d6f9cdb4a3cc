// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/call_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace quoin::detail {

namespace {

std::uint64_t magnitude_of(std::int64_t mantissa) {
  return static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
}

}  // namespace

CallGrid::CallGrid(std::span<const double> values) {
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();
  for (const double x : values) {
    const Parts parts = parts_of(x);
    if (parts.mantissa == 0) continue;
    const std::uint64_t size = magnitude_of(parts.mantissa);
    low = std::min(low, parts.exponent + std::countr_zero(size));
    high = std::max(high, parts.exponent + 64 - std::countl_zero(size));
  }
  if (low > high) return;  // all zero
  lo = low;
  bits = high - low;
}

}  // namespace quoin::detail
