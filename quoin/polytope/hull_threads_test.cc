// SPDX-License-Identifier: Apache-2.0
//
// Hulls of so many points that threads share the work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/hull_order.h"
#include "quoin/polytope/hull_simplex.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Point3 gaussian(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

Point3 scaled(const Point3& p, double factor) {
  return {p.x * factor, p.y * factor, p.z * factor};
}

Point3 on_sphere(Random& random) {
  const Point3 p = gaussian(random);
  return scaled(p, 1 / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
}

Point3 rounded_to_integers(const Point3& p) {
  return {std::round(p.x), std::round(p.y), std::round(p.z)};
}

struct Family {
  const char* name;
  std::function<Point3(Random&, int i)> point;
};

const std::vector<Family>& families() {
  static const std::vector<Family> list{
      {"on a sphere", [](Random& r, int) { return on_sphere(r); }},
      {"in a ball", [](Random& r, int) { return scaled(on_sphere(r), std::cbrt(std::ldexp(double(r() >> 11), -53))); }},
      {"in a cube",
       [](Random& r, int) {
         const double x = std::ldexp(double(r() >> 11), -53);
         const double y = std::ldexp(double(r() >> 11), -53);
         return Point3{x, y, std::ldexp(double(r() >> 11), -53)};
       }},
      {"lattice",
       [](Random&, int i) {
         return Point3{double(i % 40), double(i / 40 % 40), double(i / 1600)};
       }},
      // Cospherical and coplanar, and many points several times.
      {"sphere on a grid", [](Random& r, int) { return rounded_to_integers(scaled(on_sphere(r), 90)); }},
      {"coarse sphere on a grid", [](Random& r, int) { return rounded_to_integers(scaled(on_sphere(r), 12)); }},
      {"nearly in a plane",
       [](Random& r, int) {
         const Point3 p = gaussian(r);
         return Point3{p.x, p.y, std::ldexp(std::round(p.z), -50)};
       }},
      {"far away",
       [](Random& r, int) {
         const Point3 p = rounded_to_integers(scaled(gaussian(r), 4));
         return Point3{p.x + 0x1p52, p.y + 0x1p52, p.z - 0x1p52};
       }},
      {"cone of many sizes",
       [](Random& r, int i) {
         const Point3 p = gaussian(r);
         return Point3{std::ldexp(p.x, -i % 60), std::ldexp(p.y, -i % 60), std::ldexp(1.0, -i % 60)};
       }},
      // Every triangle meets both ends: nothing is on one side of a cut across.
      {"two circles",
       [](Random& r, int i) {
         const Point3 p = on_sphere(r);
         const double length = std::hypot(p.x, p.y);
         return Point3{i % 2 == 0 ? -9.0 : 9.0, p.x / length, p.y / length};
       }},
      {"a few points often",
       [](Random& r, int) {
         Random one(r() % 2000);
         return on_sphere(one);
       }},
      {"paraboloid",
       [](Random& r, int) {
         const double x = below(r, 400) - 200;
         const double y = below(r, 400) - 200;
         return Point3{x, y, x * x + y * y};
       }},
      {"huge", [](Random& r, int) { return scaled(on_sphere(r), std::numeric_limits<double>::max() / 2); }},
      {"small", [](Random& r, int) { return scaled(on_sphere(r), 0x1p-300); }},
  };
  return list;
}

Points make(const Family& family, std::uint64_t seed, int count) {
  Random random(seed);
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(family.point(random, i));
  return points;
}

/// A closed surface of left turns that is convex at every edge, and that no point of a sample is beyond: the hull.
void check_convex(const Points& points, const ConvexHull& hull) {
  ASSERT_EQ(hull.dimension, 3);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> facet_at;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      ASSERT_TRUE(facet_at.emplace(std::pair{facet[i], facet[(i + 1) % facet.size()]}, f).second);
    }
  }
  for (const auto& [edge, f] : facet_at) {
    const auto other = facet_at.find({edge.second, edge.first});
    ASSERT_NE(other, facet_at.end());
    const auto facet = hull.facet(f);
    const auto beyond = hull.facet(other->second);
    const std::size_t at = static_cast<std::size_t>(std::ranges::find(beyond, edge.first) - beyond.begin());
    const std::uint32_t opposite = beyond[(at + 1) % beyond.size()];
    ASSERT_EQ(orientation(points[facet[0]], points[facet[1]], points[facet[2]], points[opposite]), Sign::negative);
  }
  ASSERT_EQ(hull.vertices.size() + hull.facet_count(), facet_at.size() / 2 + 2);
  for (std::size_t f = 0; f < hull.facet_count(); f += hull.facet_count() / 16 + 1) {
    const auto facet = hull.facet(f);
    for (const Point3& p : points) {
      ASSERT_NE(orientation(points[facet[0]], points[facet[1]], points[facet[2]], p), Sign::positive);
    }
  }
}

void check_same(const ConvexHull& a, const ConvexHull& b) {
  ASSERT_EQ(a.dimension, b.dimension);
  ASSERT_EQ(a.vertices, b.vertices);
  ASSERT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.facet_begin, b.facet_begin);
}

/// What threads did for the hull of these points. The order is that of `convex_hull`, with all points.
HullBuilder::Tally tally_of(const Points& points, unsigned threads) {
  const Context context({.threads = threads});
  const Simplex simplex = find_simplex(points, context);
  EXPECT_EQ(simplex.count, 4U);
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const RandomOrder order = biased_random_order(points, all, context);
  Points ordered;
  for (const std::uint32_t i : simplex.points) ordered.push_back(points[i]);
  for (const std::uint32_t i : order.points) {
    if (std::ranges::find(simplex.points, i) == simplex.points.end()) ordered.push_back(points[i]);
  }
  HullBuilder builder(ordered, context);
  std::uint32_t begin = 4;
  for (std::size_t round = 1; round <= RandomOrder::rounds; ++round) {
    const auto end = static_cast<std::uint32_t>(std::max<std::size_t>(begin, order.round_begin[round]));
    builder.insert_many(begin, end, context);
    begin = end;
  }
  return builder.tally();
}

// Else the tests below would show nothing of threads.
TEST(ConvexHull, ThreadsShareManyPoints) {
  for (const unsigned threads : {2U, 3U, 4U}) {
    SCOPED_TRACE(threads);
    const HullBuilder::Tally sphere = tally_of(make(families()[0], 1, 24000), threads);
    EXPECT_EQ(sphere.most_sides, threads);
    EXPECT_GE(sphere.on_sides, 20000U);
    // What meets a cut waits, and nothing else.
    EXPECT_GE(sphere.late, 50U);
    EXPECT_LE(sphere.late, sphere.on_sides * (threads - 1) / 6);
    const HullBuilder::Tally circles = tally_of(make(families()[9], 1, 24000), threads);
    EXPECT_EQ(circles.most_sides, threads);
    EXPECT_GE(circles.late, circles.on_sides / 3);
  }
  EXPECT_EQ(tally_of(make(families()[0], 1, 24000), 1).most_sides, 0U);
}

TEST(ConvexHull, TheSameOnAnyNumberOfThreads) {
  for (std::uint64_t seed = 0; seed < families().size(); seed += tests_take_fewer_rounds ? 3 : 1) {
    const Family& family = families()[seed];
    SCOPED_TRACE(family.name);
    // Enough for two sides, and for four in what is not sanitized.
    const Points points = make(family, seed, tests_take_fewer_rounds ? 12000 : 24000);
    const ConvexHull hull = convex_hull(points, one_thread);
    ASSERT_NO_FATAL_FAILURE(check_convex(points, hull));
    for (const unsigned threads : {2U, 3U, 4U}) {
      SCOPED_TRACE(threads);
      ASSERT_NO_FATAL_FAILURE(check_same(hull, convex_hull(points, Context({.threads = threads}))));
    }
  }
}

// The first of equal points is the vertex, also where it had to wait for another thread's points; a point far away
// makes all others be in one cell of the first curve.
TEST(ConvexHull, ThreadsKeepTheFirstOfEqualPoints) {
  for (const bool has_far_point : {false, true}) {
    Random random(11);
    Points points;
    while (points.size() < 8000) points.push_back(on_sphere(random));
    if (has_far_point) points[0] = {0, 0, 0x1p20};
    while (points.size() < 24000) points.push_back(points[points.size() - 8000]);
    for (int i = 0; i < 8000; ++i) points.push_back(points[random() % points.size()]);
    const ConvexHull expected = convex_hull(std::span(points).first(8000), one_thread);
    for (const unsigned threads : {1U, 2U, 4U}) {
      SCOPED_TRACE(threads);
      ASSERT_NO_FATAL_FAILURE(check_same(expected, convex_hull(points, Context({.threads = threads}))));
    }
  }
}

// A point waits as it sees a border; others hide the border from a later point that equals it, which becomes a corner.
// In the end the first gives its name. Without a curve equal points are far from each other in the order.
TEST(HullBuilder, ThreadsRenameCornersThatWereNotFirst) {
  constexpr std::uint32_t distinct = 6000;
  Points points = make(families()[0], 5, distinct);
  while (points.size() < 4 * distinct) points.push_back(points[points.size() - distinct]);
  for (const unsigned threads : {2U, 4U}) {
    SCOPED_TRACE(threads);
    const Context context({.threads = threads});
    HullBuilder builder(points, context);
    builder.insert_many(4, 2000, context);
    builder.insert_many(2000, static_cast<std::uint32_t>(points.size()), context);
    EXPECT_EQ(builder.tally().most_sides, threads);
    EXPECT_GE(builder.tally().renamed, 20U);
    std::vector<bool> is_corner(distinct, false);
    for (const HullBuilder::Triangle& t : builder.triangles()) {
      if (t.is_free()) continue;
      for (const std::uint32_t corner : t.corners) {
        ASSERT_LT(corner, distinct);
        is_corner[corner] = true;
      }
    }
    EXPECT_EQ(std::ranges::count(is_corner, true), distinct);
  }
}

TEST(ConvexHull, ThreadsRefuseTheFirstPointThatIsNotFinite) {
  Points points = make(families()[0], 1, 60000);
  points[41000].y = std::numeric_limits<double>::infinity();
  points[59000].z = std::numeric_limits<double>::quiet_NaN();
  for (const unsigned threads : {1U, 2U, 4U}) {
    try {
      convex_hull(points, Context({.threads = threads}));
      FAIL() << "not refused";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "point 41000 has a coordinate that is not finite");
    }
  }
}

TEST(ConvexHull, ThreadsMayBeCancelled) {
  const Points points = make(families()[0], 1, tests_take_fewer_rounds ? 20000 : 100000);
  constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
  const Context whole({.threads = 2, .most_polls = unlimited});
  ASSERT_EQ(convex_hull(points, whole).vertices.size(), points.size());
  ASSERT_GT(whole.polls(), 32U);
  // At several places, so that each step is interrupted once.
  for (const std::uint64_t sixteenths : {0U, 1U, 2U, 4U, 6U, 8U, 10U, 12U, 14U, 15U}) {
    const Context context({.threads = 2, .most_polls = whole.polls() * sixteenths / 16});
    EXPECT_THROW(convex_hull(points, context), Cancelled) << sixteenths;
  }
  Context cancelled({.threads = 2});
  cancelled.cancel();
  EXPECT_THROW(convex_hull(points, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
