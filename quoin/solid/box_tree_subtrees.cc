// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "quoin/base/parallel.h"
#include "quoin/solid/box_tree.h"

namespace quoin {

// One offer of subtrees: those of at most `largest` tiles are tasks, each of which descends where it is refused.
class SubtreeMarker {
 public:
  using Accept = std::function<bool(const BoxTree::Subtree&)>;

  SubtreeMarker(const BoxTree& tree, std::size_t smallest, std::size_t largest, const Accept& accept,
                const Context& context)
      : tree_(tree), smallest_(smallest), largest_(largest), accept_(accept), context_(context) {}

  BoxTree::Marked run() {
    BoxTree::Marked result;
    if (tree_.nodes_.empty()) return result;
    result.is_marked.assign(tree_.nodes_.size(), 0);
    const std::vector<std::uint32_t> tops = gather_tops();
    std::vector<std::vector<std::uint32_t>> others(tops.size());
    for_each_chunk(context_, tops.size(), 1,
                   [&](const Chunk& chunk) { descend(tops[chunk.index], result.is_marked, others[chunk.index]); });
    for (const auto& part : others) result.other_tiles.insert(result.other_tiles.end(), part.begin(), part.end());
    return result;
  }

 private:
  using Node = BoxTree::Node;

  std::vector<std::uint32_t> gather_tops() const {
    std::vector<std::uint32_t> tops;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
      const std::uint32_t n = stack.back();
      stack.pop_back();
      const Node& node = tree_.nodes_[n];
      if (node.block_count != 0 || 4 * (end_block(n) - first_block(n)) <= largest_) {
        tops.push_back(n);
      } else {
        stack.push_back(node.second_or_block);
        stack.push_back(n + 1);
      }
    }
    return tops;
  }

  std::uint32_t first_block(std::uint32_t n) const {
    while (tree_.nodes_[n].block_count == 0) ++n;
    return tree_.nodes_[n].second_or_block;
  }

  std::uint32_t end_block(std::uint32_t n) const {
    while (tree_.nodes_[n].block_count == 0) n = tree_.nodes_[n].second_or_block;
    return tree_.nodes_[n].second_or_block + tree_.nodes_[n].block_count;
  }

  void descend(std::uint32_t top, std::vector<std::uint8_t>& is_marked, std::vector<std::uint32_t>& others) const {
    std::vector<std::uint32_t> stack{top};
    std::vector<std::uint32_t> tiles;
    while (!stack.empty()) {
      context_.poll();
      const std::uint32_t n = stack.back();
      stack.pop_back();
      const std::uint32_t begin = first_block(n);
      const std::uint32_t end = end_block(n);
      gather_tiles(begin, end, tiles);
      const bool is_offered = tiles.size() >= smallest_;
      if (is_offered && accept_({tiles, 4 * begin, 4 * end})) {
        is_marked[n] = 1;
      } else if (!is_offered || tree_.nodes_[n].block_count != 0) {
        others.insert(others.end(), tiles.begin(), tiles.end());
      } else {
        stack.push_back(tree_.nodes_[n].second_or_block);
        stack.push_back(n + 1);
      }
    }
  }

  void gather_tiles(std::uint32_t begin, std::uint32_t end, std::vector<std::uint32_t>& tiles) const {
    tiles.clear();
    tree_.for_each_tile(begin, end, [&](std::uint32_t tile, std::uint32_t) { tiles.push_back(tile); });
  }

  const BoxTree& tree_;
  std::size_t smallest_;
  std::size_t largest_;
  const Accept& accept_;
  const Context& context_;
};

std::vector<std::uint32_t> BoxTree::slots() const {
  std::vector<std::uint32_t> result(size_);
  for_each_tile(0, static_cast<std::uint32_t>(blocks_.size()),
                [&](std::uint32_t tile, std::uint32_t slot) { result[tile] = slot; });
  return result;
}

BoxTree::Marked BoxTree::marked_subtrees(std::size_t smallest, std::size_t largest,
                                         const std::function<bool(const Subtree&)>& accept,
                                         const Context& context) const {
  return SubtreeMarker(*this, smallest, largest, accept, context).run();
}

}  // namespace quoin
