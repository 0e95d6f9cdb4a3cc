// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/polygon.h"

#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/polygon_sweep.h"

namespace quoin {

namespace {

bool triangulate_three(std::span<const Point2> points, std::span<const std::uint32_t> loop,
                       std::vector<PolygonTriangle>& triangles) {
  if (orientation(points[loop[0]], points[loop[1]], points[loop[2]]) != Sign::positive) return false;
  triangles.push_back({loop[0], loop[1], loop[2]});
  return true;
}

double squared_distance(const Point2& a, const Point2& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// Of the diagonals that cut a quadrilateral into two counterclockwise triangles, the shorter one.
bool triangulate_four(std::span<const Point2> points, std::span<const std::uint32_t> loop,
                      std::vector<PolygonTriangle>& triangles) {
  const auto turns_left = [&](std::size_t i, std::size_t j, std::size_t k) {
    return orientation(points[loop[i]], points[loop[j]], points[loop[k]]) == Sign::positive;
  };
  const bool first = turns_left(0, 1, 2) && turns_left(0, 2, 3);
  const bool second = turns_left(1, 2, 3) && turns_left(1, 3, 0);
  if (!first && !second) return false;
  const bool first_is_shorter =
      squared_distance(points[loop[0]], points[loop[2]]) <= squared_distance(points[loop[1]], points[loop[3]]);
  if (first && (!second || first_is_shorter)) {
    triangles.push_back({loop[0], loop[1], loop[2]});
    triangles.push_back({loop[0], loop[2], loop[3]});
  } else {
    triangles.push_back({loop[1], loop[2], loop[3]});
    triangles.push_back({loop[1], loop[3], loop[0]});
  }
  return true;
}

template <class Points>
bool sweep_polygon(const Points& points, std::span<const std::uint32_t> loop_points,
                   std::span<const std::uint32_t> loop_begin, std::vector<PolygonTriangle>& triangles) {
  const std::size_t before = triangles.size();
  if (PolygonSweep<Points>(points, loop_points, loop_begin, triangles).run()) return true;
  triangles.resize(before);
  return false;
}

}  // namespace

bool triangulate_polygon(std::span<const Point2> points, std::span<const std::uint32_t> loop_points,
                         std::span<const std::uint32_t> loop_begin, std::vector<PolygonTriangle>& triangles) {
  if (loop_begin.size() == 2 && loop_points.size() == 3) return triangulate_three(points, loop_points, triangles);
  if (loop_begin.size() == 2 && loop_points.size() == 4) return triangulate_four(points, loop_points, triangles);
  return sweep_polygon(PlainPoints(points), loop_points, loop_begin, triangles);
}

bool triangulate_polygon(const Constructions& table, std::span<const PointId> points, const PolygonView& view,
                         std::span<const std::uint32_t> loop_points, std::span<const std::uint32_t> loop_begin,
                         std::vector<PolygonTriangle>& triangles) {
  return sweep_polygon(ProjectedPoints(table, points, view.axis, view.from_positive), loop_points, loop_begin,
                       triangles);
}

std::optional<std::vector<PolygonTriangle>> triangulate_polygon(std::span<const Point2> points,
                                                                std::span<const std::vector<std::uint32_t>> loops) {
  std::vector<std::uint32_t> loop_points;
  std::vector<std::uint32_t> loop_begin{0};
  for (const auto& loop : loops) {
    loop_points.insert(loop_points.end(), loop.begin(), loop.end());
    loop_begin.push_back(static_cast<std::uint32_t>(loop_points.size()));
  }
  std::vector<PolygonTriangle> triangles;
  if (!triangulate_polygon(points, loop_points, loop_begin, triangles)) return std::nullopt;
  return triangles;
}

}  // namespace quoin
