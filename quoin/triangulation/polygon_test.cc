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

// Counterclockwise triangles, inner edges paired, outer edges those of the loops, areas adding up: a partition. All
// edges and vertices of loops are among those of triangles.
void expect_partition(std::span<const Point2> p, const Loops& loops) {
  const auto triangles = triangulate_polygon(p, loops);
  ASSERT_TRUE(triangles.has_value());
  Rational area(0);
  for (const auto& loop : loops) area += twice_area(p, loop);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  std::vector<bool> is_corner(p.size(), false);
  for (const auto& t : *triangles) {
    ASSERT_EQ(orientation(p[t[0]], p[t[1]], p[t[2]]), Sign::positive);
    area -= twice_area(p, t);
    for (std::size_t k = 0; k < 3; ++k) {
      ++balance[{t[k], t[(k + 1) % 3]}];
      is_corner[t[k]] = true;
    }
  }
  EXPECT_EQ(area, Rational(0));
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t next = loop[(i + 1) % loop.size()];
      if (loop.size() == 1) {
        EXPECT_TRUE(is_corner[loop[i]]) << "vertex " << loop[i];
      } else {
        EXPECT_TRUE((balance.contains({loop[i], next}))) << loop[i] << "-" << next;
        --balance[{loop[i], next}];
      }
    }
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
        SCOPED_TRACE(::testing::Message() << "scale " << scale << " n " << n << " repeat " << repeat);
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
    SCOPED_TRACE(::testing::Message() << "repeat " << repeat);
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

bool lies_between(const Point2& p, const Point2& a, const Point2& b) {
  return orientation(a, b, p) == Sign::zero && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

// Segments that have more than a common end in common.
bool overlap_or_cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  for (const Point2& p : {a, b}) {
    if (p != c && p != d && lies_between(p, c, d)) return true;
  }
  for (const Point2& p : {c, d}) {
    if (p != a && p != b && lies_between(p, a, b)) return true;
  }
  return orientation(a, b, c) * orientation(a, b, d) == Sign::negative &&
         orientation(c, d, a) * orientation(c, d, b) == Sign::negative;
}

// A square with a square hole, slits between any points of a grid (trees and cycles, some at the outline), and single
// vertices.
class SlitsAndVertices {
 public:
  explicit SlitsAndVertices(int size) : size_(size), number_(static_cast<std::size_t>((size + 1) * (size + 1)), 0) {
    add_square({0, 0}, size, true);
    add_square({2, 2}, 2, false);
  }

  void add_slits(std::mt19937_64& random, int attempts) {
    for (int i = 0; i < attempts; ++i) {
      const Point2 a = any(random);
      const Point2 b = any(random);
      if (a == b || std::any_of(segments_.begin(), segments_.end(), [&](const auto& s) {
            return (s.first == a && s.second == b) || (s.first == b && s.second == a) ||
                   overlap_or_cross(a, b, s.first, s.second);
          }))
        continue;
      if (is_in_hole({(a.x + b.x) / 2, (a.y + b.y) / 2})) continue;
      segments_.push_back({a, b});
      loops.push_back({vertex(a), vertex(b)});
    }
  }

  void add_vertices(std::mt19937_64& random, int attempts) {
    for (int i = 0; i < attempts; ++i) {
      const Point2 p = any(random);
      if (is_in_hole(p) || std::any_of(segments_.begin(), segments_.end(),
                                       [&](const auto& s) { return lies_between(p, s.first, s.second); }))
        continue;
      loops.push_back({vertex(p)});
    }
  }

  std::vector<Point2> points;
  Loops loops;

 private:
  void add_square(const Point2& p, double side, bool is_outer) {
    const Point2 corners[] = {p, {p.x + side, p.y}, {p.x + side, p.y + side}, {p.x, p.y + side}};
    loops.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      segments_.push_back({corners[i], corners[(i + 1) % 4]});
      loops.back().push_back(vertex(corners[i]));
    }
    if (!is_outer) std::reverse(loops.back().begin(), loops.back().end());
  }

  std::uint32_t vertex(const Point2& p) {
    std::uint32_t& number = number_[static_cast<std::size_t>(p.x * (size_ + 1) + p.y)];
    if (number == 0) {
      points.push_back(p);
      number = static_cast<std::uint32_t>(points.size());
    }
    return number - 1;
  }

  Point2 any(std::mt19937_64& random) const {
    std::uniform_int_distribution<int> coordinate(0, size_);
    const double x = coordinate(random);
    return {x, static_cast<double>(coordinate(random))};
  }

  static bool is_in_hole(const Point2& p) { return p.x > 2 && p.x < 4 && p.y > 2 && p.y < 4; }

  int size_;
  std::vector<std::uint32_t> number_;  // one more than the index of the point, or 0
  std::vector<std::pair<Point2, Point2>> segments_;
};

TEST(Polygon, SlitsAndSingleVerticesAreKept) {
  for (const int size : {5, 6, 9, 14}) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      SCOPED_TRACE(::testing::Message() << "size " << size << " seed " << seed);
      std::mt19937_64 random(seed);
      SlitsAndVertices polygon(size);
      polygon.add_slits(random, static_cast<int>(seed));
      polygon.add_vertices(random, static_cast<int>(random() % 60));
      std::shuffle(polygon.loops.begin(), polygon.loops.end(), random);
      expect_partition(polygon.points, polygon.loops);
    }
  }
}

TEST(Polygon, SlitsThatALoopPasses) {
  const std::vector<Point2> p{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {2, 2}, {3, 1}, {3, 3}};
  expect_partition(p, {{0, 4, 5, 6, 5, 7, 5, 4, 0, 1, 2, 3}});  // a tree that hangs from a corner
  expect_partition(p, {{0, 1, 2, 3}, {4, 5, 6, 5, 7, 5}});      // one that hangs from nothing
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
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {}})) << "an empty loop";
  EXPECT_TRUE(refused({{5}})) << "a vertex in nothing";
  EXPECT_TRUE(refused({{5, 2}})) << "a slit in nothing";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {6}})) << "a vertex outside";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {4}})) << "a vertex inside an edge";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {5, 6}})) << "a slit that leaves";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {1, 6}})) << "a slit outside";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {5, 2}, {2, 5}})) << "a slit twice";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {0, 2}, {1, 3}})) << "slits that cross";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {0, 2}, {5}})) << "a vertex on a slit";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {0, 1}})) << "a slit along the outline";
  EXPECT_TRUE(refused({{0, 1, 2, 3}, {5, 5}})) << "a slit without length";
}

}  // namespace
}  // namespace quoin
