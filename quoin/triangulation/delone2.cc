// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone2.h"

#include <algorithm>
#include <numeric>

#include "quoin/triangulation/delaunay_predicates2.h"

namespace quoin {

namespace {

constexpr std::uint32_t poll_step = 256;

class Merger {
 public:
  Merger(const Delaunay2& delaunay, const Context& context)
      : links_(delaunay.links()), predicates_(delaunay.points(), context), context_(context) {}

  // The cell of each triangle, in the order of their first triangles, and these.
  void run(std::vector<DeloneCell2>& cell_of, std::vector<Triangle2>& first) {
    cell_of.assign(links_.triangle_count(), DeloneCell2());
    for (std::uint32_t t = 0; t < cell_of.size(); ++t) {
      if (t % poll_step == 0) context_.poll();
      if (!cell_of[t].is_none() || links_.is_infinite(Triangle2(t))) continue;
      const DeloneCell2 cell(first.size());
      first.emplace_back(t);
      spread(Triangle2(t), cell, cell_of);
    }
  }

 private:
  void spread(Triangle2 start, DeloneCell2 cell, std::vector<DeloneCell2>& cell_of) {
    cell_of[start.index()] = cell;
    pending_.assign(1, start);
    for (std::size_t steps = 1; !pending_.empty(); ++steps) {
      if (steps % poll_step == 0) context_.poll();
      const Triangle2 t = pending_.back();
      pending_.pop_back();
      for (unsigned slot = 0; slot < 3; ++slot) {
        const Edge2 other = links_.twin(Edge2(t, slot));
        if (!cell_of[other.triangle().index()].is_none() || links_.is_infinite(other.triangle())) continue;
        if (predicates_.circle_side(links_.corners(t), links_.apex(other)) != Sign::zero) continue;
        cell_of[other.triangle().index()] = cell;
        pending_.push_back(other.triangle());
      }
    }
  }

  const Triangulation2& links_;
  DelaunayPredicates2 predicates_;
  const Context& context_;
  std::vector<Triangle2> pending_;
};

}  // namespace

Delone2::Delone2(const Delaunay2& delaunay, const Context& context) {
  const Triangulation2& links = delaunay.links();
  std::vector<Triangle2> first;
  Merger(delaunay, context).run(cell_of_, first);

  // The boundary of each cell, all triangles of which touch it.
  std::vector<std::uint32_t> begin{0};
  std::vector<Vertex2> corners;
  for (const Triangle2 t : first) {
    if (begin.size() % poll_step == 0) context.poll();
    const auto start = static_cast<std::ptrdiff_t>(corners.size());
    Edge2 e(t, 0);
    while (is_inner(links, e)) e = Triangulation2::next(links.twin(e));
    const Edge2 last = e;
    do {
      corners.push_back(links.source(e));
      e = Triangulation2::next(e);
      while (is_inner(links, e)) e = Triangulation2::next(links.twin(e));
    } while (e != last);
    std::rotate(corners.begin() + start, std::min_element(corners.begin() + start, corners.end()), corners.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }

  // By the smallest corner, which few cells have in common, then by the one after it.
  std::vector<std::uint32_t> bucket(delaunay.vertex_count() + 1, 0);
  for (std::size_t i = 0; i < first.size(); ++i) ++bucket[corners[begin[i]].index() + 1];
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  std::vector<std::uint32_t> order(first.size());
  std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
  for (std::uint32_t i = 0; i < order.size(); ++i) order[next[corners[begin[i]].index()]++] = i;
  for (std::size_t v = 0; v + 1 < bucket.size(); ++v) {
    if (v % poll_step == 0) context.poll();
    std::sort(order.begin() + bucket[v], order.begin() + bucket[v + 1],
              [&](std::uint32_t a, std::uint32_t b) { return corners[begin[a] + 1] < corners[begin[b] + 1]; });
  }
  std::vector<DeloneCell2> renamed(first.size());
  begin_.push_back(0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    renamed[order[i]] = DeloneCell2(i);
    triangle_.push_back(first[order[i]]);
    corners_.insert(corners_.end(), corners.begin() + begin[order[i]], corners.begin() + begin[order[i] + 1]);
    begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }
  for (DeloneCell2& cell : cell_of_) {
    if (!cell.is_none()) cell = renamed[cell.index()];
  }
}

}  // namespace quoin
