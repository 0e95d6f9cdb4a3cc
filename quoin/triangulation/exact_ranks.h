// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/interval.h"
#include "quoin/triangulation/smallest_spheres.h"

namespace quoin {

/// The order of numbers: equal ones have the same rank, the least 0.
struct ExactRanks {
  std::vector<std::uint32_t> rank;   ///< by item
  std::vector<std::uint32_t> first;  ///< of each rank the item of the least number

  /// All items by ascending rank, equal ones by number. O(n).
  std::vector<std::uint32_t> order() const;
};

/// Numbers that exact_ranks asks for only where intervals of them overlap.
struct NumberSource {
  std::function<Interval(std::uint32_t item)> closer;  ///< of a width of a few units in the last place
  std::function<ExactQuotient(std::uint32_t item)> exact;
};

/// Sorts numbers that are known by intervals, and more closely and exactly by a source.
///
/// O(n log n); of m items that overlap, beyond that O(m log m) comparisons of integers and O(m log d) of quotients for
/// d distinct numbers that agree in about 190 bits. @throws Cancelled
ExactRanks exact_ranks(std::span<const Interval> bounds, const NumberSource& source, const Context& context);

}  // namespace quoin
