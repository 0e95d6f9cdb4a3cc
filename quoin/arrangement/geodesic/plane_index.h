// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin {

/// Finds planes through the origin again, by rounded normals, whose exact ones differ by a positive factor.
///
/// A normal is known by doubles with a relative error of at most 2^-52 per component, up to a common factor, zero where
/// the component is. Divided by the largest, each component falls into one of the cells that a double's leading 40 bits
/// make; what lies within 2^-47 of a border is looked up on both sides, so equal planes meet whatever was rounded. The
/// caller decides exactly among the few that are found. That spares the common divisor of long integers.
class PlaneIndex {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  /// The first added number of such a normal for which is_same(number) holds, or none.
  template <class IsSame>
  std::uint32_t find(const Vector3& normal, const IsSame& is_same) const {
    if (slots_.empty()) return none;
    const Vector3 ratios = ratios_of(normal);
    const Cells low = cells(ratios, 1 - 0x1p-47);
    const Cells high = cells(ratios, 1 + 0x1p-47);
    for (unsigned choice = 0; choice < 8; ++choice) {
      Cells probe = low;
      bool is_new = true;
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (((choice >> axis) & 1U) == 0) continue;
        is_new = is_new && low[axis] != high[axis];
        probe[axis] = high[axis];
      }
      if (!is_new) continue;
      const std::uint64_t hash = hash_of(probe);
      for (std::size_t slot = hash & mask(); slots_[slot].number != none; slot = (slot + 1) & mask()) {
        if (slots_[slot].hash == hash && is_same(slots_[slot].number)) return slots_[slot].number;
      }
    }
    return none;
  }

  void add(const Vector3& normal, std::uint32_t number) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    ++count_;
    place({hash_of(cells(ratios_of(normal), 1)), number});
  }

 private:
  using Cells = std::array<std::uint64_t, 3>;
  struct Slot {
    std::uint64_t hash = 0;
    std::uint32_t number = none;
  };

  std::size_t mask() const { return slots_.size() - 1; }

  /// To the largest component; off 1, 1/2 and the like, which are frequent and would lie on borders of cells.
  static Vector3 ratios_of(const Vector3& normal) {
    const double scale = 1.37 / std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
    return {normal.x * scale, normal.y * scale, normal.z * scale};
  }

  /// Monotone in each component's magnitude. Below 2^-800 of the largest all are one cell, so underflow does not
  /// matter.
  static Cells cells(const Vector3& ratios, double factor) {
    Cells result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double ratio = ratios[axis];
      const std::uint64_t cell = std::bit_cast<std::uint64_t>(std::max(std::fabs(ratio) * factor, 0x1p-800)) >> 12;
      result[axis] = ratio == 0 ? 0 : ratio < 0 ? cell | (std::uint64_t{1} << 63) : cell;
    }
    return result;
  }

  static std::uint64_t hash_of(const Cells& cells) {
    std::uint64_t hash = 0;
    for (const std::uint64_t cell : cells) {
      hash = (hash ^ cell) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32;
    }
    return hash;
  }

  void place(const Slot& added) {
    std::size_t slot = added.hash & mask();
    while (slots_[slot].number != none) slot = (slot + 1) & mask();
    slots_[slot] = added;
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.number != none) place(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace quoin
