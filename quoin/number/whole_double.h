// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "quoin/number/fixed_int.h"

namespace quoin {

/// A double that is an integer below 2^127 in magnitude, in two limbs. Exact. The compiler's conversion to 128 bits is
/// a call that takes several times as long. O(1)
inline FixedInt<2> from_whole_double(double x) {
  constexpr unsigned mantissa_bits = 52;
  constexpr std::uint64_t one = std::uint64_t{1} << mantissa_bits;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int shift = static_cast<int>(bits >> mantissa_bits & 0x7FFU) - (1023 + 52);
  const fixed_int_detail::UInt128 mantissa = (bits & (one - 1)) | one;
  // Zero has the least exponent, so that its mantissa is shifted out.
  const auto magnitude = shift >= 0 ? mantissa << shift : mantissa >> std::min(-shift, 64);
  const auto value = (bits >> 63U) != 0 ? -magnitude : magnitude;
  FixedInt<2> result;
  result.set_limb(0, static_cast<std::uint64_t>(value));
  result.set_limb(1, static_cast<std::uint64_t>(value >> 64U));
  return result;
}

}  // namespace quoin
