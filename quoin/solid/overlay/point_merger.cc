// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include "quoin/solid/overlay/network.h"

namespace quoin::overlay {

namespace {

std::size_t hash_of(const Point3& p) {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15U;
  h = (h ^ (h >> 29) ^ std::bit_cast<std::uint64_t>(p.y)) * 0xBF58476D1CE4E5B9U;
  h = (h ^ (h >> 32) ^ std::bit_cast<std::uint64_t>(p.z)) * 0x94D049BB133111EBU;
  return h ^ (h >> 31);
}

}  // namespace

PointId PointMerger::insert(PointId point) {
  if (2 * (used_ + 1) > slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_of(table_->rounded(point)) & mask;
  while (slots_[slot] != none) {
    const PointId other{slots_[slot]};
    if (table_->equal(other, point)) return other;
    slot = (slot + 1) & mask;
  }
  slots_[slot] = point.value;
  ++used_;
  return point;
}

void PointMerger::grow() {
  std::vector<std::uint32_t> old(slots_.empty() ? 64 : 2 * slots_.size(), none);
  old.swap(slots_);
  const std::size_t mask = slots_.size() - 1;
  for (const std::uint32_t value : old) {
    if (value == none) continue;
    std::size_t slot = hash_of(table_->rounded(PointId{value})) & mask;
    while (slots_[slot] != none) slot = (slot + 1) & mask;
    slots_[slot] = value;
  }
}

}  // namespace quoin::overlay
