// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/disjoint_pairs.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "quoin/base/disjoint_sets.h"

namespace quoin {

namespace {

// Disjoint sets whose members are equal or opposite to that which stands for them, the smallest.
class OrientedSets {
 public:
  struct Root {
    std::uint32_t member;
    bool is_opposite;
  };

  explicit OrientedSets(std::size_t count) : parent_(count), is_opposite_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  Root find(std::uint32_t i) {
    bool is_opposite = false;
    while (parent_[i] != i) {
      const std::uint32_t p = parent_[i];
      is_opposite_[i] = static_cast<char>(is_opposite_[i] ^ is_opposite_[p]);  // of a root it is 0
      parent_[i] = parent_[p];
      is_opposite ^= is_opposite_[i] != 0;
      i = parent_[i];
    }
    return {i, is_opposite};
  }

  // Puts the greater root below the other.
  void unite(std::uint32_t greater, std::uint32_t smaller, bool is_opposite) {
    parent_[greater] = smaller;
    is_opposite_[greater] = static_cast<char>(is_opposite);
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> is_opposite_;
};

}  // namespace

void pair_components(const OrderedBoundaries& boundaries, const Context& context, const NotePair& note) {
  DisjointSets sets(boundaries.count(0));
  const auto edges = static_cast<std::uint32_t>(boundaries.count(1));
  for (std::uint32_t e = 0; e < edges; ++e) {
    if (e % 4096 == 0) context.poll();
    const std::uint32_t a = sets.find(boundaries.facets(1)[2 * std::size_t{e}]);
    const std::uint32_t b = sets.find(boundaries.facets(1)[2 * std::size_t{e} + 1]);
    if (a == b) continue;
    sets.unite(a, b);
    note(std::max(a, b), e);
  }
}

void pair_dual_components(const OrderedBoundaries& boundaries, const CoboundaryColumns& coboundaries, bool is_two,
                          const Context& context, const NotePair& note) {
  const int d = boundaries.dimension();
  const auto cells = static_cast<std::uint32_t>(boundaries.count(d));
  constexpr std::uint32_t outside = 0;
  OrientedSets sets(std::size_t{cells} + 1);  // a cell by how many come after it, and one: the older, the smaller
  for (std::uint32_t column = 0; column < coboundaries.columns(); ++column) {
    if (column % 4096 == 0) context.poll();
    std::array<OrientedSets::Root, 2> roots{{{outside, false}, {outside, false}}};
    std::array<bool, 2> is_negative{false, false};
    std::size_t found = 0;
    coboundaries.for_each(column, [&](std::uint32_t row, int sign) {
      is_negative[found] = sign < 0;
      roots[found++] = sets.find(row + 1);
    });
    const auto [lower, upper] = std::minmax(roots[0].member, roots[1].member);
    // The one with its sign, and the other with its own, have the sum zero.
    const bool is_opposite = (is_negative[0] == is_negative[1]) != (roots[0].is_opposite != roots[1].is_opposite);
    const bool is_twisted = lower == upper && lower != outside && is_opposite && !is_two;
    if (lower == upper && !is_twisted) continue;
    note(coboundaries.column_of(column), cells - upper);
    sets.unite(upper, is_twisted ? outside : lower, is_opposite);
  }
}

}  // namespace quoin
