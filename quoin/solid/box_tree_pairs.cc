// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "quoin/base/parallel.h"
#include "quoin/solid/box_tree.h"

namespace quoin {

namespace {

using Mask = BoxBlock::Mask;

constexpr Tile no_labels{BoxTree::no_label, BoxTree::no_label, BoxTree::no_label};

bool have_label(const Tile& labels, std::uint32_t label) {
  return label != BoxTree::no_label && (label == labels[0] || label == labels[1] || label == labels[2]);
}

// The labels that both have.
Tile common_labels(const Tile& a, const Tile& b) {
  Tile result = no_labels;
  for (std::size_t k = 0; k < 3; ++k) {
    if (have_label(b, a[k])) result[k] = a[k];
  }
  return result;
}

}  // namespace

// One query for pairs: opens node pairs breadth first into tasks, whose number depends on the trees alone, and lets
// each task descend depth first.
class BoxTreePairs {
 public:
  using Keep = std::function<bool(const TilePair&)>;

  BoxTreePairs(const BoxTree& a, const BoxTree& b, bool is_self, const Context& context)
      : a_(a), b_(b), is_self_(is_self), context_(context) {}
  BoxTreePairs(const BoxTree& tree, const BoxTree::Excluded& excluded, const Keep& keep, const Context& context)
      : a_(tree),
        b_(tree),
        is_self_(true),
        labels_(excluded.labels),
        excluded_subtrees_(excluded.subtrees),
        keep_(&keep),
        context_(context) {}

  std::vector<TilePair> run() {
    if (a_.nodes_.empty() || b_.nodes_.empty() || !meet(a_.nodes_[0].box, b_.nodes_[0].box)) return {};
    gather_labels();
    const std::vector<NodePair> tasks = make_tasks();
    std::vector<std::vector<TilePair>> found(tasks.size());
    for_each_chunk(context_, tasks.size(), 1,
                   [&](const Chunk& chunk) { descend(tasks[chunk.index], found[chunk.index]); });
    std::size_t count = 0;
    for (const auto& part : found) count += part.size();
    std::vector<TilePair> result;
    result.reserve(count);
    for (const auto& part : found) result.insert(result.end(), part.begin(), part.end());
    return result;
  }

 private:
  using Node = BoxTree::Node;
  struct NodePair {
    std::uint32_t a;
    std::uint32_t b;
  };

  void gather_labels() {
    if (labels_.empty()) return;
    node_labels_.resize(a_.nodes_.size());
    for (std::size_t n = a_.nodes_.size(); n-- > 0;) {  // children come after their parents
      if (n % 4096 == 0) context_.poll();
      const Node& node = a_.nodes_[n];
      node_labels_[n] = node.block_count != 0 ? labels_of_leaf(node)
                                              : common_labels(node_labels_[n + 1], node_labels_[node.second_or_block]);
    }
  }

  Tile labels_of_leaf(const Node& node) const {
    Tile result = labels_[a_.block_tiles_[node.second_or_block][0]];
    for (std::uint32_t block = node.second_or_block; block < node.second_or_block + node.block_count; ++block) {
      for (std::size_t lane = 0; lane < 4 && result != no_labels; ++lane) {
        if (!std::isnan(a_.blocks_[block].lo[0][lane]))
          result = common_labels(result, labels_[a_.block_tiles_[block][lane]]);
      }
    }
    return result;
  }

  // All tiles of one node share a label with all tiles of the other, so that no pair is left.
  bool have_common_label(std::uint32_t i, std::uint32_t j) const {
    if (node_labels_.empty()) return false;
    const Tile& labels = node_labels_[i];
    return labels != no_labels && common_labels(labels, node_labels_[j]) != no_labels;
  }

  bool is_final(NodePair pair) const {
    return a_.nodes_[pair.a].block_count != 0 && b_.nodes_[pair.b].block_count != 0;
  }

  std::vector<NodePair> make_tasks() const {
    std::vector<NodePair> tasks;
    if (is_self_) {
      push_self(0, tasks);
    } else {
      tasks.push_back({0, 0});
    }
    std::vector<NodePair> next;
    for (int level = 0; level < 12 && tasks.size() < 256; ++level) {
      next.clear();
      for (const NodePair pair : tasks) {
        if (is_final(pair)) {
          next.push_back(pair);
        } else {
          expand(pair, next);
        }
      }
      tasks.swap(next);
    }
    return tasks;
  }

  void descend(NodePair top, std::vector<TilePair>& out) const {
    std::vector<NodePair> stack{top};
    std::size_t steps = 0;
    while (!stack.empty()) {
      if (++steps % 4096 == 0) context_.poll();
      const NodePair pair = stack.back();
      stack.pop_back();
      if (is_final(pair)) {
        report(pair, out);
      } else {
        expand(pair, stack);
      }
    }
  }

  // The pairs of children that meet; the larger node is opened, so that both sides shrink alike.
  void expand(NodePair pair, std::vector<NodePair>& out) const {
    const Node& x = a_.nodes_[pair.a];
    const Node& y = b_.nodes_[pair.b];
    if (is_self_ && pair.a == pair.b) {
      push_self(x.second_or_block, out);
      push(pair.a + 1, x.second_or_block, out);
      push_self(pair.a + 1, out);
      return;
    }
    if (y.block_count != 0 || (x.block_count == 0 && extent(x) >= extent(y))) {
      push(x.second_or_block, pair.b, out);
      push(pair.a + 1, pair.b, out);
    } else {
      push(pair.a, y.second_or_block, out);
      push(pair.a, pair.b + 1, out);
    }
  }

  void push(std::uint32_t i, std::uint32_t j, std::vector<NodePair>& out) const {
    if (meet(a_.nodes_[i].box, b_.nodes_[j].box) && !have_common_label(i, j)) out.push_back({i, j});
  }

  void push_self(std::uint32_t i, std::vector<NodePair>& out) const {
    if (excluded_subtrees_.empty() || excluded_subtrees_[i] == 0) push(i, i, out);
  }

  static float extent(const Node& n) {
    return (n.box.hi[0] - n.box.lo[0]) + (n.box.hi[1] - n.box.lo[1]) + (n.box.hi[2] - n.box.lo[2]);
  }

  void report(NodePair pair, std::vector<TilePair>& out) const {
    const Node& x = a_.nodes_[pair.a];
    const Node& y = b_.nodes_[pair.b];
    const bool same = is_self_ && pair.a == pair.b;
    std::array<std::uint32_t, 4> candidates;
    std::size_t count = 0;
    for (std::uint32_t q = y.second_or_block; q < y.second_or_block + y.block_count; ++q) {
      if (same || is_any(b_.blocks_[q].meets(x.box))) candidates[count++] = q;
    }
    for (std::uint32_t p = x.second_or_block; p < x.second_or_block + x.block_count; ++p) {
      const Mask alive = a_.blocks_[p].meets(y.box);
      if (!is_any(alive)) continue;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (alive[lane] == 0) continue;
        const FloatBox box = a_.blocks_[p].at(lane);
        for (std::size_t c = 0; c < count; ++c) {
          const std::uint32_t q = candidates[c];
          if (same && q < p) continue;
          Mask hits = b_.blocks_[q].meets(box);
          if (same && p == q) hits &= after(lane);
          if (is_any(hits)) add(p, lane, q, hits, out);
        }
      }
    }
  }

  static Mask after(std::size_t lane) {
    constexpr Mask lanes = {0, 1, 2, 3};
    return lanes > static_cast<std::int32_t>(lane);
  }

  void add(std::uint32_t p, std::size_t lane, std::uint32_t q, const Mask& hits, std::vector<TilePair>& out) const {
    const std::uint32_t s = a_.block_tiles_[p][lane];
    for (std::size_t other = 0; other < 4; ++other) {
      if (hits[other] == 0) continue;
      const std::uint32_t t = b_.block_tiles_[q][other];
      if (!labels_.empty() && common_labels(labels_[s], labels_[t]) != no_labels) continue;
      const TilePair pair = is_self_ && t < s ? TilePair{t, s} : TilePair{s, t};
      if (keep_ == nullptr || (*keep_)(pair)) out.push_back(pair);
    }
  }

  const BoxTree& a_;
  const BoxTree& b_;
  bool is_self_;
  std::span<const Tile> labels_;
  std::span<const std::uint8_t> excluded_subtrees_;  // per node of a_, or empty
  std::vector<Tile> node_labels_;                    // per node of a_: what all its tiles share; empty without labels
  const Keep* keep_ = nullptr;
  const Context& context_;
};

std::vector<TilePair> BoxTree::pairs(const BoxTree& a, const BoxTree& b, const Context& context) {
  return BoxTreePairs(a, b, false, context).run();
}

std::vector<TilePair> BoxTree::self_pairs(const Context& context) const {
  return BoxTreePairs(*this, *this, true, context).run();
}

std::vector<TilePair> BoxTree::self_pairs(const Excluded& excluded, const std::function<bool(const TilePair&)>& keep,
                                          const Context& context) const {
  return BoxTreePairs(*this, excluded, keep, context).run();
}

}  // namespace quoin
