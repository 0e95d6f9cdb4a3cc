// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/assembly/part_set.h"

namespace quoin {

/// Which part is stopped by which, for one way of moving: an arc from i to j says that i on its own would meet j.
///
/// A set of parts can move, the others staying, if and only if no arc leads out of it. Kept as two matrices of bits, so
/// that an arc is set in O(1) and a set that reaches out grows by whole rows.
class BlockingGraph {
 public:
  explicit BlockingGraph(std::size_t part_count)
      : part_count_(part_count),
        words_((part_count + 63) / 64),
        out_(part_count * words_, 0),
        in_(part_count * words_, 0) {}

  std::size_t part_count() const { return part_count_; }
  bool has_arc(std::size_t from, std::size_t to) const {
    return (out_[from * words_ + to / 64] >> (to % 64) & 1U) != 0;
  }
  void set_arc(std::size_t from, std::size_t to, bool is_there) {
    set_bit(out_, from, to, is_there);
    set_bit(in_, to, from, is_there);
  }
  std::size_t arc_count() const;

  /// Whether every part of the set leads to every other one within the set; true of one part. O(n^2 / 64).
  bool is_strongly_connected(const PartSet& within) const;

  /// The sets that can move within an assembly of these parts: for each part, whatever must move with it, without the
  /// whole. Distinct; the smallest come first, then in the order of PartSet. All sets that can move are unions of
  /// these. Empty if and only if the graph is strongly connected. O(n^3 / 64).
  std::vector<PartSet> movable_sets(const PartSet& within) const;

  /// Whether an arc leads from the part to another one of the set.
  bool is_held(std::size_t part, const PartSet& within) const {
    for (std::size_t w = 0; w < words_; ++w) {
      if ((out_[part * words_ + w] & within.words()[w]) != 0) return true;
    }
    return false;
  }

  /// All that the part leads to within the set, itself too.
  PartSet reachable(std::uint32_t from, const PartSet& within) const { return closure(out_, from, within); }

  friend bool operator==(const BlockingGraph&, const BlockingGraph&) = default;
  /// The arcs out of each part, row by row.
  const std::vector<std::uint64_t>& rows() const { return out_; }

 private:
  using Rows = std::vector<std::uint64_t>;

  void set_bit(Rows& rows, std::size_t row, std::size_t column, bool value) const {
    std::uint64_t& word = rows[row * words_ + column / 64];
    const std::uint64_t bit = std::uint64_t{1} << (column % 64);
    word = value ? word | bit : word & ~bit;
  }
  /// Whether some part is not held by any other one of the set.
  bool has_free_part(const PartSet& within) const;
  PartSet closure(const Rows& rows, std::uint32_t from, const PartSet& within) const;

  std::size_t part_count_;
  std::size_t words_;
  Rows out_;
  Rows in_;
};

}  // namespace quoin
