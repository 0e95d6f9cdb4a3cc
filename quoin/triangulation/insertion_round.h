// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace quoin {

inline constexpr unsigned insertion_rounds = 10;

/// The round in which the point of this rank is inserted, scattered by a hash of the rank: 0 is the last one, with
/// seven of eight ranks; each other one has an eighth of the ranks of the next. Source: Amenta, Choi and Rote 2003.
inline unsigned insertion_round(std::uint64_t rank) {
  std::uint64_t hash = (rank + 1) * 0x9E3779B97F4A7C15U;
  hash = (hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9U;
  hash ^= hash >> 29;
  return std::min(static_cast<unsigned>(std::countr_zero(hash)) / 3, insertion_rounds - 1);
}

}  // namespace quoin
