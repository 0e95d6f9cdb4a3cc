// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// A triangle of a leaf mesh as three vertex indices.
using Tile = std::array<std::uint32_t, 3>;

/// Two tiles whose boxes meet.
struct TilePair {
  std::uint32_t a;
  std::uint32_t b;
  friend auto operator<=>(const TilePair&, const TilePair&) = default;
};

/// Bounding boxes of the tiles of one mesh in a tree, conservative single-precision boxes rounded outward.
///
/// Every query reports a superset of the tiles whose closed exact boxes meet, in an order that depends on the input alone.
class BoxTree {
 public:
  BoxTree() = default;
  /// O(n log n). The arrays are read, not kept.
  BoxTree(std::span<const Point3> vertices, std::span<const Tile> tiles, const Context& context);

  std::size_t size() const;
  /// Corners of the box of everything; meaningless when empty.
  std::array<float, 6> bounds() const;  ///< lo x, y, z, hi x, y, z

  /// All pairs (tile of `a`, tile of `b`) whose boxes meet.
  static std::vector<TilePair> pairs(const BoxTree& a, const BoxTree& b, const Context& context);
  /// All pairs a < b of tiles of this tree whose boxes meet, also those that share vertices.
  std::vector<TilePair> self_pairs(const Context& context) const;
  /// The same without pairs that share a vertex index.
  std::vector<TilePair> vertex_disjoint_pairs(const Context& context) const;
  /// Appends the tiles whose box meets the line parallel to the axis through any point of the box [lo, hi] of the other two
  /// coordinates ((axis+1)%3, (axis+2)%3).
  void tiles_on_line(unsigned axis, std::array<double, 2> lo, std::array<double, 2> hi, std::vector<std::uint32_t>& out) const;
  /// Appends the tiles whose box meets the box.
  void tiles_in_box(const Point3& lo, const Point3& hi, std::vector<std::uint32_t>& out) const;

 private:
  struct Node;
  std::vector<std::uint32_t> placeholder_;
};

}  // namespace quoin
