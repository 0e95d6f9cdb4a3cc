// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/voronoi2.h"

#include <gtest/gtest.h>

#include <map>

#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;
using testing::reproduce;

// What of a polygon is nearer to a than to b: |x - a|^2 <= |x - b|^2.
std::vector<RationalPoint2> clip(const std::vector<RationalPoint2>& polygon, const Point2& a, const Point2& b) {
  const auto side = [&](const RationalPoint2& x) {
    const Rational ax = x.x - Rational(a.x);
    const Rational ay = x.y - Rational(a.y);
    const Rational bx = x.x - Rational(b.x);
    const Rational by = x.y - Rational(b.y);
    return bx * bx + by * by - ax * ax - ay * ay;
  };
  std::vector<RationalPoint2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint2& p = polygon[i];
    const RationalPoint2& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = side(p);
    const Rational at_q = side(q);
    if (at_p.sign() != Sign::negative) kept.push_back(p);
    if (at_p.sign() * at_q.sign() == Sign::negative) {
      const Rational t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

Rational area(const std::vector<RationalPoint2>& polygon) {
  Rational twice;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint2& p = polygon[i];
    const RationalPoint2& q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / Rational(2);
}

// Half-planes cut a box that is far larger than any bounded cell of points of some grid.
TEST(Voronoi2, AreasAreThoseOfHalfPlanes) {
  Random random(1);
  for (int round = 0; round < test_rounds(40); ++round) {
    std::vector<Point2> points;
    const int size = 1 + static_cast<int>(random() % 6);
    for (std::size_t i = 1 + random() % 14; i > 0; --i) {
      points.push_back({testing::small_integer(random, size), testing::small_integer(random, size)});
    }
    SCOPED_TRACE(reproduce(points));
    const Delaunay2 delaunay(points);
    const Delone2 delone(delaunay);
    const Voronoi2 voronoi(delaunay, delone);
    const Rational far(1000000);
    for (std::size_t v = 0; v < delaunay.vertex_count(); ++v) {
      std::vector<RationalPoint2> polygon{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
      for (std::size_t w = 0; w < delaunay.vertex_count(); ++w) {
        if (w != v) polygon = clip(polygon, delaunay.points()[v], delaunay.points()[w]);
      }
      bool is_bounded = true;
      for (const RationalPoint2& p : polygon) is_bounded = is_bounded && abs(p.x) < far && abs(p.y) < far;
      const std::optional<Rational> found = voronoi.area(Vertex2(v));
      ASSERT_EQ(found.has_value(), is_bounded);
      if (!found) continue;
      EXPECT_EQ(*found, area(polygon));
      EXPECT_EQ(voronoi.cell(Vertex2(v)).corners.size(), polygon.size());
    }
  }
}

TEST(Voronoi2, OfALattice) {
  const std::vector<Point2> points = testing::grid2(3);
  const Delaunay2 delaunay(points);
  const Delone2 delone(delaunay);
  const Voronoi2 voronoi(delaunay, delone);
  EXPECT_EQ(voronoi.vertex_count(), 9U);
  EXPECT_EQ(voronoi.squared_radius(DeloneCell2(0)), Rational(1) / Rational(2));
  std::size_t bounded = 0;
  for (std::size_t v = 0; v < 16; ++v) {
    const auto found = voronoi.area(Vertex2(v));
    if (!found) continue;
    ++bounded;
    EXPECT_EQ(*found, Rational(1));
  }
  EXPECT_EQ(bounded, 4U);
  EXPECT_EQ(voronoi.edges().size(), 24U);
}

// Each vertex ends as many edges as its cell has sides; ends are on the bisector; cells of sites have the same edges.
TEST(Voronoi2, EdgesJoinVertices) {
  Random random(2);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> points = family.make(random, test_rounds(40));
    SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points));
    const Delaunay2 delaunay(points);
    const Delone2 delone(delaunay);
    const Voronoi2 voronoi(delaunay, delone);
    std::map<DeloneCell2, std::size_t> degree;
    std::map<Vertex2, std::size_t> sides;
    for (const VoronoiEdge2& e : voronoi.edges()) {
      for (const DeloneCell2 end : {e.from, e.to}) {
        if (end.is_none()) continue;
        ++degree[end];
        const RationalPoint2 p = voronoi.vertex(end);
        const auto distance = [&](Vertex2 v) {
          const Rational dx = p.x - Rational(delaunay.point(v).x);
          const Rational dy = p.y - Rational(delaunay.point(v).y);
          return dx * dx + dy * dy;
        };
        EXPECT_EQ(distance(e.left), distance(e.right));
        EXPECT_EQ(distance(e.left), voronoi.squared_radius(end));
      }
      if (!e.from.is_none() && !e.to.is_none()) {
        // The left site is on the left.
        const RationalPoint2 p = voronoi.vertex(e.from);
        const RationalPoint2 q = voronoi.vertex(e.to);
        const Point2& left = delaunay.point(e.left);
        EXPECT_EQ(sign_of((q.x - p.x) * (Rational(left.y) - p.y) - (q.y - p.y) * (Rational(left.x) - p.x)),
                  Sign::positive);
      }
      ++sides[e.left];
      ++sides[e.right];
    }
    for (std::size_t c = 0; c < delone.cell_count(); ++c) {
      EXPECT_EQ(degree[DeloneCell2(c)], delone.corners(DeloneCell2(c)).size());
    }
    if (delaunay.dimension() < 2) continue;
    for (std::size_t v = 0; v < delaunay.vertex_count(); ++v) {
      const VoronoiCell2 cell = voronoi.cell(Vertex2(v));
      EXPECT_EQ(sides[Vertex2(v)], cell.corners.size() + (cell.is_bounded ? 0 : 1));
    }
  }
}

}  // namespace
}  // namespace quoin
