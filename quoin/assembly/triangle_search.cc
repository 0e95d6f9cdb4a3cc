// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/triangle_search.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "quoin/assembly/blocking_graph.h"

namespace quoin {

namespace {

using OrderedPair = std::array<std::uint32_t, 2>;

/// A triangle with what is settled of its pairs.
struct Node {
  DirectionTriangle triangle;
  BlockingGraph blocked;
  std::vector<OrderedPair> mixed;
};

/// Inside the arc between two directions, about in the middle.
RegionDirection between(const RegionDirection& a, const RegionDirection& b) {
  const int shift = static_cast<int>(b.exact().bits()) - static_cast<int>(a.exact().bits());
  std::array<Integer, 3> sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Integer first = a.exact().integer(axis);
    Integer second = b.exact().integer(axis);
    if (shift > 0) first <<= static_cast<std::size_t>(shift);
    if (shift < 0) second <<= static_cast<std::size_t>(-shift);
    sum[axis] = first + second;
  }
  return SphereDirection(sum);
}

PairState state_of(const ConvexRegion& region, const std::array<RegionDirection, 3>& corners) {
  bool is_inside = true;
  for (const RegionDirection& normal : region.normals) {
    int positive = 0;
    for (const RegionDirection& corner : corners) positive += dot_sign(normal, corner) == Sign::positive ? 1 : 0;
    if (positive == 0) return PairState::never_blocked;
    is_inside = is_inside && positive == 3;
  }
  return is_inside ? PairState::always_blocked : PairState::mixed;
}

PairState state_of(const PartPair& pair, const std::array<RegionDirection, 3>& corners) {
  if (pair.bounds && state_of(*pair.bounds, corners) == PairState::never_blocked) return PairState::never_blocked;
  PairState state = PairState::never_blocked;
  for (const ConvexRegion& region : pair.pieces) {
    const PairState here = state_of(region, corners);
    if (here == PairState::always_blocked) return here;
    if (here == PairState::mixed) state = here;
  }
  return state;
}

class TriangleSearch {
 public:
  TriangleSearch(const PairRegions& pairs, std::size_t most, const Context& context)
      : pairs_(pairs), most_(most), context_(context), everything_(PartSet::all(pairs.part_count)) {}

  UnsettledDirections run() {
    begin();
    std::size_t tried = 0;
    while (!pending_.empty()) {
      context_.progress("triangles of directions", static_cast<double>(tried) / static_cast<double>(most_));
      Node node = std::move(pending_.front());
      pending_.pop_front();
      settle(node);
      if (node.blocked.is_strongly_connected(everything_)) continue;
      if (node.mixed.empty() || ++tried >= most_) {
        left_.push_back(std::move(node));
      } else {
        divide(node);
      }
    }
    return summary();
  }

 private:
  void begin() {
    std::vector<OrderedPair> all;
    for (const PartPair& pair : pairs_.pairs) {
      all.push_back({pair.first, pair.second});
      all.push_back({pair.second, pair.first});
    }
    for (const std::int64_t x : {1, -1}) {
      for (const std::int64_t y : {1, -1}) {
        for (const std::int64_t z : {1, -1}) {
          const auto axis = [](std::int64_t a, std::int64_t b, std::int64_t c) {
            return RegionDirection(SphereDirection(std::array<std::int64_t, 3>{a, b, c}));
          };
          std::array corners{axis(x, 0, 0), axis(0, y, 0), axis(0, 0, z)};
          if (x * y * z < 0) std::swap(corners[0], corners[1]);
          pending_.push_back({DirectionTriangle(corners), BlockingGraph(pairs_.part_count), all});
        }
      }
    }
  }
  /// Of a part of a triangle, what was settled stays so.
  void settle(Node& node) const {
    const std::array<RegionDirection, 3>& corners = node.triangle.corners;
    const std::array opposite{-corners[0], -corners[1], -corners[2]};
    std::size_t since_poll = 0;
    std::erase_if(node.mixed, [&](const OrderedPair& both) {
      if (++since_poll % 64 == 0) context_.poll();
      const auto [moving, other] = both;
      const PairState state = moving < other ? state_of(pairs_.pair(moving, other), corners)
                                             : state_of(pairs_.pair(other, moving), opposite);
      if (state == PairState::always_blocked) node.blocked.set_arc(moving, other, true);
      return state != PairState::mixed;
    });
  }
  void divide(const Node& node) {
    const auto& [a, b, c] = node.triangle.corners;
    const RegionDirection ab = between(a, b);
    const RegionDirection bc = between(b, c);
    const RegionDirection ca = between(c, a);
    for (const std::array<RegionDirection, 3>& corners :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
      pending_.push_back({DirectionTriangle(corners), node.blocked, node.mixed});
    }
  }
  UnsettledDirections summary() {
    const std::size_t n = pairs_.part_count;
    UnsettledDirections result;
    for (std::size_t k = 0; k < left_.size(); ++k) {
      const Node& node = left_[k];
      std::vector<PairState> states(n * n, PairState::never_blocked);
      for (const auto& [i, j] : node.mixed) states[i * n + j] = PairState::mixed;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          if (node.blocked.has_arc(i, j)) states[i * n + j] = PairState::always_blocked;
        }
      }
      if (k == 0) result.states = states;
      for (std::size_t p = 0; p < states.size(); ++p) {
        if (states[p] != result.states[p]) result.states[p] = PairState::mixed;
      }
      result.triangles.push_back(node.triangle);
    }
    if (left_.empty()) result.states.assign(n * n, PairState::never_blocked);
    return result;
  }

  const PairRegions& pairs_;
  std::size_t most_;
  const Context& context_;
  PartSet everything_;
  std::deque<Node> pending_;
  std::vector<Node> left_;
};

}  // namespace

DirectionTriangle::DirectionTriangle(const std::array<RegionDirection, 3>& its_corners)
    : corners(its_corners),
      inward{cross(corners[0], corners[1]), cross(corners[1], corners[2]), cross(corners[2], corners[0])} {}

bool DirectionTriangle::contains(const RegionDirection& direction) const {
  return std::ranges::none_of(
      inward, [&](const RegionDirection& normal) { return dot_sign(normal, direction) == Sign::negative; });
}

bool UnsettledDirections::contain(const RegionDirection& direction) const {
  return std::ranges::any_of(triangles,
                             [&](const DirectionTriangle& triangle) { return triangle.contains(direction); });
}

UnsettledDirections find_unsettled(const PairRegions& pairs, std::size_t most_triangles, const Context& context) {
  return TriangleSearch(pairs, most_triangles, context).run();
}

}  // namespace quoin
