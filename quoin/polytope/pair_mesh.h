// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/tiled_surface.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Triangles whose corners are sums of a vertex of one surface and a vertex of another.
class PairMesh {
 public:
  struct Corner {
    std::uint32_t a;
    std::uint32_t b;
  };

  /// `count` times, turned over where it is negative.
  void add(const std::array<Corner, 3>& corners, int count);

  /// As a closed surface: corners in one place are one vertex, triangles without area are healed away. Two in one place
  /// that face each other both stay: they do not wind, but may be the boundary of the sum. O(n log n).
  /// @throws InputError where a sum leaves the range of doubles
  std::shared_ptr<const Leaf> leaf(const TiledSurface& a, const TiledSurface& b, const Context& context);

 private:
  std::uint32_t vertex(const Corner& corner);

  std::unordered_map<std::uint64_t, std::uint32_t> number_;
  std::vector<Corner> vertices_;
  std::vector<Tile> triangles_;
};

}  // namespace quoin
