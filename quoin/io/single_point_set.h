// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
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

  /// Numbers a few points at once: their slots are fetched together, so that the cache misses overlap. Writes one
  /// entry of `out` per point. -0 becomes +0 in `points`.
  void insert(std::span<Point> points, std::span<Inserted> out) {
    std::array<std::size_t, batch> hashes;
    for (std::size_t begin = 0; begin < points.size(); begin += batch) {
      const std::size_t count = std::min(batch, points.size() - begin);
      for (std::size_t i = 0; i < count; ++i) {
        for (float& x : points[begin + i]) x += 0.0F;
        hashes[i] = hash_of(points[begin + i]);
        __builtin_prefetch(&slots_[hashes[i] & (slots_.size() - 1)], 1);
      }
      for (std::size_t i = 0; i < count; ++i) out[begin + i] = insert(points[begin + i], hashes[i]);
    }
  }

 private:
  struct Slot {
    Point point;
    std::uint32_t after;  // number + 1; 0 in a free slot
  };

  static constexpr std::size_t batch = 48;

  Inserted insert(const Point& p, std::size_t hash) {
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot].after != 0) {
      if (slots_[slot].point == p) return {slots_[slot].after - 1, false};
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = {p, ++size_};
    if (2 * std::size_t{size_} > slots_.size()) grow();
    return {size_ - 1, true};
  }

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
