// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/check3.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

const Context context({.threads = 1});

std::vector<Point3> vertices_of(const Delaunay3& t) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) points.push_back(t.point(v));
  return points;
}

TEST(Check3, NothingIsWrongInAllFamilies) {
  Random random(4);
  for (const std::size_t size : {1, 2, 3, 5, 90}) {
    for (const Cloud& cloud : testing::clouds(random, size)) {
      SCOPED_TRACE(cloud.name);
      const Delaunay3 t(cloud.points, context);
      EXPECT_EQ(defect(t, cloud.points, context), "") << size;
    }
  }
}

TEST(Check3, OtherPointsAreNoticed) {
  Random random(5);
  for (const Cloud& cloud : testing::clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t(cloud.points, context);
    std::vector<Point3> others = cloud.points;
    others.back().x += 1e300;
    EXPECT_NE(defect(t, others, context), "");
    others.pop_back();
    EXPECT_NE(defect(t, others, context), "");
  }
}

/// Points moved under the cells: where the triangulation of the moved ones is another, the old cells are wrong.
TEST(Check3, CellsOfOtherPointsAreWrong) {
  Random random(6);
  std::size_t wrong = 0;
  for (const Cloud& cloud : testing::clouds(random, 60)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t(cloud.points, context);
    if (t.dimension() < 2) continue;
    std::vector<Point3> points = vertices_of(t);
    std::swap(points.front(), points.back());
    wrong += defect_of_cells(t.cells(), t.dimension(), points, context).empty() ? 0 : 1;
  }
  EXPECT_GT(wrong, 5U);
}

TEST(Check3, BrokenLinksAreNoticed) {
  Random random(7);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 t(cloud.points, context);
    const std::vector<Point3> points = vertices_of(t);
    std::vector<TriangulationCell> cells(t.cells().begin(), t.cells().end());
    const auto expect_defect = [&] { EXPECT_NE(defect_of_cells(cells, t.dimension(), points, context), ""); };
    for (std::size_t c = 0; c < cells.size(); c += 1 + cells.size() / 20) {
      const TriangulationCell saved = cells[c];
      cells[c].neighbours[0] = static_cast<std::uint32_t>(4 * cells.size());
      expect_defect();
      cells[c] = saved;
      cells[c].vertices[0] = static_cast<std::uint32_t>(points.size());
      expect_defect();
      cells[c] = saved;
      if (t.dimension() >= 2 && !t.is_ghost(c)) {
        std::swap(cells[c].vertices[0], cells[c].vertices[1]);
        std::swap(cells[c].neighbours[0], cells[c].neighbours[1]);
        expect_defect();
        cells[c] = saved;
      }
    }
  }
}

/// Both diagonals of a kite make a triangulation; one of them is Delaunay.
TEST(Check3, TheOtherDiagonalIsNotDelaunay) {
  const std::vector<Point3> kite{{0, 0, 5}, {4, 0, 5}, {2, 1, 5}, {2, -1, 5}};
  const Delaunay3 t(kite, context);
  ASSERT_EQ(t.dimension(), 2);
  std::vector<Point3> moved = vertices_of(t);
  EXPECT_EQ(defect_of_cells(t.cells(), 2, moved, context), "");
  for (Point3& p : moved) p.y = p.y * 8;  // now the other diagonal is right
  EXPECT_NE(defect_of_cells(t.cells(), 2, moved, context), "");
}

TEST(Check3, Cancellation) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Delaunay3 t(points, context);
  Context cancelled({.threads = 1});
  cancelled.cancel();
  EXPECT_THROW(defect(t, points, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
