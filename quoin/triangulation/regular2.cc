// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular2.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/triangulation/insertion_rounds2.h"
#include "quoin/triangulation/spatial_order2.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = Vertex2::none_value;

std::vector<Point2> places(std::span<const WeightedPoint2> points) {
  require_edge_codes(points.size());
  std::vector<Point2> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_finite = std::isfinite(points[i].point.x) && std::isfinite(points[i].point.y);
    if (!is_finite) throw InputError("point " + std::to_string(i) + " is not finite");
    if (!std::isfinite(points[i].weight))
      throw InputError("the weight of point " + std::to_string(i) + " is not finite");
    result.push_back(points[i].point);
  }
  return result;
}

// The lower hull of lifted points of a line, in order (Andrew 1979).
std::vector<std::uint32_t> hull_of_line(std::span<const WeightedPoint2> points) {
  std::vector<std::uint32_t> sorted(points.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::sort(sorted.begin(), sorted.end(),
            [&](std::uint32_t a, std::uint32_t b) { return lexicographically_less(points[a].point, points[b].point); });
  std::vector<std::uint32_t> hull;
  for (const std::uint32_t next : sorted) {
    while (hull.size() > 1 && !is_seen_between(points[hull[hull.size() - 2]], points[hull.back()], points[next])) {
      hull.pop_back();
    }
    hull.push_back(next);
  }
  return hull;
}

}  // namespace

Regular2::Regular2(std::span<const WeightedPoint2> points, const Context& context) {
  const SpatialOrder2 order = spatial_order(places(points), context);
  const std::size_t count = order.points.size();
  std::vector<WeightedPoint2> all;
  all.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    double weight = points[order.inputs_of(i)[0]].weight;
    for (const std::uint32_t input : order.inputs_of(i)) weight = std::max(weight, points[input].weight);
    all.push_back({order.points[i], weight + 0.0});
  }
  const auto turn = [&](std::uint32_t i) { return orientation(all[0].point, all[1].point, all[i].point); };
  const auto start = detail::first_triangle(count, turn, context);
  std::vector<std::uint32_t> on_line;
  TriangleArray2 triangles;
  std::vector<std::uint32_t> vertex(count + 1, none);
  if (start) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    all.push_back({{nan, nan}, nan});
    const RegularPredicates2 predicates(all);
    triangles = detail::insert_in_rounds(predicates, count, *start, InsertionSplit::in_plane(count), context);
    for (const TriangleLinks2& t : triangles) {
      for (const std::uint32_t v : t.corner) vertex[v] = 0;
    }
  } else {
    on_line = hull_of_line(all);
    for (const std::uint32_t v : on_line) vertex[v] = 0;
  }

  input_begin_.push_back(0);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_vertex = vertex[i] != none;
    for (const std::uint32_t input : order.inputs_of(i)) {
      const bool counts = is_vertex && points[input].weight == all[i].weight;
      (counts ? inputs_ : hidden_).push_back(input);
    }
    if (!is_vertex) continue;
    vertex[i] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(all[i]);
    input_begin_.push_back(static_cast<std::uint32_t>(inputs_.size()));
  }
  std::sort(hidden_.begin(), hidden_.end());
  vertex[count] = static_cast<std::uint32_t>(vertices_.size());
  for (TriangleLinks2& t : triangles) {
    for (std::uint32_t& v : t.corner) v = vertex[v];
  }
  for (const std::uint32_t v : on_line) line_.emplace_back(std::size_t{vertex[v]});
  dimension_ = start ? 2 : std::min<int>(static_cast<int>(line_.size()), 2) - 1;
  links_ = Triangulation2(std::move(triangles), vertices_.size(), context);
}

}  // namespace quoin
