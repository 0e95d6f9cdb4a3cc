// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/box_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "quoin/base/parallel.h"
#include "quoin/solid/morton_order.h"

namespace quoin {

namespace {

constexpr std::size_t leaf_size = 16;

// The first half by the highest bit in which sorted keys differ, or of equal keys.
std::size_t split_at(std::span<const std::uint32_t> keys) {
  const std::uint32_t difference = keys.front() ^ keys.back();
  if (difference == 0) return keys.size() / 2;
  const std::uint32_t bit = std::bit_floor(difference);
  const auto split =
      std::partition_point(keys.begin(), keys.end(), [&](std::uint32_t key) { return (key & bit) == 0; });
  return static_cast<std::size_t>(split - keys.begin());
}

}  // namespace

BoxTree::BoxTree(std::span<const Point3> vertices, std::span<const Tile> tiles, const Context& context)
    : size_(tiles.size()) {
  if (tiles.empty()) return;
  std::vector<FloatBox> boxes(tiles.size());
  for_each_chunk(context, tiles.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) boxes[i] = box_of(vertices, tiles[i]);
  });
  build(boxes, context);
}

BoxTree::BoxTree(std::span<const FloatBox> boxes, const Context& context) : size_(boxes.size()) {
  if (!boxes.empty()) build(boxes, context);
}

void BoxTree::build(std::span<const FloatBox> boxes, const Context& context) {
  FloatBox all = empty_box();
  for (const FloatBox& box : boxes) extend(all, box);
  const MortonOrder morton = morton_order(boxes, all, context);
  nodes_.reserve(boxes.size() / 4 + 1);
  blocks_.reserve(boxes.size() / 3 + 1);
  block_tiles_.reserve(boxes.size() / 3 + 1);
  build(morton.keys, morton.order, boxes);
}

// Recursion is at most 30 deep by key bits, and then halves runs of equal keys.
std::uint32_t BoxTree::build(std::span<const std::uint32_t> keys, std::span<const std::uint32_t> order,
                             std::span<const FloatBox> boxes) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({empty_box(), static_cast<std::uint32_t>(blocks_.size()), 0});
  if (keys.size() <= leaf_size) {
    fill_leaf(index, order, boxes);
    return index;
  }
  const std::size_t middle = split_at(keys);
  const std::uint32_t left = build(keys.first(middle), order.first(middle), boxes);
  const std::uint32_t right = build(keys.subspan(middle), order.subspan(middle), boxes);
  FloatBox box = nodes_[left].box;
  extend(box, nodes_[right].box);
  nodes_[index] = {box, right, 0};
  return index;
}

void BoxTree::fill_leaf(std::uint32_t node, std::span<const std::uint32_t> order, std::span<const FloatBox> boxes) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % 4 == 0) {
      blocks_.push_back(BoxBlock::empty());
      block_tiles_.push_back({});
      ++nodes_[node].block_count;
    }
    const FloatBox& box = boxes[order[i]];
    blocks_.back().set(i % 4, box);
    block_tiles_.back()[i % 4] = order[i];
    extend(nodes_[node].box, box);
  }
}

std::array<float, 6> BoxTree::bounds() const {
  const FloatBox box = nodes_.empty() ? empty_box() : nodes_[0].box;
  return {box.lo[0], box.lo[1], box.lo[2], box.hi[0], box.hi[1], box.hi[2]};
}

template <class Accept>
void BoxTree::collect(const Accept& accept, std::vector<std::uint32_t>& out) const {
  if (nodes_.empty() || !accept(nodes_[0].box)) return;
  std::array<std::uint32_t, 128> stack;  // depth is below 30 + 32
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const std::uint32_t n = stack[--height];
    const Node& node = nodes_[n];
    for (std::uint32_t b = node.second_or_block; b < node.second_or_block + node.block_count; ++b) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (accept(blocks_[b].at(lane))) out.push_back(block_tiles_[b][lane]);
      }
    }
    if (node.block_count != 0) continue;
    if (accept(nodes_[node.second_or_block].box)) stack[height++] = node.second_or_block;
    if (accept(nodes_[n + 1].box)) stack[height++] = n + 1;
  }
}

void BoxTree::tiles_on_line(unsigned axis, std::array<double, 2> lo, std::array<double, 2> hi,
                            std::vector<std::uint32_t>& out) const {
  const std::array<std::size_t, 2> axes{(axis + 1) % 3, (axis + 2) % 3};
  const std::array<float, 2> low{float_below(lo[0]), float_below(lo[1])};
  const std::array<float, 2> high{float_above(hi[0]), float_above(hi[1])};
  collect(
      [&](const FloatBox& box) {
        return box.lo[axes[0]] <= high[0] && low[0] <= box.hi[axes[0]] && box.lo[axes[1]] <= high[1] &&
               low[1] <= box.hi[axes[1]];
      },
      out);
}

// Along each axis k, the box and the line are projected along that axis: the box meets the projected line where the
// distance of its centre, times the line's length, is at most that of its corners. Every product is off by a few units
// of 2^-53 of the factors' sizes, which the margin of 2^-40 of them outdoes; what is not a number is taken as near.
void BoxTree::tiles_near_line(const Point3& point, const Vector3& direction, std::vector<std::uint32_t>& out) const {
  collect(
      [&](const FloatBox& box) {
        if (!(box.lo[0] <= box.hi[0])) return false;
        for (unsigned k = 0; k < 3; ++k) {
          const unsigned u = (k + 1) % 3;
          const unsigned v = (k + 2) % 3;
          const double cu = (double{box.lo[u]} + double{box.hi[u]}) / 2;
          const double cv = (double{box.lo[v]} + double{box.hi[v]}) / 2;
          const double hu = (double{box.hi[u]} - double{box.lo[u]}) / 2;
          const double hv = (double{box.hi[v]} - double{box.lo[v]}) / 2;
          const double du = std::fabs(direction[u]);
          const double dv = std::fabs(direction[v]);
          const double distance = direction[u] * (cv - point[v]) - direction[v] * (cu - point[u]);
          const double margin = 0x1p-40 * (du * (std::fabs(cv) + hv + std::fabs(point[v])) +
                                           dv * (std::fabs(cu) + hu + std::fabs(point[u]))) +
                                1e-300;
          if (std::fabs(distance) > du * hv + dv * hu + margin) return false;
        }
        return true;
      },
      out);
}

void BoxTree::tiles_in_box(const Point3& lo, const Point3& hi, std::vector<std::uint32_t>& out) const {
  const FloatBox query{{float_below(lo.x), float_below(lo.y), float_below(lo.z)},
                       {float_above(hi.x), float_above(hi.y), float_above(hi.z)}};
  collect([&](const FloatBox& box) { return meet(box, query); }, out);
}

}  // namespace quoin
