// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quoin::io {

/// Numbers points of single precision by first occurrence: equal points have one number. -0 and +0 are equal.
///
/// Open addressing over slots that hold the point itself, so that a look-up touches one cache line; the table doubles
/// at half load. O(1) expected per insertion.
class SinglePointSet {
 public:
  using Point = std::array<float, 3>;

  /// `expected` distinct points fit before the table grows.
  explicit SinglePointSet(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 16)) {}

  std::uint32_t size() const { return size_; }

  struct Inserted {
    std::uint32_t number;
    bool is_new;
  };

  Inserted insert(Point p) {
    for (float& x : p) x += 0.0F;
    std::size_t slot = hash_of(p) & (slots_.size() - 1);
    while (slots_[slot].after != 0) {
      if (slots_[slot].point == p) return {slots_[slot].after - 1, false};
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = {p, ++size_};
    if (2 * std::size_t{size_} > slots_.size()) grow();
    return {size_ - 1, true};
  }

 private:
  struct Slot {
    Point point;
    std::uint32_t after;  // number + 1; 0 in a free slot
  };

  static std::size_t hash_of(const Point& p) {
    const std::uint64_t xy =
        std::uint64_t{std::bit_cast<std::uint32_t>(p[0])} << 32 | std::bit_cast<std::uint32_t>(p[1]);
    std::uint64_t h = (xy ^ std::bit_cast<std::uint32_t>(p[2]) * 0x9E3779B97F4A7C15U) * 0xD6E8FEB86659FD93U;
    h = (h ^ h >> 32) * 0xD6E8FEB86659FD93U;
    return static_cast<std::size_t>(h ^ h >> 32);
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& s : old) {
      if (s.after == 0) continue;
      std::size_t slot = hash_of(s.point) & (slots_.size() - 1);
      while (slots_[slot].after != 0) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = s;
    }
  }

  std::vector<Slot> slots_;
  std::uint32_t size_ = 0;
};

}  // namespace quoin::io
