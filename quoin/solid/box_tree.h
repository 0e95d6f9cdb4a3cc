// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/solid/float_box.h"

namespace quoin {

/// Two tiles whose boxes meet.
struct TilePair {
  std::uint32_t a;
  std::uint32_t b;
  friend auto operator<=>(const TilePair&, const TilePair&) = default;
};

/// Bounding boxes of the tiles of one mesh in a tree, conservative single-precision boxes rounded outward.
///
/// Tiles in Morton order, split where the highest bit of their keys changes (Karras 2012), down to leaves of at most 16
/// tiles, which are tested four at a time. Every query reports a superset of the tiles whose closed exact boxes meet,
/// in an order that depends on the input alone.
class BoxTree {
 public:
  BoxTree() = default;
  /// O(n log n). The arrays are read, not kept.
  BoxTree(std::span<const Point3> vertices, std::span<const Tile> tiles, const Context& context);

  /// The same of boxes; "tiles" are then their indices.
  BoxTree(std::span<const FloatBox> boxes, const Context& context);

  std::size_t size() const { return size_; }
  /// lo x, y, z, hi x, y, z of everything; an inverted box when empty.
  std::array<float, 6> bounds() const;

  /// All pairs (tile of `a`, tile of `b`) whose boxes meet.
  static std::vector<TilePair> pairs(const BoxTree& a, const BoxTree& b, const Context& context);
  /// Calls visit(pair) for pairs (tile of `a`, tile of `b`) whose boxes are no further apart than a bound, nearer
  /// subtrees first, with those of `a` moved by a vector that is off by less than 2^-52 of itself; `visit` returns the
  /// square of the bound from then on, which never grows, and ends all below zero.
  static void nearest_pairs(const BoxTree& a, const BoxTree& b, const Vector3& by,
                            const std::function<double(const TilePair&)>& visit, const Context& context);
  /// All pairs a < b of tiles of this tree whose boxes meet, also those that share vertices.
  std::vector<TilePair> self_pairs(const Context& context) const;
  /// Pairs of tiles that are not reported.
  struct Excluded {
    std::span<const Tile> labels{};            ///< per tile; no pairs that have one in common. `no_label` is none
    std::span<const std::uint8_t> subtrees{};  ///< per node, or empty; no pairs within a marked subtree
  };
  /// The same without what is excluded and without the pairs that `keep` refuses. `keep` is called from several
  /// threads. Only kept pairs take memory; tiles that all share a label, as around the apex of a cone, take no time.
  std::vector<TilePair> self_pairs(const Excluded& excluded, const std::function<bool(const TilePair&)>& keep,
                                   const Context& context) const;
  static constexpr std::uint32_t no_label = 0xFFFFFFFFU;

  /// The tiles of a subtree. Slots number tiles in the order of the tree, with gaps.
  struct Subtree {
    std::span<const std::uint32_t> tiles;
    std::uint32_t begin;  ///< its slots, half-open
    std::uint32_t end;
  };
  /// The slot of each tile. O(n).
  std::vector<std::uint32_t> slots() const;

  struct Marked {
    std::vector<std::uint8_t> is_marked;     ///< per node
    std::vector<std::uint32_t> other_tiles;  ///< those in no marked subtree
  };
  /// Offers the largest subtrees of at most `largest` tiles, and where one is not accepted its two halves, down to
  /// `smallest` tiles. `accept` is called from several threads. O(n) beside what it takes, for a tree of balanced
  /// halves.
  Marked marked_subtrees(std::size_t smallest, std::size_t largest, const std::function<bool(const Subtree&)>& accept,
                         const Context& context) const;

  /// Appends the tiles whose box meets the lines parallel to the axis through the box [lo, hi] of the other two
  /// coordinates ((axis+1)%3, (axis+2)%3).
  void tiles_on_line(unsigned axis, std::array<double, 2> lo, std::array<double, 2> hi,
                     std::vector<std::uint32_t>& out) const;
  /// Appends the tiles whose box meets the line through the point, and maybe some close to it; coordinates off by an
  /// ulp do not lose any.
  void tiles_near_line(const Point3& point, const Vector3& direction, std::vector<std::uint32_t>& out) const;
  /// Appends the tiles whose box meets the box.
  void tiles_in_box(const Point3& lo, const Point3& hi, std::vector<std::uint32_t>& out) const;

 private:
  friend class BoxTreePairs;
  friend class BoxTreeNearest;
  friend class SubtreeMarker;

  // Nodes in depth-first order: the first child follows its parent, the second is named. A leaf has block_count > 0
  // blocks from there on, the last of them filled up with empty boxes.
  struct Node {
    FloatBox box;
    std::uint32_t second_or_block;
    std::uint32_t block_count;
  };

  void build(std::span<const FloatBox> boxes, const Context& context);
  std::uint32_t build(std::span<const std::uint32_t> keys, std::span<const std::uint32_t> order,
                      std::span<const FloatBox> boxes);
  void fill_leaf(std::uint32_t node, std::span<const std::uint32_t> order, std::span<const FloatBox> boxes);
  template <class Accept>
  void collect(const Accept& accept, std::vector<std::uint32_t>& out) const;

  // Calls visit(tile, slot) for the tiles of blocks [begin, end).
  template <class Visit>
  void for_each_tile(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    for (std::uint32_t block = begin; block < end; ++block) {
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        const bool is_filled = blocks_[block].lo[0][lane] == blocks_[block].lo[0][lane];  // not NaN
        if (is_filled) visit(block_tiles_[block][lane], 4 * block + lane);
      }
    }
  }

  std::size_t size_ = 0;
  std::vector<Node> nodes_;
  std::vector<BoxBlock> blocks_;
  std::vector<std::array<std::uint32_t, 4>> block_tiles_;
};

}  // namespace quoin
