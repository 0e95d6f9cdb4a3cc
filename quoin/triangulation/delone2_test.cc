// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;
using testing::reproduce;

// By definition: sets of all vertices on a circle through three of them that has none inside.
std::set<std::vector<Vertex2>> brute_force(const Delaunay2& d) {
  std::set<std::vector<Vertex2>> cells;
  const auto n = static_cast<std::uint32_t>(d.vertex_count());
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = 0; b < n; ++b) {
      for (std::uint32_t c = 0; c < n; ++c) {
        if (orientation(d.points()[a], d.points()[b], d.points()[c]) != Sign::positive) continue;
        std::vector<Vertex2> on;
        bool is_empty = true;
        for (std::uint32_t v = 0; v < n && is_empty; ++v) {
          const Sign side = in_circle(d.points()[a], d.points()[b], d.points()[c], d.points()[v]);
          is_empty = side != Sign::positive;
          if (side == Sign::zero) on.emplace_back(v);
        }
        if (is_empty) cells.insert(on);
      }
    }
  }
  return cells;
}

TEST(Delone2, CellsAreTheEmptyCirclesAndConvex) {
  Random random(1);
  for (const auto& family : point_sets()) {
    for (int round = 0; round < test_rounds(8); ++round) {
      const std::vector<Point2> points = family.make(random, 1 + random() % 16);
      SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points));
      const Delaunay2 delaunay(points);
      const Delone2 delone(delaunay);
      std::set<std::vector<Vertex2>> cells;
      std::vector<Vertex2> last;
      for (std::size_t i = 0; i < delone.cell_count(); ++i) {
        const auto corners = delone.corners(DeloneCell2(i));
        std::vector<Vertex2> sorted(corners.begin(), corners.end());
        EXPECT_LT(last, sorted);
        last = sorted;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const auto at = [&](std::size_t j) { return delaunay.point(corners[j % corners.size()]); };
          EXPECT_EQ(orientation(at(k), at(k + 1), at(k + 2)), Sign::positive);
        }
        std::sort(sorted.begin(), sorted.end());
        EXPECT_TRUE(cells.insert(sorted).second);
      }
      ASSERT_EQ(cells, brute_force(delaunay));
    }
  }
}

TEST(Delone2, OfALatticeAreSquares) {
  const std::vector<Point2> points = testing::grid2(30);
  const Delaunay2 delaunay(points);
  const Delone2 delone(delaunay);
  ASSERT_EQ(delone.cell_count(), 900U);
  std::size_t triangles = 0;
  for (std::uint32_t t = 0; t < delaunay.links().triangle_count(); ++t) {
    const DeloneCell2 cell = delone.cell(Triangle2(t));
    EXPECT_EQ(cell.is_none(), delaunay.links().is_infinite(Triangle2(t)));
    if (cell.is_none()) continue;
    ++triangles;
    EXPECT_EQ(delone.corners(cell).size(), 4U);
    for (const Vertex2 v : delaunay.links().corners(Triangle2(t))) {
      EXPECT_NE(std::find(delone.corners(cell).begin(), delone.corners(cell).end(), v), delone.corners(cell).end());
    }
  }
  EXPECT_EQ(triangles, 1800U);
}

TEST(Delone2, AxesMayBeSwappedAndReversed) {
  Random random(2);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> points = family.make(random, test_rounds(200));
    using Cell = std::set<std::pair<double, double>>;
    const auto cells_of = [](const std::vector<Point2>& given, bool swap, double sx, double sy) {
      const Delaunay2 delaunay(given);
      const Delone2 delone(delaunay);
      std::set<Cell> cells;
      for (std::size_t i = 0; i < delone.cell_count(); ++i) {
        Cell cell;
        for (const Vertex2 v : delone.corners(DeloneCell2(i))) {
          const Point2& p = delaunay.point(v);
          const double x = sx * p.x + 0.0;
          const double y = sy * p.y + 0.0;
          cell.insert(swap ? std::pair(y, x) : std::pair(x, y));
        }
        cells.insert(cell);
      }
      return cells;
    };
    std::vector<Point2> moved;
    for (const Point2& p : points) moved.push_back({-p.y, p.x});
    EXPECT_EQ(cells_of(points, false, 1, 1), cells_of(moved, true, -1, 1)) << family.name;
  }
}

}  // namespace
}  // namespace quoin
