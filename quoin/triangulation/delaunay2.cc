// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay2.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/insertion2.h"

namespace quoin {

namespace {

constexpr std::size_t poll_step = 1 << 14;

// The first point off the line of the first two.
std::optional<std::array<std::uint32_t, 3>> first_triangle(std::span<const Point2> points, const Context& context) {
  for (std::uint32_t i = 2; i < points.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    const Sign turn = orientation(points[0], points[1], points[i]);
    if (turn == Sign::positive) return std::array<std::uint32_t, 3>{0, 1, i};
    if (turn == Sign::negative) return std::array<std::uint32_t, 3>{1, 0, i};
  }
  return std::nullopt;
}

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
  const std::optional<std::array<std::uint32_t, 3>> start = first_triangle(order_.points, context);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  order_.points.push_back({nan, nan});
  if (!start) {
    dimension_ = count == 0 ? -1 : count == 1 ? 0 : 1;
    line_ = lexicographic_order(std::span(order_.points).first(count));
    links_ = Triangulation2({}, count);
    return;
  }
  dimension_ = 2;
  const DelaunayPredicates2 predicates(order_.points);
  links_ = Triangulation2(detail::Insertion2<DelaunayPredicates2>(predicates, count, context).run(*start), count);
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
