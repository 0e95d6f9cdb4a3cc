// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone2.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/regular_predicates2.h"

namespace quoin {

namespace {

constexpr std::uint32_t poll_step = 256;

/// Numbers the parts of the plane that triangles make where `is_one_circle(triangle, vertex beyond)`, in the order of
/// their first triangles.
template <class IsOneCircle>
std::vector<Triangle2> merge(const Triangulation2& links, const IsOneCircle& is_one_circle, const Context& context,
                             std::vector<DeloneCell2>& cell_of) {
  std::vector<Triangle2> first;
  std::vector<Triangle2> pending;
  const auto spread = [&](DeloneCell2 cell) {
    for (std::size_t steps = 1; !pending.empty(); ++steps) {
      if (steps % poll_step == 0) context.poll();
      const Triangle2 t = pending.back();
      pending.pop_back();
      for (unsigned slot = 0; slot < 3; ++slot) {
        const Edge2 other = links.twin(Edge2(t, slot));
        if (!cell_of[other.triangle().index()].is_none() || links.is_infinite(other.triangle())) continue;
        if (!is_one_circle(t, links.apex(other))) continue;
        cell_of[other.triangle().index()] = cell;
        pending.push_back(other.triangle());
      }
    }
  };
  cell_of.assign(links.triangle_count(), DeloneCell2());
  for (std::uint32_t t = 0; t < cell_of.size(); ++t) {
    if (t % poll_step == 0) context.poll();
    if (!cell_of[t].is_none() || links.is_infinite(Triangle2(t))) continue;
    cell_of[t] = DeloneCell2(first.size());
    pending.assign(1, Triangle2(t));
    spread(DeloneCell2(first.size()));
    first.emplace_back(t);
  }
  return first;
}

}  // namespace

/// Makes cells of merged triangles.
class Delone2::Builder {
 public:
  Builder(Delone2& result, const TriangulationView2& triangulation, const Context& context)
      : result_(result), triangulation_(triangulation), links_(triangulation.links()), context_(context) {}

  /// Where all vertices are corners each triangle touches the boundary of its cell; else those of `first` are replaced.
  void run(std::vector<Triangle2> first) {
    std::vector<Edge2> sides;
    if (triangulation_.is_weighted()) sides = boundary_edges(first);
    begin_.push_back(0);
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (begin_.size() % poll_step == 0) context_.poll();
      collect_corners(sides.empty() ? next_side(Edge2(first[i], 0)) : sides[i]);
    }
    number_cells(first);
  }

  /// In dimension 1: vertices that are not lifted into the segment between their neighbours.
  void find_ends_on_line() {
    const std::span<const Vertex2> line = triangulation_.line();
    result_.is_corner_.assign(line.size(), true);
    const auto at = [this](Vertex2 v) { return WeightedPoint2{triangulation_.point(v), triangulation_.weight(v)}; };
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (in_power_segment(at(line[i - 1]), at(line[i + 1]), at(line[i])) == Sign::zero)
        result_.is_corner_[line[i].index()] = false;
    }
  }

 private:
  /// The edge, or the next one counterclockwise about its source that is on the boundary of the cell to its left.
  Edge2 next_side(Edge2 e) const {
    while (result_.is_inner(links_, e)) e = Triangulation2::next(links_.twin(e));
    return e;
  }

  std::vector<Edge2> boundary_edges(std::vector<Triangle2>& first) const {
    std::vector<Edge2> sides(first.size());
    for (std::uint32_t t = 0; t < links_.triangle_count(); ++t) {
      if (t % poll_step == 0) context_.poll();
      const DeloneCell2 cell = result_.cell_of_[t];
      for (unsigned slot = 0; slot < 3 && !cell.is_none(); ++slot) {
        const Edge2 e(Triangle2(t), slot);
        if (!sides[cell.index()].is_none() || result_.is_inner(links_, e)) continue;
        sides[cell.index()] = e;
        first[cell.index()] = Triangle2(t);
      }
    }
    return sides;
  }

  void collect_corners(Edge2 first) {
    const auto start = static_cast<std::ptrdiff_t>(corners_.size());
    Edge2 e = first;
    do {
      corners_.push_back(links_.source(e));
      e = next_side(Triangulation2::next(e));
    } while (e != first);
    if (triangulation_.is_weighted()) leave_out_straight(static_cast<std::size_t>(start));
    std::rotate(corners_.begin() + start, std::min_element(corners_.begin() + start, corners_.end()), corners_.end());
    begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }

  /// Of the polygon that begins at a place of the list, and ends with it.
  void leave_out_straight(std::size_t start) {
    const std::size_t count = corners_.size() - start;
    const auto point = [&](std::size_t i) { return triangulation_.point(corners_[start + i % count]); };
    std::vector<Vertex2> kept;
    for (std::size_t i = 0; i < count; ++i) {
      if (orientation(point(i + count - 1), point(i), point(i + 1)) != Sign::zero) kept.push_back(corners_[start + i]);
    }
    corners_.resize(start);
    corners_.insert(corners_.end(), kept.begin(), kept.end());
  }

  /// By the smallest corner, which few cells have in common, then by the one after it.
  void number_cells(const std::vector<Triangle2>& first) {
    std::vector<std::uint32_t> bucket(triangulation_.vertex_count() + 1, 0);
    for (std::size_t i = 0; i < first.size(); ++i) ++bucket[corners_[begin_[i]].index() + 1];
    std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
    std::vector<std::uint32_t> order(first.size());
    std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
    for (std::uint32_t i = 0; i < order.size(); ++i) order[next[corners_[begin_[i]].index()]++] = i;
    for (std::size_t v = 0; v + 1 < bucket.size(); ++v) {
      if (v % poll_step == 0) context_.poll();
      std::sort(order.begin() + bucket[v], order.begin() + bucket[v + 1],
                [&](std::uint32_t a, std::uint32_t b) { return corners_[begin_[a] + 1] < corners_[begin_[b] + 1]; });
    }
    std::vector<DeloneCell2> renamed(first.size());
    result_.begin_.push_back(0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % poll_step == 0) context_.poll();
      renamed[order[i]] = DeloneCell2(i);
      result_.triangle_.push_back(first[order[i]]);
      result_.corners_.insert(result_.corners_.end(), corners_.begin() + begin_[order[i]],
                              corners_.begin() + begin_[order[i] + 1]);
      result_.begin_.push_back(static_cast<std::uint32_t>(result_.corners_.size()));
    }
    for (DeloneCell2& cell : result_.cell_of_) {
      if (!cell.is_none()) cell = renamed[cell.index()];
    }
  }

  Delone2& result_;
  const TriangulationView2& triangulation_;
  const Triangulation2& links_;
  const Context& context_;
  std::vector<Vertex2> corners_;  ///< of cells as they were merged
  std::vector<std::uint32_t> begin_;
};

Delone2::Delone2(const Delaunay2& delaunay, const Context& context) {
  const Triangulation2& links = delaunay.links();
  const DelaunayPredicates2 predicates(delaunay.points(), context);
  std::vector<Triangle2> first = merge(
      links,
      [&](Triangle2 t, Vertex2 beyond) { return predicates.circle_side(links.corners(t), beyond) == Sign::zero; },
      context, cell_of_);
  const TriangulationView2 view(delaunay);
  Builder(*this, view, context).run(std::move(first));
}

Delone2::Delone2(const Regular2& regular, const Context& context) {
  const Triangulation2& links = regular.links();
  const auto is_one_circle = [&](Triangle2 t, Vertex2 beyond) {
    const std::array<Vertex2, 3> v = links.corners(t);
    return in_power_circle(regular.point(v[0]), regular.point(v[1]), regular.point(v[2]), regular.point(beyond)) ==
           Sign::zero;
  };
  std::vector<Triangle2> first = merge(links, is_one_circle, context, cell_of_);
  const TriangulationView2 view(regular);
  Builder builder(*this, view, context);
  builder.run(std::move(first));
  if (regular.dimension() < 2) {
    builder.find_ends_on_line();
    return;
  }
  is_corner_.assign(regular.vertex_count(), false);
  for (const Vertex2 v : corners_) is_corner_[v.index()] = true;
}

}  // namespace quoin
