// SPDX-License-Identifier: Apache-2.0
//
// Hulls of rationals and of constructed points against hulls of doubles and against the definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_sums.h"

namespace quoin {
namespace {

using namespace test_polytopes;
using RationalPoints = std::vector<RationalPoint3>;

void expect_equal(const ConvexHull& a, const ConvexHull& b) {
  ASSERT_EQ(a.dimension, b.dimension);
  ASSERT_EQ(a.vertices, b.vertices);
  ASSERT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.facet_begin, b.facet_begin);
}

RationalPoints exact(const Points& points) {
  RationalPoints result;
  for (const Point3& p : points) result.push_back(exact_point(p));
  return result;
}

/// A map that keeps orientation and the order of coordinates: what is added depends on coordinates before.
RationalPoints sheared(const Points& points, const Rational& scale) {
  const Rational a = Rational(2) / Rational(7);
  const Rational b = Rational(-5) / Rational(11);
  RationalPoints result;
  for (const RationalPoint3& p : exact(points)) {
    result.push_back(RationalPoint3{p.x + Rational(1) / Rational(3), p.y + a * p.x, p.z + b * p.x + a * p.y} * scale);
  }
  return result;
}

TEST(RationalHull, IsThatOfDoubles) {
  std::array<int, 4> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(250U); ++seed) {
    Random random(seed);
    const Points points = seed % 5 == 4 ? on_a_small_grid(random, 1, 30) : on_a_small_flat(random, int(seed % 5));
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ConvexHull expected = convex_hull(points, one_thread);
    ++seen.at(static_cast<std::size_t>(expected.dimension));
    RationalPoints thirds;
    for (const RationalPoint3& p : exact(points)) thirds.push_back(p * (Rational(1) / Rational(3)));
    ASSERT_NO_FATAL_FAILURE(expect_equal(convex_hull(exact(points), one_thread), expected));
    ASSERT_NO_FATAL_FAILURE(expect_equal(convex_hull(thirds, one_thread), expected));
    for (const double scale : {1.0, 0x1p1000, 0x1p-1074, 0x1p-540}) {
      const ConvexHull hull = convex_hull(sheared(points, Rational(scale)), one_thread);
      ASSERT_EQ(hull.dimension, expected.dimension);
      // The axis from which a polygon is seen may be another one.
      if (hull.dimension != 2) {
        ASSERT_NO_FATAL_FAILURE(expect_equal(hull, expected));
      }
      ASSERT_EQ(hull.vertices, expected.vertices);
    }
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(20));
}

// Far below what doubles tell apart: all round to one point or to a few.
/// A map of the plane that keeps orientation and lexicographic order changes nothing.
TEST(RationalHull, InThePlaneIsThatOfDoubles) {
  for (std::uint64_t seed = 0; seed < test_rounds(300U); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::uint64_t size = 1 + random() % 12;
    std::vector<Point2> points(1 + random() % 30);
    for (Point2& p : points) p = {static_cast<double>(random() % size), static_cast<double>(random() % size)};
    std::vector<RationalPoint2> exact;
    std::vector<RationalPoint2> close;
    for (const Point2& p : points) {
      const Rational x = Rational(p.x) / Rational(3);
      const Rational y = Rational(p.y) / Rational(7) + x * Rational(5);
      exact.push_back({x, y});
      close.push_back({Rational(1) + x * Rational(0x1p-80), y * Rational(0x1p-80) - Rational(9)});
    }
    const ConvexHull expected = convex_hull(points, one_thread);
    expect_equal(convex_hull(exact, one_thread), expected);
    expect_equal(convex_hull(close, one_thread), expected);
    if (HasFailure()) return;
  }
  EXPECT_EQ(convex_hull(std::vector<RationalPoint2>{}, one_thread).dimension, -1);
  const Rational huge = Rational(0x1p1000) * Rational(0x1p1000);
  EXPECT_THROW(convex_hull(std::vector<RationalPoint2>{{huge, Rational(0)}}, one_thread), InputError);
}

TEST(RationalHull, OfPointsThatRoundToOne) {
  Rational tiny(1);
  for (int i = 0; i < 25; ++i) tiny /= Rational(1000);
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    Random random(seed);
    const Points points = on_a_small_grid(random, 4, 20);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ConvexHull expected = convex_hull(points, one_thread);
    for (const RationalPoint3& origin : {RationalPoint3{0, 0, 0}, RationalPoint3{Rational(1) / Rational(3), 5, 7}}) {
      RationalPoints close;
      RationalPoints beyond;  // below the smallest double
      for (const RationalPoint3& p : exact(points)) {
        close.push_back(origin + p * tiny);
        beyond.push_back(origin + p * (tiny * tiny * tiny * tiny * tiny));
      }
      ASSERT_NO_FATAL_FAILURE(expect_equal(convex_hull(close, one_thread), expected));
      ASSERT_NO_FATAL_FAILURE(expect_equal(convex_hull(beyond, one_thread), expected));
    }
  }
}

TEST(RationalHull, OfManyPoints) {
  Random random(3);
  std::normal_distribution<double> normal;
  Points points;
  for (int i = 0; i < 1500; ++i) points.push_back({normal(random), normal(random), normal(random)});
  const ConvexHull expected = convex_hull(points, one_thread);
  RationalPoints thirds;
  for (const RationalPoint3& p : exact(points)) thirds.push_back(p * (Rational(1) / Rational(3)));
  expect_equal(convex_hull(thirds, one_thread), expected);
}

TEST(RationalHull, RefusesWhatIsBeyondDoubles) {
  Rational huge(0x1p1000);
  huge *= huge;
  try {
    convex_hull(RationalPoints{{0, 0, 0}, {1, huge, 0}}, one_thread);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("point 1"), std::string::npos);
  }
  EXPECT_EQ(convex_hull(RationalPoints{}, one_thread).dimension, -1);
}

/// A plane through three points with all others on one side.
std::set<std::set<std::uint32_t>> facets_by_definition(const RationalPoints& points) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::set<std::set<std::uint32_t>> flats;
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = b + 1; c < n; ++c) {
        const RationalPoint3 normal = cross(points[b] - points[a], points[c] - points[a]);
        std::set<std::uint32_t> on;
        std::array<bool, 3> has{};
        for (std::uint32_t d = 0; d < n; ++d) {
          const Sign side = dot(normal, points[d] - points[a]).sign();
          has.at(static_cast<std::size_t>(static_cast<int>(side) + 1)) = true;
          if (side == Sign::zero) on.insert(d);
        }
        if (has[0] != has[2]) flats.insert(on);
      }
    }
  }
  return flats;
}

/// Explicit points, points where lines meet planes, and means with weights; many lie in planes of others.
TEST(ConstructedHull, AgreesWithTheDefinition) {
  int solid = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(80U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points given = on_a_small_grid(random, 5, 3);
    const auto id = [](std::size_t i) { return PointId(i); };
    const auto pick = [&] { return static_cast<std::size_t>(below(random, static_cast<int>(given.size()))); };
    Constructions table(given);
    constexpr std::size_t count = 6;
    table.resize_planes(count);
    table.resize_points(given.size() + count);
    std::vector<PointId> ids;
    for (std::size_t i = 0; i < given.size(); ++i) ids.push_back(id(i));
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<std::size_t, 5> p{pick(), pick(), pick(), pick(), pick()};
      const auto vector = [&](std::size_t k, std::size_t l) {
        return exact_point(given[p[l]]) - exact_point(given[p[k]]);
      };
      const RationalPoint3 normal = cross(vector(0, 1), vector(0, 2));
      const PointId point = id(given.size() + i);
      if (dot(normal, vector(3, 4)).sign() != Sign::zero) {
        const PlaneId plane(i);
        table.set_plane(plane, id(p[0]), id(p[1]), id(p[2]));
        table.set_point(point, id(p[3]), id(p[4]), plane);
      } else {
        table.set_point(point, {id(p[0]), id(p[1]), id(p[2])}, {1, 1, 1});
      }
      ids.push_back(point);
    }
    std::shuffle(ids.begin(), ids.end(), random);
    RationalPoints points;
    for (const PointId p : ids) points.push_back(table.exact(p));
    const ConvexHull hull = convex_hull(table, ids, one_thread);
    ASSERT_NO_FATAL_FAILURE(expect_equal(convex_hull(points, one_thread), hull));
    if (hull.dimension < 3) continue;
    ++solid;
    std::set<std::set<std::uint32_t>> expected;
    for (const std::set<std::uint32_t>& flat : facets_by_definition(points)) {
      std::set<std::uint32_t> corners;
      std::ranges::set_intersection(flat, hull.vertices, std::inserter(corners, corners.end()));
      expected.insert(corners);
    }
    std::set<std::set<std::uint32_t>> found;
    for (std::size_t f = 0; f < hull.facet_count(); ++f) found.emplace(hull.facet(f).begin(), hull.facet(f).end());
    ASSERT_EQ(found, expected);
    // The first of equal points.
    for (const std::uint32_t v : hull.vertices) ASSERT_EQ(std::ranges::find(points, points[v]) - points.begin(), v);
  }
  EXPECT_GE(solid, test_cases(30));
}

}  // namespace
}  // namespace quoin
