// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flat_grades.h"

#include <numeric>
#include <utility>

#include "quoin/base/disjoint_sets.h"

namespace quoin::cli {

namespace {

std::vector<Point3> points_of(const FlowComplex& flow) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < flow.faces().count(0); ++v) points.push_back(flow.point(v));
  return points;
}

}  // namespace

FlatGrades::FlatGrades(const FlowComplex& flow, const Context& context)
    : flow_(flow),
      spheres_(points_of(flow)),
      edges_(critical_faces(flow, 1)),
      polygons_(critical_faces(flow, 2)),
      grades_(squares(), context) {
  for (const std::uint32_t i : grades_.order()) {
    if (i < edge_count()) {
      edges_in_order_.push_back(i);
    } else {
      polygons_in_order_.push_back(i - edge_count());
    }
  }
}

DeloneFace FlatGrades::face(std::uint32_t i) const {
  return i < edge_count() ? DeloneFace{1, edges_[i]} : DeloneFace{2, polygons_[i - edge_count()]};
}

CriticalFace FlatGrades::critical(std::uint32_t i) const {
  if (i < edge_count()) {
    const std::array<std::uint32_t, 2> ends = flow_.faces().edge(edges_[i]);
    return {{ends[0], ends[1]}, 2};
  }
  const std::span<const std::uint32_t> corners = flow_.faces().polygon(polygons_[i - edge_count()]);
  return {{corners[0], corners[1], corners[2]}, 3};
}

SquareList FlatGrades::squares() const {
  return {.count = edge_count() + static_cast<std::uint32_t>(polygons_.size()),
          .bounds = [this](std::uint32_t i) { return square_radius_bounds(flow_, face(i)); },
          .numbers = {[this](std::uint32_t i) { return spheres_.close_square(critical(i)); },
                      [this](std::uint32_t i) { return spheres_.exact_square(critical(i)); }}};
}

std::vector<std::uint32_t> joining_edges(const FlowComplex& flow, const FlatGrades& grades, const Context& context) {
  std::vector<std::uint32_t> joining;
  DisjointSets parts(flow.faces().count(0));
  std::size_t steps = 0;
  for (const std::uint32_t i : grades.edges_in_order()) {
    if (++steps % 1024 == 0) context.poll();
    const auto [a, b] = flow.faces().edge(grades.edges()[i]);
    if (parts.find(a) == parts.find(b)) continue;
    parts.unite(a, b);
    joining.push_back(i);
  }
  return joining;
}

std::vector<FlatHole> holes_of(FlatFlow& flow, const FlatGrades& grades, const Context& context) {
  const auto infinity = static_cast<std::uint32_t>(grades.polygons().size());
  std::vector<std::uint32_t> number(flow.complex().faces().count(2), infinity);
  for (std::uint32_t i = 0; i < infinity; ++i) number[grades.polygons()[i]] = i;
  std::vector<std::uint32_t> rank(infinity + 1, infinity);
  for (std::uint32_t i = 0; i < infinity; ++i) rank[grades.polygons_in_order()[i]] = i;
  DisjointSets regions(infinity + 1);
  std::vector<std::uint32_t> highest(infinity + 1);
  std::iota(highest.begin(), highest.end(), 0U);
  std::vector<FlatHole> holes;
  for (std::size_t i = grades.edges_in_order().size(); i > 0; --i) {
    if (i % 1024 == 0) context.poll();
    const std::uint32_t edge = grades.edges_in_order()[i - 1];
    const std::array<FlatWay, 2> ways = flow.ways(grades.edges()[edge], context);
    const auto region = [&](const FlatWay& way) {
      return regions.find(way.end == FlatWay::infinity ? infinity : number[way.end]);
    };
    std::uint32_t low = highest[region(ways[0])];
    std::uint32_t high = highest[region(ways[1])];
    if (low == high) continue;
    if (rank[low] > rank[high]) std::swap(low, high);
    holes.push_back({edge, low});
    regions.unite(low, high);
    highest[regions.find(low)] = high;
  }
  return holes;
}

}  // namespace quoin::cli
