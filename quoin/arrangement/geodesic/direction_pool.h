// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/geodesic/sphere_direction.h"
#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"

namespace quoin {

/// Directions, numbered in the order of their insertion, each as limbs in two's complement, as many as its bits need:
/// one up to 62 bits, two up to 126, four up to 254, else any number. `insert` keeps equal triples of integers once.
class DirectionPool {
 public:
  /// The number of a direction, whether it was there or is new. Not to be mixed with `append`.
  std::uint32_t insert(const SphereDirection& direction);
  /// Inserts all of the other pool; returns the numbers they have here.
  std::vector<std::uint32_t> absorb(const DirectionPool& other);

  /// A new number, even for a direction that is there.
  std::uint32_t append(const SphereDirection& direction);
  std::uint32_t append(const DirectionPool& other, std::uint32_t index);
  void remove_last();
  /// Both have the same three integers.
  bool has_same_integers(std::uint32_t a, std::uint32_t b) const;

  std::size_t size() const { return entries_.size(); }
  unsigned bits(std::uint32_t index) const { return entries_[index].bits; }
  Sign sign(std::uint32_t index, std::size_t axis) const;

  /// Component of a direction of at most 64 N - 2 bits.
  template <std::size_t N>
  void load(std::uint32_t index, std::size_t axis, FixedInt<N>& out) const {
    const Entry& entry = entries_[index];
    const std::uint64_t* limbs = limbs_.data() + entry.offset + axis * entry.length;
    const auto fill = static_cast<std::uint64_t>(static_cast<std::int64_t>(limbs[entry.length - 1]) >> 63);
    for (std::size_t i = 0; i < N; ++i) out.set_limb(i, i < entry.length ? limbs[i] : fill);
  }
  void load(std::uint32_t index, std::size_t axis, Integer& out) const;

 private:
  struct Entry {
    std::size_t offset = 0;
    std::uint32_t length = 0;  ///< limbs per component
    unsigned bits = 0;
  };

  std::span<const std::uint64_t> limbs_of(const Entry& entry) const {
    return {limbs_.data() + entry.offset, 3 * std::size_t{entry.length}};
  }
  /// Looks up the last entry; removes it if it is known.
  std::uint32_t settle_last();
  void grow_table();

  std::vector<std::uint64_t> limbs_;
  std::vector<Entry> entries_;
  std::vector<std::uint64_t> hashes_;  ///< of entries that `insert` looked up
  std::vector<std::uint32_t> table_;   ///< open addressing; entry + 1, or 0 where free
};

}  // namespace quoin
