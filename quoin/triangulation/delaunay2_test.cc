// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/check2.h"
#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::PointSetFamily;
using testing::Random;
using testing::reproduce;

using Corners = std::array<Point2, 3>;

bool precedes(const Point2& a, const Point2& b) {
  return lexicographically_less(a, b);
}

struct CornersLess {
  bool operator()(const Corners& a, const Corners& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), precedes);
  }
};

using TriangleSet = std::set<Corners, CornersLess>;

Corners rotated(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), precedes), corners.end());
  return corners;
}

TriangleSet finite_triangles(const Delaunay2& delaunay) {
  TriangleSet found;
  for (std::uint32_t t = 0; t < delaunay.links().triangle_count(); ++t) {
    if (delaunay.links().is_infinite(Triangle2(t))) continue;
    const auto v = delaunay.links().corners(Triangle2(t));
    found.insert(rotated({delaunay.point(v[0]), delaunay.point(v[1]), delaunay.point(v[2])}));
  }
  return found;
}

// By definition: triangles that no other point is in the circle of, ties decided by the rule.
TriangleSet brute_force(const std::vector<Point2>& p) {
  TriangleSet found;
  for (const Point2& a : p) {
    for (const Point2& b : p) {
      for (const Point2& c : p) {
        if (orientation(a, b, c) != Sign::positive) continue;
        const bool is_empty = std::none_of(p.begin(), p.end(), [&](const Point2& d) {
          if (d == a || d == b || d == c) return false;
          const Sign side = in_circle(a, b, c, d);
          return side == Sign::zero ? is_in_circle_by_tie(a, b, c, d) : side == Sign::positive;
        });
        if (is_empty) found.insert(rotated({a, b, c}));
      }
    }
  }
  return found;
}

TEST(Delaunay2, TrianglesAreThoseWithEmptyCircles) {
  Random random(1);
  for (const PointSetFamily& family : point_sets()) {
    for (int round = 0; round < test_rounds(12); ++round) {
      const std::vector<Point2> points = family.make(random, 1 + random() % 14);
      SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points));
      const Delaunay2 delaunay(points);
      ASSERT_EQ(defect(delaunay, points), "");
      ASSERT_EQ(finite_triangles(delaunay), brute_force(points));
    }
  }
}

TEST(Delaunay2, CertificatesHoldInEveryFamily) {
  Random random(2);
  for (const PointSetFamily& family : point_sets()) {
    for (const std::size_t count : {100, 1500}) {
      const std::vector<Point2> points = family.make(random, test_rounds(count));
      SCOPED_TRACE(std::string(family.name) + ", " + std::to_string(count));
      const Delaunay2 delaunay(points);
      ASSERT_EQ(defect(delaunay, points), "");
      const Delaunay2 canonical(points, {.canonical = true});
      ASSERT_EQ(defect(canonical, points), "");
      ASSERT_EQ(finite_triangles(canonical), finite_triangles(delaunay));
    }
  }
}

bool same_bytes(const Delaunay2& a, const Delaunay2& b) {
  const auto same = [](const TriangleLinks2& s, const TriangleLinks2& t) {
    return s.corner == t.corner && s.across == t.across;
  };
  const auto finite = [](const Delaunay2& d) { return d.points().first(d.vertex_count()); };
  return std::equal(finite(a).begin(), finite(a).end(), finite(b).begin(), finite(b).end()) &&
         std::equal(a.links().links().begin(), a.links().links().end(), b.links().links().begin(),
                    b.links().links().end(), same) &&
         std::equal(a.line().begin(), a.line().end(), b.line().begin(), b.line().end());
}

TEST(Delaunay2, AllOrdersOfSmallInputsGiveTheSameBytes) {
  Random random(3);
  for (const PointSetFamily& family : point_sets()) {
    std::vector<Point2> points = family.make(random, tests_take_fewer_rounds ? 5 : 6);
    std::sort(points.begin(), points.end(), precedes);
    SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points));
    const Delaunay2 first(points);
    do {
      ASSERT_TRUE(same_bytes(first, Delaunay2(points)));
    } while (std::next_permutation(points.begin(), points.end(), precedes));
  }
}

TEST(Delaunay2, OrdersOfLargerInputsGiveTheSameBytes) {
  Random random(4);
  for (const PointSetFamily& family : point_sets()) {
    std::vector<Point2> points = family.make(random, test_rounds(500));
    const Delaunay2 first(points);
    for (int round = 0; round < 5; ++round) {
      std::shuffle(points.begin(), points.end(), random);
      ASSERT_TRUE(same_bytes(first, Delaunay2(points))) << family.name;
    }
  }
}

// Some of the points lie in one cell of the curve, too few to divide it further, and more than that when given twice.
TEST(Delaunay2, PointsGivenTwiceGiveTheSameBytes) {
  Random random(6);
  for (int count = 20; count < 60; count += 10) {
    for (const PointSetFamily& family : point_sets()) {
      std::vector<Point2> points = family.make(random, static_cast<std::size_t>(count));
      for (int i = 0; i < count; ++i)
        points.push_back({testing::fraction(random) * 0x1p-20, testing::fraction(random) * 0x1p-20});
      points.push_back({1, 1});
      const Delaunay2 once(points);
      const std::vector<Point2> copy = points;
      points.insert(points.end(), copy.begin(), copy.end());
      ASSERT_TRUE(same_bytes(once, Delaunay2(points))) << family.name;
      points.insert(points.end(), 100, points[0]);
      ASSERT_TRUE(same_bytes(once, Delaunay2(points))) << family.name;
    }
  }
}

TEST(Delaunay2, EverySubsetOfASmallLattice) {
  const std::vector<Point2> lattice = testing::grid2(2);
  for (unsigned subset = 0; subset < 1U << lattice.size(); ++subset) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      if ((subset >> i & 1) != 0) points.push_back(lattice[i]);
    }
    ASSERT_EQ(defect(Delaunay2(points), points), "") << reproduce(points);
  }
}

TEST(Delaunay2, MultiplicitiesAndDimensions) {
  EXPECT_EQ(Delaunay2(std::vector<Point2>{}).dimension(), -1);
  const Delaunay2 one(std::vector<Point2>{{1, 0.0}, {1, -0.0}, {1, 0.0}});
  EXPECT_EQ(one.dimension(), 0);
  ASSERT_EQ(one.vertex_count(), 1U);
  EXPECT_EQ(one.inputs(Vertex2(0)).size(), 3U);
  const Delaunay2 line(std::vector<Point2>{{2, 2}, {0, 0}, {1, 1}, {0, 0}});
  EXPECT_EQ(line.dimension(), 1);
  ASSERT_EQ(line.line().size(), 3U);
  EXPECT_EQ(line.point(line.line()[1]), (Point2{1, 1}));
  EXPECT_EQ(line.vertices_of_inputs()[1], line.vertices_of_inputs()[3]);
  const Delaunay2 square(testing::grid2(1));
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_EQ(square.links().triangle_count(), 6U);
  EXPECT_EQ(square.links().finite_triangle_count(), 2U);
}

TEST(Delaunay2, PointsThatAreNotFiniteAreNamed) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    for (const Point2& p : {Point2{bad, 0}, Point2{0, bad}}) {
      try {
        const Delaunay2 delaunay(std::vector<Point2>{{0, 0}, {1, 0}, p, {0, 1}});
        FAIL() << delaunay.vertex_count();
      } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "point 2 is not finite");
      }
    }
  }
}

TEST(Delaunay2, CancelledBeforeTheEnd) {
  Random random(5);
  const std::vector<Point2> points = point_sets()[0].make(random, 100000);
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(Delaunay2(points, {}, cancelled), Cancelled);
  Context* running = nullptr;
  bool is_within = false;
  Context context({.progress = [&](std::string_view, double done) {
    is_within = done > 0 && done < 1;
    running->cancel();
  }});
  running = &context;
  EXPECT_THROW(Delaunay2(points, {}, context), Cancelled);
  EXPECT_TRUE(is_within);
}

}  // namespace
}  // namespace quoin
