// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/alpha_topology.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 4096;
constexpr std::uint32_t none = 0xFFFFFFFF;

/// `visit(i)` for each simplex of dimension k that is in the complex of so many grades.
template <class Visit>
void for_each_within(const AlphaComplex& alpha, int k, std::uint32_t grades, const Context& context,
                     const Visit& visit) {
  for (std::uint32_t i = 0; i < alpha.complex().count(k); ++i) {
    if (i % poll_interval == 0) context.poll();
    if (alpha.grade_of({k, i}) < grades) visit(i);
  }
}

bool unite(DisjointSets& sets, std::uint32_t a, std::uint32_t b) {
  if (sets.find(a) == sets.find(b)) return false;
  sets.unite(a, b);
  return true;
}

std::size_t components(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  DisjointSets sets(alpha.complex().count(0));
  std::size_t count = 0;
  for_each_within(alpha, 0, grades, context, [&](std::uint32_t) { ++count; });
  for_each_within(alpha, 1, grades, context, [&](std::uint32_t i) {
    const auto ends = alpha.complex().vertices({1, i});
    if (unite(sets, ends[0], ends[1])) --count;
  });
  return count;
}

/// Parts of what is left of space, the outside not counted: tetrahedra that are not in, and the outside, joined by
/// triangles that are not in.
std::size_t voids(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  const SimplicialComplex& complex = alpha.complex();
  const auto outside = static_cast<std::uint32_t>(complex.count(3));
  DisjointSets sets(std::size_t{outside} + 1);
  std::size_t count = outside;
  std::vector<std::uint32_t> first(complex.count(2), none);  // of the tetrahedra at a triangle
  std::vector<bool> has_second(complex.count(2));
  for (std::uint32_t i = 0; i < outside; ++i) {
    if (i % poll_interval == 0) context.poll();
    if (alpha.grade_of({3, i}) < grades) --count;
    for (const std::uint32_t facet : complex.facets({3, i})) {
      has_second[facet] = first[facet] != none;
      if (first[facet] == none) first[facet] = i;
      if (has_second[facet] && alpha.grade_of({2, facet}) >= grades && unite(sets, first[facet], i)) --count;
    }
  }
  for (std::uint32_t f = 0; f < first.size(); ++f) {
    if (!has_second[f] && alpha.grade_of({2, f}) >= grades && unite(sets, first[f], outside)) --count;
  }
  return count;
}

/// Simplices of full dimension, added one after another.
class Pieces {
 public:
  explicit Pieces(const AlphaComplex& alpha)
      : complex_(alpha.complex()),
        top_(alpha.dimension()),
        sets_(complex_.count(top_)),
        waiting_(complex_.count(top_ - 1), none) {}

  void add(std::uint32_t cell) {
    ++count_;
    if (top_ == 0) return;
    for (const std::uint32_t facet : complex_.facets({top_, cell})) {
      if (waiting_[facet] == none) {
        waiting_[facet] = cell;
      } else if (unite(sets_, waiting_[facet], cell)) {
        --count_;
      }
    }
  }
  std::size_t count() const { return count_; }

 private:
  const SimplicialComplex& complex_;
  int top_;
  DisjointSets sets_;
  std::vector<std::uint32_t> waiting_;  ///< for each facet the first that was added
  std::size_t count_ = 0;
};

}  // namespace

std::array<std::size_t, 3> alpha_betti_numbers(const AlphaComplex& alpha, std::uint32_t grades,
                                               const Context& context) {
  std::int64_t euler = 0;
  for (int k = 0; k <= alpha.dimension(); ++k) {
    for_each_within(alpha, k, grades, context, [&](std::uint32_t) { euler += k % 2 == 0 ? 1 : -1; });
  }
  const std::size_t parts = components(alpha, grades, context);
  const std::size_t hollows = alpha.dimension() == 3 ? voids(alpha, grades, context) : 0;
  const std::int64_t tunnels = static_cast<std::int64_t>(parts + hollows) - euler;
  return {parts, static_cast<std::size_t>(tunnels), hollows};
}

std::size_t alpha_pieces(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  if (alpha.dimension() < 0) return 0;
  Pieces pieces(alpha);
  for_each_within(alpha, alpha.dimension(), grades, context, [&](std::uint32_t i) { pieces.add(i); });
  return pieces.count();
}

std::uint32_t grades_with_pieces(const AlphaComplex& alpha, std::size_t most, const Context& context) {
  if (most == 0) throw InputError("no alpha complex that has all points has no pieces");
  if (alpha.dimension() < 0) throw InputError("an alpha complex of no points has no pieces");
  const SimplicialComplex& complex = alpha.complex();
  const int top = alpha.dimension();
  std::vector<std::uint32_t> cells(complex.count(top));
  std::iota(cells.begin(), cells.end(), 0U);
  context.poll();
  std::sort(cells.begin(), cells.end(), [&](std::uint32_t a, std::uint32_t b) {
    return alpha.grade_of({top, a}) < alpha.grade_of({top, b});
  });
  Pieces pieces(alpha);
  std::vector<bool> is_corner(complex.count(0));
  std::size_t corners = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % poll_interval == 0) context.poll();
    pieces.add(cells[i]);
    for (const std::uint32_t v : complex.vertices({top, cells[i]})) {
      corners += is_corner[v] ? 0 : 1;
      is_corner[v] = true;
    }
    const std::uint32_t grade = alpha.grade_of({top, cells[i]});
    if (i + 1 < cells.size() && alpha.grade_of({top, cells[i + 1]}) == grade) continue;
    if (corners == is_corner.size() && pieces.count() <= most) return grade + 1;
  }
  throw InternalError("all cells of a triangulation are not one piece");
}

}  // namespace quoin
