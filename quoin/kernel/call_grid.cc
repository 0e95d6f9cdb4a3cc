// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/call_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace quoin::detail {

namespace {

constexpr int mantissa_bits = 52;
constexpr int lowest_exponent = -1074;

std::uint64_t magnitude_of(std::int64_t mantissa) {
  return static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
}

}  // namespace

Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>((bits >> mantissa_bits) & 0x7ff);
  const std::uint64_t hidden = std::uint64_t{field != 0} << mantissa_bits;
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << mantissa_bits) - 1);
  const auto mantissa = static_cast<std::int64_t>(fraction | hidden);
  return {(bits >> 63) != 0 ? -mantissa : mantissa, lowest_exponent + std::max(field - 1, 0)};
}

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
