// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// All points, by their indices, along a Hilbert curve; points of one cell of the curve along a finer curve of their
/// own, and the last few by their coordinates. Equal points follow each other, the one given first first.
///
/// The order of distinct points depends on their set alone, not on the order in which they are given or how often. At
/// most 2^31 finite points. O(n) for points whose distances are of like size; at most O(n log n) per 11 bits that they
/// span.
std::vector<std::uint32_t> hilbert_order(std::span<const Point3> points, const Context& context);

/// The round in which the point of this rank is inserted: 0 is the last one, with seven of eight ranks; each other one
/// has an eighth of the ranks of the next. Source: Amenta, Choi and Rote 2003.
inline unsigned insertion_round(std::uint64_t rank) {
  std::uint64_t hash = (rank + 1) * 0x9E3779B97F4A7C15U;
  hash = (hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9U;
  hash ^= hash >> 29;
  unsigned round = 0;
  for (; (hash & 7) == 0 && round < 9; hash >>= 3) ++round;
  return round;
}
inline constexpr unsigned insertion_rounds = 10;

}  // namespace quoin
