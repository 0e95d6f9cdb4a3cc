// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "quoin/kernel/predicates2.h"
#include "quoin/number/rational.h"

namespace quoin {
namespace {

using Loops = std::vector<std::vector<std::uint32_t>>;

Rational twice_area(std::span<const Point2> p, std::span<const std::uint32_t> loop) {
  Rational sum(0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2& a = p[loop[i]];
    const Point2& b = p[loop[(i + 1) % loop.size()]];
    sum += Rational(a.x) * Rational(b.y) - Rational(a.y) * Rational(b.x);
  }
  return sum;
}

// Counterclockwise triangles, inner edges paired, outer edges those of the loops, areas adding up: a partition.
void expect_partition(std::span<const Point2> p, const Loops& loops) {
  const auto triangles = triangulate_polygon(p, loops);
  ASSERT_TRUE(triangles.has_value());
  Rational area(0);
  for (const auto& loop : loops) area += twice_area(p, loop);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : *triangles) {
    ASSERT_EQ(orientation(p[t[0]], p[t[1]], p[t[2]]), Sign::positive);
    area -= twice_area(p, t);
    for (std::size_t k = 0; k < 3; ++k) ++balance[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_EQ(area, Rational(0));
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) --balance[{loop[i], loop[(i + 1) % loop.size()]}];
  }
  for (const auto& [edge, count] : balance) {
    const auto twin = balance.find({edge.second, edge.first});
    EXPECT_EQ(count, twin == balance.end() ? 0 : twin->second) << edge.first << "-" << edge.second;
  }
}

Loops one_loop(std::size_t n) {
  Loops loops(1);
  for (std::uint32_t i = 0; i < n; ++i) loops[0].push_back(i);
  return loops;
}

std::vector<Point2> star(std::size_t n, std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  std::vector<Point2> p;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double r = radius(random) * scale;
    p.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return p;
}

TEST(Polygon, StarsOfAnySizeAndScaleArePartitioned) {
  std::mt19937_64 random(11);
  for (const double scale : {1.0, 1e-300, 1e150, 1e300}) {
    for (const std::size_t n : {3U, 4U, 5U, 6U, 9U, 20U, 101U}) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        SCOPED_TRACE(testing::Message() << "scale " << scale << " n " << n << " repeat " << repeat);
        expect_partition(star(n, random, scale), one_loop(n));
      }
    }
  }
}

TEST(Polygon, StartAndNumberingDoNotMatter) {
  std::mt19937_64 random(5);
  const auto p = star(17, random, 1);
  Loops loops = one_loop(17);
  for (int i = 0; i < 17; ++i) {
    std::rotate(loops[0].begin(), loops[0].begin() + 1, loops[0].end());
    expect_partition(p, loops);
  }
}

TEST(Polygon, IntegerStarsWithManyCollinearVertices) {
  std::mt19937_64 random(7);
  for (int repeat = 0; repeat < 300; ++repeat) {
    // A comb on a small grid: a closed x-monotone outline with many equal coordinates.
    std::uniform_int_distribution<int> height(1, 3);
    std::vector<Point2> p{{0, 0}};
    const int teeth = 12;
    for (int i = 1; i <= teeth; ++i) p.push_back({static_cast<double>(i), -static_cast<double>(height(random) - 1)});
    for (int i = teeth; i >= 0; --i) p.push_back({static_cast<double>(i), static_cast<double>(height(random))});
    SCOPED_TRACE(testing::Message() << "repeat " << repeat);
    expect_partition(p, one_loop(p.size()));
  }
}

TEST(Polygon, GridOfSquareHolesSomeTouchingEachOtherAndTheOutline) {
  for (const bool touching : {false, true}) {
    std::vector<Point2> p{{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    Loops loops = one_loop(4);
    std::map<std::pair<int, int>, std::uint32_t> number;
    const auto vertex = [&](int x, int y) {
      const auto [entry, is_new] = number.try_emplace({x, y}, static_cast<std::uint32_t>(p.size()));
      if (is_new) p.push_back({static_cast<double>(x), static_cast<double>(y)});
      return entry->second;
    };
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (touching && (i + j) % 2 != 0) continue;
        const int step = touching ? 3 : 4;
        const int x = 2 + step * i;
        const int y = 2 + step * j;
        const int size = touching ? 3 : 2;
        loops.push_back({vertex(x, y), vertex(x, y + size), vertex(x + size, y + size), vertex(x + size, y)});
      }
    }
    expect_partition(p, loops);
  }
}

TEST(Polygon, SubdividedSidesKeepTheirVertices) {
  std::vector<Point2> p;
  for (int i = 0; i < 10; ++i) p.push_back({static_cast<double>(i), 0});
  for (int i = 0; i < 10; ++i) p.push_back({10, static_cast<double>(i)});
  for (int i = 10; i > 0; --i) p.push_back({static_cast<double>(i), 10});
  for (int i = 10; i > 0; --i) p.push_back({0, static_cast<double>(i)});
  expect_partition(p, one_loop(p.size()));
}

TEST(Polygon, TouchingOuterLoops) {
  const std::vector<Point2> p{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  expect_partition(p, {{0, 1, 2, 3}, {2, 4, 5, 6}});
}

TEST(Polygon, WhatIsNoPolygonIsRefused) {
  const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {2, 0.5}, {0, 0}};
  const auto refused = [&](const Loops& loops) { return !triangulate_polygon(square, loops).has_value(); };
  EXPECT_TRUE(refused({{3, 2, 1, 0}})) << "clockwise";
  EXPECT_TRUE(refused({{0, 2, 1, 3}})) << "bow tie";
  EXPECT_TRUE(refused({{0, 1, 2, 5, 4}})) << "vertex inside an edge";
  EXPECT_TRUE(refused({{0, 1, 2, 3, 7}})) << "two indices on one spot";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {4, 6, 5}})) << "loops cross";
  EXPECT_TRUE(refused({{0, 1}})) << "two corners";
  EXPECT_TRUE(refused({{0, 1, 4}})) << "no area";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {0, 1, 2, 3}})) << "the same twice";
}

}  // namespace
}  // namespace quoin
