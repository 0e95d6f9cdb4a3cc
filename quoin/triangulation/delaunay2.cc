// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay2.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/insertion_rounds2.h"

namespace quoin {

namespace {

std::vector<Vertex2> lexicographic_order(std::span<const Point2> points) {
  std::vector<Vertex2> order;
  for (std::size_t v = 0; v < points.size(); ++v) order.emplace_back(v);
  std::sort(order.begin(), order.end(),
            [&](Vertex2 a, Vertex2 b) { return lexicographically_less(points[a.index()], points[b.index()]); });
  return order;
}

}  // namespace

Delaunay2::Delaunay2(std::span<const Point2> points, const Delaunay2Options& options, const Context& context) {
  require_edge_codes(points.size());
  order_ = spatial_order(points, context);
  const std::size_t count = order_.points.size();
  const auto turn = [&](std::uint32_t i) { return orientation(order_.points[0], order_.points[1], order_.points[i]); };
  const auto start = detail::first_triangle(count, turn, context);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  order_.points.push_back({nan, nan});
  if (!start) {
    dimension_ = count == 0 ? -1 : count == 1 ? 0 : 1;
    line_ = lexicographic_order(std::span(order_.points).first(count));
    links_ = Triangulation2({}, count);
    return;
  }
  dimension_ = 2;
  const DelaunayPredicates2 predicates(order_.points, context);
  const InsertionSplit split = InsertionSplit::in_plane(count);
  links_ = Triangulation2(detail::insert_in_rounds(predicates, count, *start, split, context), count, context);
  if (options.canonical) links_.renumber();
}

std::vector<Vertex2> Delaunay2::vertices_of_inputs() const {
  std::vector<Vertex2> vertices(input_count());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    for (const std::uint32_t input : inputs(Vertex2(v))) vertices[input] = Vertex2(v);
  }
  return vertices;
}

}  // namespace quoin
