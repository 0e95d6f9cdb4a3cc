// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/solid/box_tree.h"

namespace quoin {

namespace {

/// At most the square of the distance of two boxes, the first moved: the vector and two sums are off by 2^-52 of
/// themselves, the squares of floats' differences are not below the range of doubles.
double squared_gap(const FloatBox& a, const Vector3& by, const FloatBox& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = static_cast<double>(a.lo[k]) + by[k];
    const double high = static_cast<double>(a.hi[k]) + by[k];
    const double above = static_cast<double>(b.lo[k]) - high;
    const double below = low - static_cast<double>(b.hi[k]);
    const double error = by[k] == 0 ? 0 : 0x1p-50 * (std::fabs(by[k]) + std::fabs(low) + std::fabs(high));
    const double gap = std::max(above, below) * (1 - 0x1p-50) - error;
    if (gap > 0) sum += gap * gap;  // not if it is not a number
  }
  return sum * (1 - 0x1p-50);
}

}  // namespace

/// Descends depth first into the nearer of two pairs of nodes.
class BoxTreeNearest {
 public:
  using Visit = std::function<double(const TilePair&)>;

  BoxTreeNearest(const BoxTree& a, const BoxTree& b, const Vector3& by, const Visit& visit, const Context& context)
      : a_(a), b_(b), by_(by), visit_(visit), context_(context) {}

  void run() {
    if (a_.nodes_.empty() || b_.nodes_.empty()) return;
    stack_.push_back(pair_of(0, 0));
    for (std::size_t steps = 1; !stack_.empty(); ++steps) {
      if (steps % 256 == 0) context_.poll();
      const NodePair pair = stack_.back();
      stack_.pop_back();
      if (pair.gap > bound_) continue;
      const BoxTree::Node& x = a_.nodes_[pair.a];
      const BoxTree::Node& y = b_.nodes_[pair.b];
      if (x.block_count != 0 && y.block_count != 0) {
        visit_leaves(x, y);
      } else if (y.block_count != 0 || (x.block_count == 0 && extent(x) >= extent(y))) {
        push(pair_of(pair.a + 1, pair.b), pair_of(x.second_or_block, pair.b));
      } else {
        push(pair_of(pair.a, pair.b + 1), pair_of(pair.a, y.second_or_block));
      }
    }
  }

 private:
  struct NodePair {
    std::uint32_t a;
    std::uint32_t b;
    double gap;
  };

  NodePair pair_of(std::uint32_t i, std::uint32_t j) const {
    return {i, j, squared_gap(a_.nodes_[i].box, by_, b_.nodes_[j].box)};
  }
  void push(const NodePair& one, const NodePair& other) {
    const bool is_first_nearer = one.gap <= other.gap;
    for (const NodePair& pair : {is_first_nearer ? other : one, is_first_nearer ? one : other}) {
      if (pair.gap <= bound_) stack_.push_back(pair);
    }
  }
  static float extent(const BoxTree::Node& n) {
    return (n.box.hi[0] - n.box.lo[0]) + (n.box.hi[1] - n.box.lo[1]) + (n.box.hi[2] - n.box.lo[2]);
  }
  void visit_leaves(const BoxTree::Node& x, const BoxTree::Node& y) {
    a_.for_each_tile(x.second_or_block, x.second_or_block + x.block_count, [&](std::uint32_t i, std::uint32_t slot) {
      const FloatBox box = a_.blocks_[slot / 4].at(slot % 4);
      if (squared_gap(box, by_, y.box) > bound_) return;
      b_.for_each_tile(y.second_or_block, y.second_or_block + y.block_count, [&](std::uint32_t j, std::uint32_t other) {
        if (squared_gap(box, by_, b_.blocks_[other / 4].at(other % 4)) <= bound_) bound_ = visit_({i, j});
      });
    });
  }

  const BoxTree& a_;
  const BoxTree& b_;
  const Vector3 by_;
  const Visit& visit_;
  const Context& context_;
  double bound_ = std::numeric_limits<double>::infinity();
  std::vector<NodePair> stack_;
};

void BoxTree::nearest_pairs(const BoxTree& a, const BoxTree& b, const Vector3& by,
                            const std::function<double(const TilePair&)>& visit, const Context& context) {
  BoxTreeNearest(a, b, by, visit, context).run();
}

}  // namespace quoin
