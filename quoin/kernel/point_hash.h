// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "quoin/kernel/point.h"

namespace quoin {

/// Hash of the coordinates' bits; equal points have equal hashes where zeros are plain (+0).
inline std::size_t hash_of(const Point3& p) {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15U;
  h = (h ^ (h >> 29) ^ std::bit_cast<std::uint64_t>(p.y)) * 0xBF58476D1CE4E5B9U;
  h = (h ^ (h >> 32) ^ std::bit_cast<std::uint64_t>(p.z)) * 0x94D049BB133111EBU;
  return h ^ (h >> 31);
}

}  // namespace quoin
