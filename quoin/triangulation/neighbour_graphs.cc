// SPDX-License-Identifier: Apache-2.0
//
// Relative neighbours. If r is nearer to both p and q than they are to each other, |p - r|^2 + |q - r|^2 < 2 |p - q|^2:
// r is in the ball about the middle m of p and q of squared radius 3/4 |p - q|^2, which p and q are inside too. The
// vertices inside a ball are connected by Delaunay edges: lifted to the paraboloid, and by the perturbation of ties,
// they are those vertices of a convex polytope that are below a plane. So a search from p through vertices inside, or
// not far outside, finds r.
#include "quoin/triangulation/neighbour_graphs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 256;
constexpr double u = 0x1p-53;

void require_no_weights(const AlphaComplex& alpha) {
  if (alpha.spheres().is_weighted()) throw InputError("a graph of neighbours of points with weights");
}

/// Within 6u of it, relatively, but for underflow of 2^-1070.
double squared_distance(const Point3& a, const Point3& b) {
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  const double z = a.z - b.z;
  return x * x + y * y + z * z;
}

template <class Reader>
Sign exact_order(const Reader& read, const Point3& p, const Point3& a, const Point3& b) {
  using Quadratic = typename Reader::Numbers::Quadratic;
  const auto square = [&](const Point3& q) {
    const std::array difference{read(q.x, p.x), read(q.y, p.y), read(q.z, p.z)};
    return detail::dot<Quadratic>(difference, difference);
  };
  return (square(a) - square(b)).sign();
}

/// Whether a is nearer to p than b is.
bool is_nearer(const Point3& p, const Point3& a, const Point3& b) {
  const double of_a = squared_distance(p, a);
  const double of_b = squared_distance(p, b);
  const double sum = of_a + of_b;
  if (sum >= 0x1p-900 && sum <= 0x1p1000) {
    const double difference = of_a - of_b;
    if (std::fabs(difference) > 8 * u * sum) return difference < 0;
  }
  const std::array values{p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z};
  Tier ignored;
  return detail::decide_on_grid(values, ignored, [&](const auto& read) { return exact_order(read, p, a, b); }) ==
         Sign::negative;
}

/// The vertices that share an edge with each.
class Adjacency {
 public:
  explicit Adjacency(const SimplicialComplex& complex) : begin_(complex.count(0) + 1, 0) {
    for (std::uint32_t e = 0; e < complex.count(1); ++e) {
      for (const std::uint32_t v : complex.vertices({1, e})) ++begin_[v + 1];
    }
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    items_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t e = 0; e < complex.count(1); ++e) {
      const auto v = complex.vertices({1, e});
      items_[next[v[0]]++] = v[1];
      items_[next[v[1]]++] = v[0];
    }
  }
  std::span<const std::uint32_t> operator[](std::uint32_t v) const {
    return {items_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> items_;
};

class LuneSearch {
 public:
  LuneSearch(const AlphaComplex& alpha, const Context& context)
      : alpha_(alpha), context_(context), adjacency_(alpha.complex()), seen_by_(alpha.complex().count(0), 0) {}

  bool is_empty(std::uint32_t edge) {
    const auto ends = alpha_.complex().vertices({1, edge});
    const Point3& p = point(ends[0]);
    const Point3& q = point(ends[1]);
    const double limit = 2 * squared_distance(p, q);
    ++search_;
    seen_by_[ends[0]] = seen_by_[ends[1]] = search_;
    open_.assign({ends[0], ends[1]});
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (++steps_ % poll_interval == 0) context_.poll();
      for (const std::uint32_t r : adjacency_[open_[i]]) {
        if (std::exchange(seen_by_[r], search_) == search_) continue;
        const double sum = squared_distance(point(r), p) + squared_distance(point(r), q);
        // Rather too many; where doubles do not reach, all.
        if (limit >= 0x1p-900 && limit <= 0x1p1000 && sum > limit * (1 + 0x1p-40)) continue;
        if (is_nearer(p, point(r), q) && is_nearer(q, point(r), p)) return false;
        open_.push_back(r);
      }
    }
    return true;
  }

 private:
  const Point3& point(std::uint32_t v) const { return alpha_.spheres().point(v); }

  const AlphaComplex& alpha_;
  const Context& context_;
  Adjacency adjacency_;
  std::vector<std::uint32_t> seen_by_;  ///< the last search that saw a vertex
  std::vector<std::uint32_t> open_;
  std::uint32_t search_ = 0;
  std::size_t steps_ = 0;
};

std::array<std::uint32_t, 2> labels_of(const AlphaComplex& alpha, std::uint32_t edge) {
  const auto v = alpha.complex().vertices({1, edge});
  return {alpha.complex().label(v[0]), alpha.complex().label(v[1])};
}

}  // namespace

VertexPairs gabriel_edges(const AlphaComplex& alpha) {
  require_no_weights(alpha);
  VertexPairs pairs;
  for (std::uint32_t e = 0; e < alpha.complex().count(1); ++e) {
    if (alpha.has_empty_ball(e)) pairs.push_back(labels_of(alpha, e));
  }
  return pairs;
}

VertexPairs relative_neighbours(const AlphaComplex& alpha, const Context& context) {
  require_no_weights(alpha);
  LuneSearch search(alpha, context);
  VertexPairs pairs;
  for (std::uint32_t e = 0; e < alpha.complex().count(1); ++e) {
    if (alpha.has_empty_ball(e) && search.is_empty(e)) pairs.push_back(labels_of(alpha, e));
  }
  return pairs;
}

/// A quarter of the square of its length is the value of a Gabriel edge.
VertexPairs minimum_spanning_tree(const AlphaComplex& alpha, const Context& context) {
  require_no_weights(alpha);
  std::vector<std::uint64_t> edges;
  for (std::uint32_t e = 0; e < alpha.complex().count(1); ++e) {
    if (alpha.has_empty_ball(e)) edges.push_back(static_cast<std::uint64_t>(alpha.grade_of({1, e})) << 32 | e);
  }
  context.poll();
  std::sort(edges.begin(), edges.end());
  DisjointSets trees(alpha.complex().count(0));
  VertexPairs pairs;
  for (const std::uint64_t edge : edges) {
    const auto v = alpha.complex().vertices({1, static_cast<std::uint32_t>(edge)});
    if (trees.find(v[0]) == trees.find(v[1])) continue;
    trees.unite(v[0], v[1]);
    pairs.push_back(labels_of(alpha, static_cast<std::uint32_t>(edge)));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace quoin
