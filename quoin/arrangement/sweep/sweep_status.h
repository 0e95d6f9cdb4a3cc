// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "quoin/arrangement/pieces.h"

namespace quoin {

/// The curves that cross the sweep line, from bottom to top: nodes in a two-level list of chunks, so that a place is
/// found by bisection over the first nodes of chunks and then inside one.
///
/// Nodes are also linked to their neighbours. O(log n) comparisons to find a place, O(chunk + n / chunk) to change one.
class SweepStatus {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  struct Node {
    BranchId branch;
    std::uint32_t head = none;  ///< piece of the bundle that ends last
    std::uint32_t edge = none;  ///< the edge that is open there
    std::uint32_t below = none;
    std::uint32_t above = none;
    std::uint32_t chunk = none;
    std::uint32_t heap_place = none;
  };

  Node& operator[](std::uint32_t node) { return nodes_[node]; }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  std::uint32_t lowest() const { return lowest_; }
  std::uint32_t highest() const { return highest_; }
  bool is_empty() const { return lowest_ == none; }
  std::size_t capacity() const { return nodes_.size(); }

  /// The lowest node for which `is_above(branch)`, "the place sought is above it", is false; none if it is true for
  /// all.
  template <class IsAbove>
  std::uint32_t lowest_not_below(const IsAbove& is_above) const {
    if (order_.empty()) return none;
    // The last chunk whose first node is still below the place; the node sought is inside it or the next one's first.
    std::size_t low = 0;
    std::size_t high = order_.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (is_above(nodes_[chunks_[order_[middle]].nodes[0]].branch)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low == 0) return lowest_;
    const Chunk& chunk = chunks_[order_[low - 1]];
    std::uint32_t first = 1;
    std::uint32_t last = chunk.count;
    while (first < last) {
      const std::uint32_t middle = (first + last) / 2;
      if (is_above(nodes_[chunk.nodes[middle]].branch)) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    if (first < chunk.count) return chunk.nodes[first];
    return low < order_.size() ? chunks_[order_[low]].nodes[0] : none;
  }

  /// A new node just above `below`, or at the bottom if that is none.
  std::uint32_t insert_above(std::uint32_t below);
  void erase(std::uint32_t node);

 private:
  static constexpr std::uint32_t chunk_size = 64;
  struct Chunk {
    std::uint32_t count = 0;
    std::uint32_t place = 0;  // in order_
    std::array<std::uint32_t, chunk_size> nodes;
  };

  std::uint32_t new_node();
  std::uint32_t new_chunk(std::size_t place);
  void split(std::uint32_t chunk);
  void put(std::uint32_t chunk, std::uint32_t index, std::uint32_t node);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_nodes_;
  std::vector<Chunk> chunks_;
  std::vector<std::uint32_t> free_chunks_;
  std::vector<std::uint32_t> order_;  // chunks from bottom to top
  std::uint32_t lowest_ = none;
  std::uint32_t highest_ = none;
};

}  // namespace quoin
