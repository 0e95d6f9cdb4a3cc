// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "quoin/kernel/call_grid.h"
#include "quoin/number/integer.h"

namespace quoin::detail {

/// x / 2^lo, where that is an integer.
inline Integer on_grid(double x, int lo) {
  const Parts parts = parts_of(x);
  const int shift = parts.exponent - lo;
  if (shift < 0) return {parts.mantissa >> std::min(-shift, 63)};  // the bits that go are zero
  return Integer(parts.mantissa) << static_cast<std::size_t>(shift);
}

}  // namespace quoin::detail
