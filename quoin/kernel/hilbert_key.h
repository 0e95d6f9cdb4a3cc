// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace quoin {

/// Bits of one axis, at most 21, each followed by two zeros.
constexpr std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x001F00000000FFFF;
  x = (x | x << 16) & 0x001F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Number along the Hilbert curve of a cell of 2^bits cells per axis; bits at most 21.
///
/// Skilling's transposed form, then the bits of the axes in turn. Source: Skilling 2004.
constexpr std::uint64_t hilbert_key(std::array<std::uint32_t, 3> x, unsigned bits) {
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t& axis : x) {
      // Where the bit is set, the lower bits of the first axis are inverted; else exchanged with those of this one.
      const std::uint32_t is_set = (axis & bit) != 0 ? lower : 0;
      const std::uint32_t exchanged = (x[0] ^ axis) & (lower ^ is_set);
      x[0] ^= exchanged | is_set;
      axis ^= exchanged;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t mask = 0;
  for (std::uint32_t bit = 1U << (bits - 1); bit > 1; bit >>= 1) {
    if ((x[2] & bit) != 0) mask ^= bit - 1;
  }
  return spread_bits(x[0] ^ mask) << 2 | spread_bits(x[1] ^ mask) << 1 | spread_bits(x[2] ^ mask);
}

}  // namespace quoin
