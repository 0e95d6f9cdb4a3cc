// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/point_merger.h"

#include "quoin/base/id.h"
#include "quoin/kernel/point_hash.h"

namespace quoin::overlay {

namespace {

constexpr std::uint32_t none = PointId::none_value;

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
