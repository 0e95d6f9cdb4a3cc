// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quoin {

/// A set of numbers below a bound that knows its largest: a tree of words of 64 bits, each bit of a level above telling
/// whether a word below is not zero.
///
/// Insertion, removal and the largest number take a step for each of the levels, of which there are at most six.
/// Source: Bauer, Kerber, Reininghaus, Wagner: PHAT (2017), the bit tree of its pivot columns.
class PivotBits {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  explicit PivotBits(std::size_t bound) {
    do {
      bound = (bound + 63) / 64;
      levels_.emplace_back(bound, 0);
    } while (bound > 1);
  }

  /// Inserts what is not there and removes what is.
  void toggle(std::uint32_t i) {
    for (std::vector<std::uint64_t>& level : levels_) {
      std::uint64_t& word = level[i / 64];
      const bool was_empty = word == 0;
      word ^= std::uint64_t{1} << (i % 64);
      if (!was_empty && word != 0) return;
      i /= 64;
    }
  }

  /// The largest number, or `none`.
  std::uint32_t largest() const {
    if (levels_.back().empty() || levels_.back()[0] == 0) return none;
    std::uint32_t i = 0;
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
      i = i * 64 + 63 - static_cast<std::uint32_t>(std::countl_zero((*level)[i]));
    return i;
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace quoin
