// SPDX-License-Identifier: Apache-2.0
//
// The order in which points enter: what follows each other is near, whatever the sizes that the points span.
#include "quoin/polytope/hull_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

RandomOrder order_of(const Points& points, const Context& context = one_thread) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return biased_random_order(points, all, context);
}

double draw(Random& random) {
  return std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
}

/// (t, t^2, t^3) for t in [-1, 1], times a power of two.
void append_curve(Points& points, Random& random, std::size_t count, int exponent) {
  for (std::size_t i = 0; i < count; ++i) {
    const double t = draw(random);
    points.push_back({std::ldexp(t, exponent), std::ldexp(t * t, exponent), std::ldexp(t * t * t, exponent)});
  }
}

/// How far one goes along x from each to the next within each round.
double length_along_x(const Points& points, const RandomOrder& order) {
  double length = 0;
  for (std::size_t round = 0; round < RandomOrder::rounds; ++round) {
    for (std::size_t i = order.round_begin[round]; i + 1 < order.round_begin[round + 1]; ++i) {
      length += std::fabs(points[order.points[i + 1]].x - points[order.points[i]].x);
    }
  }
  return length;
}

/// Each is there once, and the first of equal ones first.
void check_order(const Points& points, const RandomOrder& order) {
  ASSERT_EQ(order.points.size(), points.size());
  ASSERT_EQ(order.round_begin[0], 0U);
  ASSERT_EQ(order.round_begin[RandomOrder::rounds], points.size());
  ASSERT_TRUE(std::is_sorted(order.round_begin.begin(), order.round_begin.end()));
  std::vector<std::uint32_t> sorted(order.points);
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
  std::map<std::tuple<double, double, double>, std::uint32_t> last;
  for (const std::uint32_t i : order.points) {
    const Point3& p = points[i];
    const auto [place, is_new] = last.try_emplace({p.x, p.y, p.z}, i);
    ASSERT_TRUE(is_new || place->second < i);
    place->second = i;
  }
}

// Each round goes along the curve, back and forth within cells. Had a point far away all others be in one cell, in the
// order of the input, each of 25,000 steps would be two thirds on average.
TEST(HullOrder, OnePointFarAwayLeavesTheOthersInOrder) {
  for (const double away : {0.0, 0x1p20, 0x1p200, 0x1p1000}) {
    SCOPED_TRACE(away);
    Random random(1);
    Points points;
    append_curve(points, random, 25000, 0);
    if (away != 0) points.push_back({0, 0, away});
    const RandomOrder order = order_of(points);
    ASSERT_NO_FATAL_FAILURE(check_order(points, order));
    EXPECT_LT(length_along_x(points, order), 8.0 * RandomOrder::rounds);
  }
}

// Curves within curves, each smaller by more than a cell, down to the least doubles, and points far away.
TEST(HullOrder, OfAllSizesAtOnce) {
  Points points;
  Random random(2);
  std::vector<double> sizes;
  for (int exponent = 900; exponent >= -1040; exponent -= 97) {
    append_curve(points, random, 1500, exponent);
    sizes.push_back(std::ldexp(1.0, exponent));
  }
  points.push_back({0, 0x1p1023, -0x1p1023});
  std::shuffle(points.begin(), points.end(), random);
  const RandomOrder order = order_of(points);
  ASSERT_NO_FATAL_FAILURE(check_order(points, order));
  EXPECT_EQ(order.points, order_of(points, Context({.threads = 3})).points);
  for (const double size : sizes) {
    SCOPED_TRACE(size);
    // The part that is of this size, in the order in which it comes.
    double length = 0;
    for (std::size_t round = 0; round < RandomOrder::rounds; ++round) {
      const Point3* before = nullptr;
      for (std::size_t i = order.round_begin[round]; i < order.round_begin[round + 1]; ++i) {
        const Point3& p = points[order.points[i]];
        if (std::fabs(p.x) > size || std::fabs(p.x) <= size * 0x1p-60) continue;
        if (before != nullptr) length += std::fabs(p.x / size - before->x / size);
        before = &p;
      }
    }
    EXPECT_LT(length, 5.0 * RandomOrder::rounds);
  }
}

// Many points of one place, and places of one cell, near and far, among the least doubles too.
TEST(HullOrder, OfEqualPointsTheFirstIsFirst) {
  for (std::uint64_t seed = 0; seed < test_rounds(40U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double unit = seed % 4 == 0 ? 0x1p-1074 : seed % 4 == 1 ? 0x1p-60 : 1;
    Points points;
    for (int i = 0; i < 3000; ++i) {
      const double x = below(random, 12) * unit;
      const double y = below(random, 12) * unit;
      points.push_back({x, y, below(random, 12) * unit});
    }
    if (seed % 3 != 0) points[5] = {0x1p30, 0, -1};
    ASSERT_NO_FATAL_FAILURE(check_order(points, order_of(points)));
    ASSERT_NO_FATAL_FAILURE(check_order(points, order_of(points, Context({.threads = 2}))));
  }
  const Points same(40000, Point3{1, 2, 3});
  ASSERT_NO_FATAL_FAILURE(check_order(same, order_of(same)));
  ASSERT_NO_FATAL_FAILURE(check_order({}, order_of({})));
}

// A walk from end to end of the curve for each point would take a minute.
TEST(ConvexHull, OfACurveAndAPointFarAway) {
  Random random(3);
  Points points;
  append_curve(points, random, tests_take_fewer_rounds ? 10000 : 100000, 0);
  const ConvexHull curve = convex_hull(points, one_thread);
  points.push_back({0, 0, 0x1p20});
  const ConvexHull hull = convex_hull(points, one_thread);
  EXPECT_EQ(hull.vertices.back(), points.size() - 1);
  EXPECT_GT(hull.vertices.size(), curve.vertices.size() / 4);
  EXPECT_TRUE(
      std::includes(curve.vertices.begin(), curve.vertices.end(), hull.vertices.begin(), hull.vertices.end() - 1));
}

}  // namespace
}  // namespace quoin
