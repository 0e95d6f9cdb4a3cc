// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/direction_pool.h"

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
  append(direction);
  return settle_last();
}

std::vector<std::uint32_t> DirectionPool::absorb(const DirectionPool& other) {
  std::vector<std::uint32_t> numbers;
  const std::size_t count = other.size();
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    append(other, static_cast<std::uint32_t>(i));
    numbers.push_back(settle_last());
  }
  return numbers;
}

std::uint32_t DirectionPool::append(const SphereDirection& direction) {
  const std::uint32_t length = length_for(direction.bits());
  const std::size_t offset = limbs_.size();
  limbs_.resize(offset + 3 * std::size_t{length});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    store(direction, axis, std::span(limbs_).subspan(offset + axis * length, length));
  }
  entries_.push_back({offset, length, direction.bits()});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::uint32_t DirectionPool::append(const DirectionPool& other, std::uint32_t index) {
  Entry entry = other.entries_[index];
  const std::size_t offset = limbs_.size();
  limbs_.resize(offset + 3 * std::size_t{entry.length});
  std::ranges::copy(other.limbs_of(entry), limbs_.begin() + static_cast<std::ptrdiff_t>(offset));
  entry.offset = offset;
  entries_.push_back(entry);
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

void DirectionPool::remove_last() {
  limbs_.resize(entries_.back().offset);
  entries_.pop_back();
}

bool DirectionPool::has_same_integers(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::equal(limbs_of(entries_[a]), limbs_of(entries_[b]));
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

std::uint32_t DirectionPool::settle_last() {
  if (2 * entries_.size() > table_.size()) grow_table();
  const auto last = static_cast<std::uint32_t>(entries_.size() - 1);
  const std::uint64_t hash = hash_of(limbs_of(entries_[last]));
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask) {
    const std::uint32_t known = table_[slot] - 1;
    if (hashes_[known] == hash && has_same_integers(known, last)) {
      remove_last();
      return known;
    }
  }
  hashes_.push_back(hash);
  table_[slot] = last + 1;
  return last;
}

void DirectionPool::grow_table() {
  table_.assign(std::max<std::size_t>(64, 2 * table_.size()), 0);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = 0; i < hashes_.size(); ++i) {
    std::size_t slot = hashes_[i] & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace quoin
