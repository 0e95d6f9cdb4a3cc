// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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
/// Tiles in Morton order, split where the highest bit of their keys changes (Karras 2012). Every query reports a
/// superset of the tiles whose closed exact boxes meet, in an order that depends on the input alone.
class BoxTree {
 public:
  struct Box {
    std::array<float, 3> lo;
    std::array<float, 3> hi;
  };

  BoxTree() = default;
  /// O(n log n). The arrays are read, not kept.
  BoxTree(std::span<const Point3> vertices, std::span<const Tile> tiles, const Context& context);

  std::size_t size() const { return tiles_.size(); }
  /// lo x, y, z, hi x, y, z of everything; an inverted box when empty.
  std::array<float, 6> bounds() const;

  /// All pairs (tile of `a`, tile of `b`) whose boxes meet.
  static std::vector<TilePair> pairs(const BoxTree& a, const BoxTree& b, const Context& context);
  /// All pairs a < b of tiles of this tree whose boxes meet, also those that share vertices.
  std::vector<TilePair> self_pairs(const Context& context) const;
  /// The same, keeping only the pairs that `keep` accepts; it is called from several threads.
  std::vector<TilePair> self_pairs(const std::function<bool(const TilePair&)>& keep, const Context& context) const;
  /// Appends the tiles whose box meets the lines parallel to the axis through the box [lo, hi] of the other two
  /// coordinates
  /// ((axis+1)%3, (axis+2)%3).
  void tiles_on_line(unsigned axis, std::array<double, 2> lo, std::array<double, 2> hi,
                     std::vector<std::uint32_t>& out) const;
  /// Appends the tiles whose box meets the box.
  void tiles_in_box(const Point3& lo, const Point3& hi, std::vector<std::uint32_t>& out) const;

 private:
  // Nodes in depth-first order: the first child follows its parent, the second is named. A leaf has count > 0 tiles
  // from `first` on.
  struct Node {
    Box box;
    std::uint32_t second_or_first;
    std::uint32_t count;
  };
  struct NodePair {
    std::uint32_t a;
    std::uint32_t b;
  };

  std::uint32_t build(std::span<const std::uint32_t> keys, std::uint32_t begin, std::uint32_t end);
  static std::vector<TilePair> descend(const BoxTree& a, const BoxTree& b, bool is_self,
                                       const std::function<bool(const TilePair&)>* keep, const Context& context);
  static void expand(const BoxTree& a, const BoxTree& b, bool is_self, NodePair pair, std::vector<NodePair>& out);
  static void report(const BoxTree& a, const BoxTree& b, bool is_self, NodePair pair, std::vector<TilePair>& out);
  template <class Accept>
  void collect(const Accept& accept, std::vector<std::uint32_t>& out) const;

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;            // of tiles, in tree order
  std::vector<std::uint32_t> tiles_;  // in tree order
};

}  // namespace quoin
