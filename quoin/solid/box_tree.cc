// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/box_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "quoin/base/parallel.h"

namespace quoin {

namespace {

using Box = BoxTree::Box;

constexpr std::uint32_t leaf_size = 8;
constexpr float infinity = std::numeric_limits<float>::infinity();

float round_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafterf(f, -infinity) : f;
}

float round_up(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafterf(f, infinity) : f;
}

Box empty_box() {
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

void extend(Box& box, const Box& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = std::min(box.lo[k], other.lo[k]);
    box.hi[k] = std::max(box.hi[k], other.hi[k]);
  }
}

bool meet(const Box& a, const Box& b) {
  return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] && a.lo[2] <= b.hi[2] &&
         b.lo[2] <= a.hi[2];
}

Box box_of(std::span<const Point3> vertices, const Tile& tile) {
  const Point3& p = vertices[tile[0]];
  const Point3& q = vertices[tile[1]];
  const Point3& r = vertices[tile[2]];
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = round_down(std::min({p[k], q[k], r[k]}));
    box.hi[k] = round_up(std::max({p[k], q[k], r[k]}));
  }
  return box;
}

std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFU;
  x = (x | (x << 8)) & 0x0300F00FU;
  x = (x | (x << 4)) & 0x030C30C3U;
  return (x | (x << 2)) & 0x09249249U;
}

// Morton keys of 30 bits of the box centres within the box of everything. Their quality matters, not their exactness.
std::vector<std::uint32_t> morton_keys(std::span<const Box> boxes, const Box& all, const Context& context) {
  std::array<float, 3> scale;
  for (std::size_t k = 0; k < 3; ++k) {
    const float extent = all.hi[k] / 2 - all.lo[k] / 2;
    scale[k] = extent > 0 && std::isfinite(extent) ? 1023.0F / extent : 0.0F;
    if (!std::isfinite(scale[k])) scale[k] = 0;
  }
  std::vector<std::uint32_t> keys(boxes.size());
  for_each_chunk(context, boxes.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      std::uint32_t key = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const float centre = (boxes[i].lo[k] / 2 - all.lo[k] / 2) / 2 + (boxes[i].hi[k] / 2 - all.lo[k] / 2) / 2;
        const float cell = std::clamp(centre * scale[k], 0.0F, 1023.0F);
        key |= spread_bits(cell == cell ? static_cast<std::uint32_t>(cell) : 0U) << (2 - k);
      }
      keys[i] = key;
    }
  });
  return keys;
}

// Sorts indices by 30-bit keys, stable, in three passes of 10 bits.
void radix_sort(std::vector<std::uint32_t>& keys, std::vector<std::uint32_t>& order, const Context& context) {
  std::vector<std::uint32_t> other_keys(keys.size());
  std::vector<std::uint32_t> other_order(order.size());
  for (unsigned shift = 0; shift < 30; shift += 10) {
    context.poll();
    std::array<std::uint32_t, 1025> first{};
    for (const std::uint32_t key : keys) ++first[((key >> shift) & 1023U) + 1];
    for (std::size_t b = 0; b < 1024; ++b) first[b + 1] += first[b];
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::uint32_t at = first[(keys[i] >> shift) & 1023U]++;
      other_keys[at] = keys[i];
      other_order[at] = order[i];
    }
    keys.swap(other_keys);
    order.swap(other_order);
  }
}

}  // namespace

BoxTree::BoxTree(std::span<const Point3> vertices, std::span<const Tile> tiles, const Context& context) {
  if (tiles.empty()) return;
  std::vector<Box> boxes(tiles.size());
  for_each_chunk(context, tiles.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) boxes[i] = box_of(vertices, tiles[i]);
  });
  Box all = empty_box();
  for (const Box& box : boxes) extend(all, box);
  std::vector<std::uint32_t> keys = morton_keys(boxes, all, context);
  tiles_.resize(tiles.size());
  for (std::uint32_t i = 0; i < tiles.size(); ++i) tiles_[i] = i;
  radix_sort(keys, tiles_, context);
  boxes_.resize(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) boxes_[i] = boxes[tiles_[i]];
  nodes_.reserve(tiles.size() / 2 + 1);
  build(keys, 0, static_cast<std::uint32_t>(tiles.size()));
}

// Recursion is at most 30 deep by key bits, and then halves runs of equal keys.
std::uint32_t BoxTree::build(std::span<const std::uint32_t> keys, std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({empty_box(), begin, end - begin});
  if (end - begin <= leaf_size) {
    for (std::uint32_t i = begin; i < end; ++i) extend(nodes_[index].box, boxes_[i]);
    return index;
  }
  std::uint32_t middle = begin + (end - begin) / 2;
  const std::uint32_t difference = keys[begin] ^ keys[end - 1];
  if (difference != 0) {
    const std::uint32_t bit = std::bit_floor(difference);
    const auto first = keys.begin() + begin;
    const auto split =
        std::partition_point(first, keys.begin() + end, [&](std::uint32_t key) { return (key & bit) == 0; });
    middle = begin + static_cast<std::uint32_t>(split - first);
  }
  const std::uint32_t left = build(keys, begin, middle);
  const std::uint32_t right = build(keys, middle, end);
  Box box = nodes_[left].box;
  extend(box, nodes_[right].box);
  nodes_[index] = {box, right, 0};
  return index;
}

std::array<float, 6> BoxTree::bounds() const {
  const Box box = nodes_.empty() ? empty_box() : nodes_[0].box;
  return {box.lo[0], box.lo[1], box.lo[2], box.hi[0], box.hi[1], box.hi[2]};
}

// The pairs of children that meet; the larger node is opened, so that both sides shrink alike.
void BoxTree::expand(const BoxTree& a, const BoxTree& b, bool is_self, NodePair pair, std::vector<NodePair>& out) {
  const Node& x = a.nodes_[pair.a];
  const Node& y = b.nodes_[pair.b];
  const auto push = [&](std::uint32_t i, std::uint32_t j) {
    if (meet(a.nodes_[i].box, b.nodes_[j].box)) out.push_back({i, j});
  };
  if (is_self && pair.a == pair.b) {
    push(x.second_or_first, x.second_or_first);
    push(pair.a + 1, x.second_or_first);
    push(pair.a + 1, pair.a + 1);
    return;
  }
  const auto size = [](const Node& n) {
    return n.count != 0 ? -1.0F
                        : (n.box.hi[0] - n.box.lo[0]) + (n.box.hi[1] - n.box.lo[1]) + (n.box.hi[2] - n.box.lo[2]);
  };
  if (y.count != 0 || (x.count == 0 && size(x) >= size(y))) {
    push(x.second_or_first, pair.b);
    push(pair.a + 1, pair.b);
  } else {
    push(pair.a, y.second_or_first);
    push(pair.a, pair.b + 1);
  }
}

void BoxTree::report(const BoxTree& a, const BoxTree& b, bool is_self, NodePair pair, std::vector<TilePair>& out) {
  const Node& x = a.nodes_[pair.a];
  const Node& y = b.nodes_[pair.b];
  const bool same = is_self && pair.a == pair.b;
  for (std::uint32_t i = x.second_or_first; i < x.second_or_first + x.count; ++i) {
    if (!meet(a.boxes_[i], y.box)) continue;
    for (std::uint32_t j = same ? i + 1 : y.second_or_first; j < y.second_or_first + y.count; ++j) {
      if (!meet(a.boxes_[i], b.boxes_[j])) continue;
      const std::uint32_t s = a.tiles_[i];
      const std::uint32_t t = b.tiles_[j];
      out.push_back(is_self && t < s ? TilePair{t, s} : TilePair{s, t});
    }
  }
}

// Opens node pairs breadth first into tasks, whose number depends on the trees alone, and lets each task descend depth
// first.
std::vector<TilePair> BoxTree::descend(const BoxTree& a, const BoxTree& b, bool is_self,
                                       const std::function<bool(const TilePair&)>* keep, const Context& context) {
  std::vector<TilePair> result;
  if (a.nodes_.empty() || b.nodes_.empty() || !meet(a.nodes_[0].box, b.nodes_[0].box)) return result;
  const auto is_final = [&](NodePair p) { return a.nodes_[p.a].count != 0 && b.nodes_[p.b].count != 0; };
  std::vector<NodePair> tasks{{0, 0}};
  std::vector<NodePair> next;
  for (int level = 0; level < 12 && tasks.size() < 256; ++level) {
    next.clear();
    for (const NodePair pair : tasks) {
      if (is_final(pair)) {
        next.push_back(pair);
      } else {
        expand(a, b, is_self, pair, next);
      }
    }
    tasks.swap(next);
  }
  std::vector<std::vector<TilePair>> found(tasks.size());
  for_each_chunk(context, tasks.size(), 1, [&](const Chunk& chunk) {
    std::vector<NodePair> stack{tasks[chunk.index]};
    std::size_t steps = 0;
    while (!stack.empty()) {
      if (++steps % 4096 == 0) context.poll();
      const NodePair pair = stack.back();
      stack.pop_back();
      if (is_final(pair)) {
        std::vector<TilePair>& out = found[chunk.index];
        const std::size_t before = out.size();
        report(a, b, is_self, pair, out);
        if (keep != nullptr) {
          const auto first = out.begin() + static_cast<std::ptrdiff_t>(before);
          out.erase(std::remove_if(first, out.end(), [&](const TilePair& p) { return !(*keep)(p); }), out.end());
        }
      } else {
        expand(a, b, is_self, pair, stack);
      }
    }
  });
  std::size_t count = 0;
  for (const auto& part : found) count += part.size();
  result.reserve(count);
  for (const auto& part : found) result.insert(result.end(), part.begin(), part.end());
  return result;
}

std::vector<TilePair> BoxTree::pairs(const BoxTree& a, const BoxTree& b, const Context& context) {
  return descend(a, b, false, nullptr, context);
}

std::vector<TilePair> BoxTree::self_pairs(const Context& context) const {
  return descend(*this, *this, true, nullptr, context);
}

std::vector<TilePair> BoxTree::self_pairs(const std::function<bool(const TilePair&)>& keep,
                                          const Context& context) const {
  return descend(*this, *this, true, &keep, context);
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
    if (node.count != 0) {
      for (std::uint32_t i = node.second_or_first; i < node.second_or_first + node.count; ++i) {
        if (accept(boxes_[i])) out.push_back(tiles_[i]);
      }
      continue;
    }
    if (accept(nodes_[node.second_or_first].box)) stack[height++] = node.second_or_first;
    if (accept(nodes_[n + 1].box)) stack[height++] = n + 1;
  }
}

void BoxTree::tiles_on_line(unsigned axis, std::array<double, 2> lo, std::array<double, 2> hi,
                            std::vector<std::uint32_t>& out) const {
  const std::array<std::size_t, 2> axes{(axis + 1) % 3, (axis + 2) % 3};
  const std::array<float, 2> low{round_down(lo[0]), round_down(lo[1])};
  const std::array<float, 2> high{round_up(hi[0]), round_up(hi[1])};
  collect(
      [&](const Box& box) {
        return box.lo[axes[0]] <= high[0] && low[0] <= box.hi[axes[0]] && box.lo[axes[1]] <= high[1] &&
               low[1] <= box.hi[axes[1]];
      },
      out);
}

void BoxTree::tiles_in_box(const Point3& lo, const Point3& hi, std::vector<std::uint32_t>& out) const {
  const Box query{{round_down(lo.x), round_down(lo.y), round_down(lo.z)},
                  {round_up(hi.x), round_up(hi.y), round_up(hi.z)}};
  collect([&](const Box& box) { return meet(box, query); }, out);
}

}  // namespace quoin
