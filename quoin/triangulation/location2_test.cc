// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/location2.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/number/rational.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;
using testing::reproduce;

Rational squared_distance(const Point2& p, const Point2& q) {
  const Rational dx = Rational(p.x) - Rational(q.x);
  const Rational dy = Rational(p.y) - Rational(q.y);
  return dx * dx + dy * dy;
}

// A point of the set, between two of them, or another of the family.
Point2 make_query(Random& random, const testing::PointSetFamily& family, const std::vector<Point2>& points) {
  const Point2& a = points[random() % points.size()];
  const Point2& b = points[random() % points.size()];
  switch (random() % 3) {
    case 0:
      return a;
    case 1:
      return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
    default:
      return family.make(random, 1)[0];
  }
}

void expect_inside(const Delaunay2& d, const Location2& found, const Point2& q) {
  const Triangulation2& links = d.links();
  const auto turn = [&](Edge2 e) { return orientation(d.point(links.source(e)), d.point(links.target(e)), q); };
  switch (found.place) {
    case Location2::Place::vertex:
      EXPECT_EQ(d.point(found.vertex), q);
      break;
    case Location2::Place::edge:
      if (d.dimension() == 1) {
        const Point2& a = d.point(d.line()[found.on_line]);
        const Point2& b = d.point(d.line()[found.on_line + 1]);
        EXPECT_EQ(orientation(a, b, q), Sign::zero);
        EXPECT_TRUE(lexicographically_less(a, q) && lexicographically_less(q, b));
      } else {
        EXPECT_EQ(turn(found.edge), Sign::zero);
        EXPECT_EQ(turn(Triangulation2::next(found.edge)), Sign::positive);
        EXPECT_EQ(turn(Triangulation2::previous(found.edge)), Sign::positive);
      }
      break;
    case Location2::Place::triangle:
      for (unsigned slot = 0; slot < 3; ++slot) EXPECT_EQ(turn(Edge2(found.triangle, slot)), Sign::positive);
      break;
    case Location2::Place::outside:
      if (d.dimension() == 2) {
        EXPECT_TRUE(links.is_infinite(found.edge.triangle()));
        EXPECT_EQ(turn(found.edge), Sign::positive);
      } else if (d.dimension() == 1) {
        const Point2& a = d.point(d.line().front());
        const Point2& b = d.point(d.line().back());
        EXPECT_TRUE(orientation(a, b, q) != Sign::zero || lexicographically_less(q, a) || lexicographically_less(b, q));
      } else {
        EXPECT_NE(d.point(Vertex2(0)), q);
      }
  }
}

TEST(Location2, FacesHoldTheQueryAndNearestIsNearest) {
  Random random(1);
  for (const auto& family : point_sets()) {
    for (const std::size_t count : {1, 2, 3, 5, 60}) {
      const std::vector<Point2> points = family.make(random, count);
      const Delaunay2 delaunay(points);
      for (int k = 0; k < test_rounds(20); ++k) {
        const Point2 query = make_query(random, family, points);
        SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points) + " at " + reproduce(std::vector{query}));
        const Vertex2 near = k % 2 == 0 ? Vertex2() : Vertex2(random() % delaunay.vertex_count());
        expect_inside(delaunay, locate(delaunay, query, near), query);
        Vertex2 expected(0);
        for (std::size_t v = 1; v < delaunay.vertex_count(); ++v) {
          if (squared_distance(delaunay.point(Vertex2(v)), query) < squared_distance(delaunay.point(expected), query)) {
            expected = Vertex2(v);
          }
        }
        ASSERT_EQ(nearest_vertex(delaunay, query, near), expected);
      }
    }
  }
}

/// Along a strip, where walks from end to end meet the limit of steps.
TEST(Location2, FarHintsDoNotChangeWhatIsFound) {
  Random random(4);
  const auto part = [&random] { return std::uniform_real_distribution<double>(0, 1)(random); };
  std::vector<Point2> points;
  for (int i = 0; i < 4000; ++i) {
    for (int k = 0; k < 3; ++k) points.push_back({i + 0.5 * part(), part()});
  }
  const Delaunay2 delaunay(points);
  const Vertex2 first = nearest_vertex(delaunay, {0, 0.5});
  const Vertex2 last = nearest_vertex(delaunay, {4000, 0.5});
  for (int k = 0; k < 200; ++k) {
    const Point2 query{4000 * part(), part()};
    const Location2 expected = locate(delaunay, query);
    for (const Vertex2 hint : {first, last}) {
      const Location2 found = locate(delaunay, query, hint);
      ASSERT_EQ(found.place, expected.place);
      expect_inside(delaunay, found, query);
      if (found.place == Location2::Place::triangle) {
        EXPECT_EQ(found.triangle, expected.triangle);
      }
      EXPECT_EQ(nearest_vertex(delaunay, query, hint), nearest_vertex(delaunay, query));
    }
  }
}

TEST(Location2, DistancesAreComparedExactly) {
  Random random(2);
  for (const testing::Family& family : testing::families()) {
    for (int round = 0; round < test_rounds(300); ++round) {
      const auto p = testing::near_degenerate<Point2, 3>(random, family);
      const Sign expected = sign_of(squared_distance(p[0], p[1]) - squared_distance(p[0], p[2]));
      ASSERT_EQ(compare_distances(p[0], p[1], p[2]), expected) << family.name << testing::reproduce(p);
      ASSERT_EQ(compare_distances(p[0], p[2], p[1]), -expected);
    }
  }
}

TEST(Location2, QueriesThatAreNotFiniteAreRefused) {
  const Delaunay2 delaunay(testing::grid2(2));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(locate(delaunay, {0, infinity}), InputError);
  EXPECT_THROW(nearest_vertex(delaunay, {std::numeric_limits<double>::quiet_NaN(), 0}), InputError);
  EXPECT_TRUE(nearest_vertex(Delaunay2(std::vector<Point2>{}), {0, 0}).is_none());
  EXPECT_EQ(locate(Delaunay2(std::vector<Point2>{}), {0, 0}).place, Location2::Place::outside);
}

}  // namespace
}  // namespace quoin
