// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/region_insertion2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/check2.h"
#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/insertion_rounds2.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/spatial_order2.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::fraction;
using testing::PointSetFamily;
using testing::Random;

using Points = std::vector<Point2>;

bool is_same(std::span<const TriangleLinks2> a, std::span<const TriangleLinks2> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& s, const auto& t) { return s.corner == t.corner && s.across == t.across; });
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Distinct points in the order in which they are inserted, with weights that some tests give them.
class Input {
 public:
  Input(const Points& points, Random* weighing) : order_(spatial_order(points, Context())) {
    count_ = order_.points.size();
    const auto turn = [&](std::uint32_t i) {
      return orientation(order_.points[0], order_.points[1], order_.points[i]);
    };
    start_ = detail::first_triangle(count_, turn, Context());
    order_.points.push_back({nan, nan});
    if (weighing == nullptr) return;
    for (const Point2& p : order_.points) weighted_.push_back({p, testing::small_integer(*weighing, 4) / 64});
    weighted_.back().weight = nan;
  }
  bool spans_plane() const { return start_.has_value(); }

  TriangleArray2 triangulated(unsigned threads, const InsertionSplit& split) const {
    const Context context({.threads = threads});
    if (weighted_.empty()) return triangles_of(plain_predicates(), context, split);
    return triangles_of(RegularPredicates2(weighted_), context, split);
  }

  template <class Predicates>
  TriangleArray2 triangles_of(const Predicates& predicates, const Context& context, const InsertionSplit& split) const {
    return detail::insert_in_rounds(predicates, count_, *start_, split, context);
  }

  DelaunayPredicates2 plain_predicates() const { return {order_.points, Context({.threads = 1})}; }

  /// By corners that are all among these, so hidden vertices do not matter.
  TriangleArray2 canonical(const TriangleArray2& triangles) const {
    Triangulation2 links(triangles, count_);
    links.renumber();
    return {links.links().begin(), links.links().end()};
  }

 private:
  SpatialOrder2 order_;
  std::size_t count_ = 0;
  std::optional<std::array<std::uint32_t, 3>> start_;
  std::vector<WeightedPoint2> weighted_;
};

Points grid(std::size_t columns, std::size_t rows, double move, Random& random) {
  Points points;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      points.push_back({static_cast<double>(x) + move * fraction(random), static_cast<double>(y)});
    }
  }
  return points;
}

/// Most on a line, which leaves the hull flat on one side, and the curve's runs long.
Points mostly_on_a_line(Random& random, std::size_t count) {
  return testing::repeat(count, [&] {
    const double x = std::floor(fraction(random) * 4096);
    return Point2{x, random() % 16 == 0 ? std::floor(fraction(random) * 64) : 0.0};
  });
}

struct Family {
  std::string name;
  Points points;
};

std::vector<Family> families(Random& random, std::size_t count) {
  std::vector<Family> all;
  for (const PointSetFamily& family : testing::point_sets()) all.push_back({family.name, family.make(random, count)});
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  all.push_back({"lattice", grid(side, side + 3, 0, random)});
  all.push_back({"long lattice", grid(4 * side, side / 4 + 1, 0, random)});
  all.push_back({"jittered lattice", grid(side, side, 1e-3, random)});
  all.push_back({"mostly on a line", mostly_on_a_line(random, count)});
  Points twice = testing::point_sets()[0].make(random, count);
  twice.insert(twice.end(), twice.begin(), twice.begin() + static_cast<long>(count / 2));
  all.push_back({"uniform, twice", twice});
  return all;
}

void expect_same_for_all_threads(const std::vector<Family>& families, Random* weighing) {
  for (const Family& family : families) {
    const Input input(family.points, weighing);
    if (!input.spans_plane()) continue;
    SCOPED_TRACE(family.name);
    const TriangleArray2 expected = input.canonical(input.triangulated(1, InsertionSplit::none()));
    for (const std::size_t regions : {2U, 3U, 8U}) {
      if (tests_take_fewer_rounds && regions == 2) continue;
      const InsertionSplit split{.regions = regions, .least_points = 8};
      const TriangleArray2 first = input.triangulated(1, split);
      ASSERT_TRUE(is_same(input.canonical(first), expected)) << regions << " regions";
      for (const unsigned threads : {2U, 3U, 4U}) {
        if (tests_take_fewer_rounds && threads != 3) continue;
        ASSERT_TRUE(is_same(input.triangulated(threads, split), first))
            << regions << " regions, " << threads << " threads";
      }
    }
  }
}

TEST(PlaneThreads, GiveTheTrianglesOfOneThread) {
  Random random(81);
  expect_same_for_all_threads(families(random, tests_take_fewer_rounds ? 300 : 600), nullptr);
}

TEST(PlaneThreads, GiveRegularTriangulationsOfOneThread) {
  Random random(82);
  Random weights(83);
  expect_same_for_all_threads(families(random, tests_take_fewer_rounds ? 80 : 150), &weights);
}

/// As many as are divided in fact.
TEST(PlaneThreads, GiveTheSameTriangulationOfManyPoints) {
  if (tests_take_fewer_rounds) GTEST_SKIP() << "the tests before divide fewer points";
  constexpr std::size_t count = 40000;
  const InsertionSplit split = InsertionSplit::in_plane(count);
  EXPECT_LE(split.regions * split.least_points, count / 2);
  Random random(84);
  const auto many = [&](std::size_t i) { return testing::point_sets()[i].make(random, count); };
  for (const Family& family :
       {Family{"uniform", many(0)}, Family{"lattice", grid(200, 200, 0, random)}, Family{"near a circle", many(4)},
        Family{"mostly on a line", mostly_on_a_line(random, count)}}) {
    SCOPED_TRACE(family.name);
    const Delaunay2 one(family.points, {}, Context({.threads = 1}));
    ASSERT_EQ(defect(one, family.points), "");
    for (const unsigned threads : {2U, 4U}) {
      const Delaunay2 other(family.points, {}, Context({.threads = threads}));
      EXPECT_TRUE(is_same(one.links().links(), other.links().links())) << threads;
      for (std::size_t v = 0; v < one.vertex_count(); ++v) {
        ASSERT_EQ(one.point(Vertex2(v)), other.point(Vertex2(v)));
        ASSERT_EQ(one.links().edge_from(Vertex2(v)), other.links().edge_from(Vertex2(v)));
      }
    }
  }
}

bool is_same(const SpatialOrder2& a, const SpatialOrder2& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end()) &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end()) &&
         std::equal(a.input_begin.begin(), a.input_begin.end(), b.input_begin.begin(), b.input_begin.end());
}

/// More than one chunk of them, and more than one in a cell.
TEST(PlaneThreads, SortPointsAsOneDoes) {
  constexpr std::size_t count = tests_take_fewer_rounds ? 70000 : 150000;
  Random random(85);
  std::vector<Family> many{{"uniform", testing::point_sets()[0].make(random, count)}};
  Points cluster = many[0].points;
  for (std::size_t i = 4; i < count; ++i) cluster[i] = {0.5 + 0x1p-30 * cluster[i].x, 0.5 + 0x1p-40 * cluster[i].y};
  many.push_back({"one cell holds nearly all", cluster});
  Points equal(count, Point2{0.25, 0.75});
  equal[7] = {0, 0};
  equal[8] = {1, 1};
  many.push_back({"nearly all are equal", equal});
  many.push_back({"each many times", testing::repeat(count, [&] {
                    return Point2{std::floor(30 * fraction(random)), std::floor(30 * fraction(random))};
                  })});
  for (const Family& family : many) {
    SCOPED_TRACE(family.name);
    const SpatialOrder2 one = spatial_order(family.points, Context({.threads = 1}));
    for (const unsigned threads : {2U, 3U, 4U}) {
      if (tests_take_fewer_rounds && threads != 3) continue;
      ASSERT_TRUE(is_same(spatial_order(family.points, Context({.threads = threads})), one)) << threads;
    }
    std::set<std::pair<double, double>> seen;
    for (std::size_t v = 0; v < one.points.size(); ++v) {
      ASSERT_TRUE(tests_take_fewer_rounds || seen.emplace(one.points[v].x, one.points[v].y).second);
      const auto inputs = one.inputs_of(v);
      ASSERT_TRUE(std::is_sorted(inputs.begin(), inputs.end()));
      for (const std::uint32_t i : inputs) ASSERT_EQ(family.points[i], one.points[v]);
    }
  }
}

TEST(PlaneThreads, AreCancelledAtAnyPoll) {
  Random random(86);
  const Input input(testing::point_sets()[0].make(random, 3000), nullptr);
  constexpr InsertionSplit split{.regions = 4, .least_points = 32};
  const DelaunayPredicates2 predicates = input.plain_predicates();
  const Context counting({.threads = 4, .most_polls = 1'000'000});
  input.triangles_of(predicates, counting, split);
  const std::uint64_t polls = counting.polls();
  ASSERT_GT(polls, 30U);
  for (std::uint64_t most = 0; most + 1 < polls; most += tests_take_fewer_rounds ? 17 : 3) {
    for (const unsigned threads : {1U, 2U, 4U}) {
      const Context context({.threads = threads, .most_polls = most});
      EXPECT_THROW(input.triangles_of(predicates, context, split), Cancelled) << most << " of " << polls;
    }
  }
}

/// Progress grows, up to what is late, and is reported by one thread at a time.
TEST(PlaneThreads, ReportProgressOneAtATime) {
  Random random(87);
  const Input input(testing::point_sets()[0].make(random, 30000), nullptr);
  std::atomic<int> inside{0};
  bool has_met = false;
  double last = 0;
  const auto report = [&](std::string_view /*stage*/, double done) {
    has_met = has_met || inside.fetch_add(1) != 0;
    last = done;
    inside.fetch_sub(1);
  };
  const Context context({.threads = 4, .progress = report});
  input.triangles_of(input.plain_predicates(), context, {.regions = 4, .least_points = 32});
  EXPECT_FALSE(has_met);
  EXPECT_GT(last, 0.5);
  EXPECT_LE(last, 1.0);
}

/// The predicates of other points, of which one call fails, on whichever thread it comes.
class FailingPredicates {
 public:
  static constexpr bool may_hide = false;
  using Query = Point2;

  FailingPredicates(const DelaunayPredicates2& predicates, std::int64_t calls)
      : predicates_(predicates), left_(calls) {}

  const Point2& point(std::uint32_t v) const { return predicates_.point(v); }
  Sign turn(std::uint32_t a, std::uint32_t b, const Point2& p) const { return predicates_.turn(a, b, p); }
  bool in_conflict(const TriangleLinks2& t, const Point2& p) const {
    if (left_.fetch_sub(1) == 0) throw std::bad_alloc();
    return predicates_.in_conflict(t, p);
  }
  bool has_failed() const { return left_ < 0; }

 private:
  const DelaunayPredicates2& predicates_;
  mutable std::atomic<std::int64_t> left_;
};

TEST(PlaneThreads, PassOnWhatIsThrown) {
  Random random(88);
  const Input input(testing::point_sets()[0].make(random, 1500), nullptr);
  constexpr InsertionSplit split{.regions = 4, .least_points = 32};
  const DelaunayPredicates2 predicates = input.plain_predicates();
  int failures = 0;
  for (std::int64_t calls = 0;; calls = calls * 3 / 2 + 100) {
    const FailingPredicates failing(predicates, calls);
    const Context context({.threads = 1 + static_cast<unsigned>(calls % 4)});
    try {
      input.triangles_of(failing, context, split);
    } catch (const std::bad_alloc&) {
      ++failures;
      continue;
    }
    EXPECT_FALSE(failing.has_failed());
    break;
  }
  EXPECT_GT(failures, 5);
}

TEST(PlaneRegion, AllowsItsVerticesAndTheInfiniteOne) {
  for (const std::uint32_t begin : {0U, 3U, 9U}) {
    for (std::uint32_t length = 1; length <= 10; ++length) {
      const detail::PlaneRegion region({begin, length, 10}, 10);
      for (std::uint32_t v = 0; v < 10; ++v) {
        EXPECT_EQ(region.allows(v), (v + 10 - begin) % 10 < length);
        EXPECT_EQ(region.owns({begin, v, 10}), region.allows(v));
      }
      EXPECT_TRUE(region.allows(10));
    }
  }
}

TEST(InsertionOrder2, VisitsEachVertexInItsPlace) {
  constexpr std::uint32_t count = 5000;
  constexpr std::array<std::uint32_t, 3> start{0, 1, 7};
  const detail::InsertionOrder2 order(count, start, Context());
  std::vector<std::uint32_t> places(count, 0);
  std::uint32_t next = 0;
  for (unsigned round = insertion_rounds; round-- > 0;) {
    std::size_t seen = 0;
    for (const auto& [begin, end] : {std::pair(0U, 1234U), std::pair(1234U, count + 5)}) {
      order.visit(round, begin, end, [&](std::uint32_t v, std::uint32_t place) {
        EXPECT_EQ(insertion_round(v), round);
        EXPECT_EQ(place, next++);
        ++places[v];
        ++seen;
      });
    }
    EXPECT_EQ(seen, order.size(round));
  }
  for (std::uint32_t v = 0; v < count; ++v) EXPECT_EQ(places[v], v == 0 || v == 1 || v == 7 ? 0U : 1U);
}

}  // namespace
}  // namespace quoin
