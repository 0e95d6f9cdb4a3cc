// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/direction_pool.h"

#include <algorithm>

namespace quoin {
namespace {

std::uint32_t length_for(unsigned bits) {
  if (bits <= 62) return 1;
  if (bits <= 126) return 2;
  if (bits <= 254) return 4;
  return (bits + 2 + 63) / 64;
}

std::uint64_t hash_of(std::span<const std::uint64_t> limbs) {
  std::uint64_t hash = limbs.size();
  for (const std::uint64_t limb : limbs) {
    hash = (hash ^ limb) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32;
  }
  return hash;
}

void negate(std::span<std::uint64_t> limbs) {
  bool carry = true;
  for (std::uint64_t& limb : limbs) {
    limb = ~limb + static_cast<std::uint64_t>(carry);
    carry = carry && limb == 0;
  }
}

void store(const SphereDirection& direction, std::size_t axis, std::span<std::uint64_t> out) {
  if (direction.is_small()) {
    const SphereDirection::Int128 value = direction.small(axis);
    out[0] = static_cast<std::uint64_t>(value);
    if (out.size() == 2) out[1] = static_cast<std::uint64_t>(value >> 64);
    return;
  }
  const Integer value = direction.integer(axis);
  mpz_export(out.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, value.raw());
  if (value.sign() == Sign::negative) negate(out);
}

}  // namespace

std::uint32_t DirectionPool::insert(const SphereDirection& direction) {
  const std::uint32_t length = length_for(direction.bits());
  const std::size_t offset = limbs_.size();
  limbs_.resize(offset + 3 * std::size_t{length});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    store(direction, axis, std::span(limbs_).subspan(offset + axis * length, length));
  }
  return settle(offset, length, direction.bits());
}

std::vector<std::uint32_t> DirectionPool::absorb(const DirectionPool& other) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(other.size());
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Entry entry = other.entries_[i];
    const std::size_t offset = limbs_.size();
    limbs_.resize(offset + 3 * std::size_t{entry.length});
    std::ranges::copy(other.limbs_of(entry), limbs_.begin() + static_cast<std::ptrdiff_t>(offset));
    numbers.push_back(settle(offset, entry.length, entry.bits));
  }
  return numbers;
}

Sign DirectionPool::sign(std::uint32_t index, std::size_t axis) const {
  const Entry& entry = entries_[index];
  const auto limbs = limbs_of(entry).subspan(axis * entry.length, entry.length);
  if (static_cast<std::int64_t>(limbs.back()) < 0) return Sign::negative;
  const bool is_zero = std::ranges::all_of(limbs, [](std::uint64_t limb) { return limb == 0; });
  return is_zero ? Sign::zero : Sign::positive;
}

void DirectionPool::load(std::uint32_t index, std::size_t axis, Integer& out) const {
  const Entry& entry = entries_[index];
  const auto limbs = limbs_of(entry).subspan(axis * entry.length, entry.length);
  if (static_cast<std::int64_t>(limbs.back()) >= 0) {
    mpz_import(out.raw(), limbs.size(), -1, sizeof(std::uint64_t), 0, 0, limbs.data());
    return;
  }
  std::vector<std::uint64_t> size(limbs.begin(), limbs.end());
  negate(size);
  mpz_import(out.raw(), size.size(), -1, sizeof(std::uint64_t), 0, 0, size.data());
  mpz_neg(out.raw(), out.raw());
}

std::uint32_t DirectionPool::settle(std::size_t offset, std::uint32_t length, unsigned bits) {
  if (2 * (entries_.size() + 1) > table_.size()) grow_table();
  const Entry added{offset, length, bits, hash_of({limbs_.data() + offset, 3 * std::size_t{length}})};
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = added.hash & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask) {
    const Entry& known = entries_[table_[slot] - 1];
    if (known.hash == added.hash && std::ranges::equal(limbs_of(known), limbs_of(added))) {
      limbs_.resize(offset);
      return table_[slot] - 1;
    }
  }
  entries_.push_back(added);
  table_[slot] = static_cast<std::uint32_t>(entries_.size());
  return table_[slot] - 1;
}

void DirectionPool::grow_table() {
  table_.assign(std::max<std::size_t>(16, 2 * table_.size()), 0);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    std::size_t slot = entries_[i].hash & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace quoin
