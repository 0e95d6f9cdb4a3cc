// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quoin {

/// A set of parts of an assembly, by their numbers.
class PartSet {
 public:
  PartSet() = default;
  /// Empty, for numbers below `part_count`.
  explicit PartSet(std::size_t part_count) : words_((part_count + 63) / 64, 0) {}
  static PartSet all(std::size_t part_count) {
    PartSet set(part_count);
    for (std::size_t part = 0; part < part_count; ++part) set.insert(part);
    return set;
  }

  bool contains(std::size_t part) const { return (words_[part / 64] >> (part % 64) & 1U) != 0; }
  void insert(std::size_t part) { words_[part / 64] |= std::uint64_t{1} << (part % 64); }
  std::size_t count() const {
    std::size_t result = 0;
    for (const std::uint64_t word : words_) result += static_cast<std::size_t>(std::popcount(word));
    return result;
  }
  bool has_several() const {
    bool has_one = false;
    for (const std::uint64_t word : words_) {
      if (word == 0) continue;
      if (has_one || (word & (word - 1)) != 0) return true;
      has_one = true;
    }
    return false;
  }
  /// Ascending.
  std::vector<std::uint32_t> members() const {
    std::vector<std::uint32_t> result;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      for (std::uint64_t rest = words_[w]; rest != 0; rest &= rest - 1) {
        result.push_back(static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(rest))));
      }
    }
    return result;
  }
  /// Without this set's parts; both are for equally many.
  PartSet without(const PartSet& other) const {
    PartSet result(*this);
    for (std::size_t w = 0; w < words_.size(); ++w) result.words_[w] &= ~other.words_[w];
    return result;
  }

  std::vector<std::uint64_t>& words() { return words_; }
  const std::vector<std::uint64_t>& words() const { return words_; }
  friend bool operator==(const PartSet&, const PartSet&) = default;
  friend auto operator<=>(const PartSet&, const PartSet&) = default;

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace quoin
