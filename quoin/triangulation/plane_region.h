// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "quoin/triangulation/rank_region.h"

namespace quoin::detail {

/// Vertices of the plane that follow each other, whose points one thread inserts while others insert those of others.
///
/// A region owns the triangles and the edges all of whose finite vertices are its. So no two own the same, all edges of
/// a triangle are its owner's, and triangles of two owners have no edge in common, as one end of it would be finite:
/// those between them are nobody's. A region replaces triangles of its own alone, by triangles that are its own again,
/// and changes the links of its edges alone; of triangles that are nobody's the corners stay. Thus threads share
/// nothing that changes.
class PlaneRegion {
 public:
  PlaneRegion() = default;
  /// `ranks` are some of those before `infinite`, which follows the last of the cycle.
  PlaneRegion(const RankRegion& ranks, std::uint32_t infinite) {
    const auto runs = ranks.runs();
    const bool is_cut = runs[1][1] > 0;
    first_ = {runs[0][0], runs[0][1] - runs[0][0] + (is_cut ? 1 : 0)};
    second_ = is_cut ? Run{0, runs[1][1]} : Run{infinite, 1};
  }

  /// Whether a vertex is the region's, or infinite.
  bool allows(std::uint32_t v) const { return v - first_.begin < first_.length || v - second_.begin < second_.length; }
  bool owns(const std::array<std::uint32_t, 3>& triangle) const {
    return allows(triangle[0]) && allows(triangle[1]) && allows(triangle[2]);
  }

 private:
  struct Run {
    std::uint32_t begin = 0;
    std::uint32_t length = 0;
  };

  Run first_;
  Run second_;
};

/// Where one thread does all.
struct WholePlane {
  static constexpr bool allows(std::uint32_t /*v*/) { return true; }
  static constexpr bool owns(const std::array<std::uint32_t, 3>& /*triangle*/) { return true; }
};

}  // namespace quoin::detail
