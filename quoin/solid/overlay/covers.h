// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace quoin::overlay {

/// Two regions of a plane on both sides of a piece of curve, and the units that one of them covers and the other does
/// not.
struct RegionNeighbours {
  std::uint32_t a;
  std::uint32_t b;
  std::span<const std::uint32_t> toggled;
};

/// The units that cover each region, ascending.
struct Covers {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> units;
  std::span<const std::uint32_t> of(std::uint32_t region) const {
    return {units.data() + first[region], units.data() + first[region + 1]};
  }
};

/// Walks from `outside`, which nothing covers, across all pieces. Regions that cannot be reached are covered by
/// nothing. O(p + k) for p pieces and k units in the answer, times the depth of the cover.
Covers find_covers(std::uint32_t region_count, std::uint32_t outside, std::span<const RegionNeighbours> neighbours);

}  // namespace quoin::overlay
