// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/region_insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <numeric>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/insertion_rounds.h"
#include "quoin/triangulation/regular_signs.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

bool is_same(const CellArray& a, const CellArray& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.vertices == y.vertices && x.neighbours == y.neighbours;
  });
}

/// What is made of a cloud that spans a plane or space, the apex of a plane left in it.
struct Result {
  CellArray cells;
  std::vector<std::uint32_t> hidden;

  Result canonical() const {
    Result sorted = *this;
    sort_cells(sorted.cells, 3);
    std::sort(sorted.hidden.begin(), sorted.hidden.end());
    return sorted;
  }
};

/// Points in the order in which they are inserted, with weights that some tests give them.
class Input {
 public:
  Input(const std::vector<Point3>& points, Random* weighing) : points_(points, Scaling::allowed, Context()) {
    basis_ = affine_basis(points_.all(), Context());
    count_ = points_.points.size();
    if (weighing != nullptr) {
      for (std::size_t i = 0; i < count_; ++i) weights_.push_back(testing::small_integer(*weighing, 4) / 64);
    }
    if (dimension() != 2) return;
    points_.points.push_back(point_off_plane(points_.all(), basis_));
    if (weighing != nullptr) weights_.push_back(0);
  }
  std::size_t dimension() const { return basis_.vertices.size() - 1; }

  Result triangulated(unsigned threads, const InsertionSplit& split) const {
    const Context context({.threads = threads});
    if (weights_.empty()) return result_of(DelaunaySigns(points_.all(), dimension() == 2), context, split);
    return result_of(RegularSigns(points_.all(), weights_, dimension() == 2), context, split);
  }

  template <class Signs>
  Result result_of(const Signs& signs, const Context& context, const InsertionSplit& split) const {
    const auto& v = basis_.vertices;
    const auto last = dimension() == 2 ? static_cast<std::uint32_t>(count_) : v[3];
    Result result;
    result.cells = insert_in_rounds(
        signs, count_, {v[0], v[1], v[2], last}, context, [&](std::uint32_t h) { result.hidden.push_back(h); }, split);
    return result;
  }

  DelaunaySigns plain_signs() const { return {points_.all(), dimension() == 2}; }

 private:
  VertexPoints points_;
  AffineBasis basis_;
  std::vector<double> weights_;
  std::size_t count_ = 0;
};

/// All families, small, and some of `count` points.
std::vector<Cloud> small_and_larger_clouds(Random& random, std::size_t count) {
  std::vector<Cloud> all = testing::clouds(random, count / 10);
  const auto size = static_cast<int>(std::cbrt(static_cast<double>(count)));
  all.push_back({"larger lattice", testing::lattice(size, size + 1, size - 1)});
  all.push_back({"larger planar lattice", testing::lattice(1, size * 3, size * 2)});
  Cloud jittered{"jittered lattice", testing::lattice(size - 1, size, size)};
  for (Point3& p : jittered.points) p.y += testing::unit(random) / 1024;
  all.push_back(jittered);
  all.push_back({"larger sphere", testing::near_sphere(random, count)});
  Cloud clusters{"clusters", testing::random_points(random, count, testing::unit)};
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 8 == 0) continue;
    const Point3& centre = clusters.points[i % 5 * 8];
    Point3& p = clusters.points[i];
    p = {centre.x + p.x / 4096, centre.y + p.y / 4096, centre.z + p.z / 4096};
  }
  all.push_back(clusters);
  Cloud thin{"some ulps off a plane", testing::random_points(random, count / 4, testing::unit)};
  for (Point3& p : thin.points) p.z = 1 + std::ldexp(testing::small_integer(random, 3), -52);
  all.push_back(thin);
  Cloud twice{"uniform, twice", testing::random_points(random, count, testing::unit)};
  twice.points.insert(twice.points.end(), twice.points.begin(), twice.points.begin() + static_cast<long>(count / 2));
  all.push_back(twice);
  return all;
}

void expect_same_for_all_threads(const std::vector<Cloud>& clouds, Random* weighing) {
  constexpr InsertionSplit alone{.regions = 1};
  for (const Cloud& cloud : clouds) {
    const Input input(cloud.points, weighing);
    if (input.dimension() < 2) continue;
    SCOPED_TRACE(cloud.name);
    const Result expected = input.triangulated(1, alone).canonical();
    for (const std::size_t regions : {2U, 7U}) {
      if (tests_take_fewer_rounds && regions == 2) continue;
      const InsertionSplit split{.regions = regions, .least_points = 8};
      const Result first = input.triangulated(1, split);
      const Result sorted = first.canonical();
      ASSERT_TRUE(is_same(sorted.cells, expected.cells)) << regions << " regions";
      ASSERT_EQ(std::set(sorted.hidden.begin(), sorted.hidden.end()),
                std::set(expected.hidden.begin(), expected.hidden.end()));
      for (const unsigned threads : {2U, 3U, 4U, 7U}) {
        if (threads > regions || (tests_take_fewer_rounds && threads != 3)) continue;
        const Result other = input.triangulated(threads, split);
        ASSERT_TRUE(is_same(other.cells, first.cells)) << regions << " regions, " << threads << " threads";
        ASSERT_EQ(other.hidden, first.hidden);
      }
    }
  }
}

TEST(DelaunayThreads, GiveTheCellsOfOneThread) {
  Random random(71);
  expect_same_for_all_threads(small_and_larger_clouds(random, tests_take_fewer_rounds ? 250 : 600), nullptr);
}

TEST(DelaunayThreads, GiveRegularTriangulationsOfOneThread) {
  Random random(72);
  Random weights(73);
  expect_same_for_all_threads(small_and_larger_clouds(random, tests_take_fewer_rounds ? 200 : 300), &weights);
}

/// As many as are divided in fact.
TEST(DelaunayThreads, GiveTheSameTriangulationOfManyPoints) {
  if (tests_take_fewer_rounds) GTEST_SKIP() << "the tests before divide fewer points";
  constexpr std::size_t count = 40000;
  Random random(74);
  for (Cloud cloud : {Cloud{"uniform", testing::random_points(random, count, testing::unit)},
                      Cloud{"sphere", testing::near_sphere(random, count)},
                      Cloud{"plane", testing::random_points(random, count, testing::unit)}}) {
    SCOPED_TRACE(cloud.name);
    if (cloud.name == "plane") {
      for (Point3& p : cloud.points) p.z = 0;
    }
    const Delaunay3 one(cloud.points, Context({.threads = 1}));
    EXPECT_EQ(one.dimension(), cloud.name == "plane" ? 2 : 3);
    const InsertionSplit split = InsertionSplit::of(one.vertex_count());
    EXPECT_LE(split.regions * split.least_points, count - count / 8);
    const auto expect_equal = [](const Delaunay3& a, const Delaunay3& b) {
      EXPECT_TRUE(std::equal(
          a.cells().begin(), a.cells().end(), b.cells().begin(), b.cells().end(),
          [](const auto& c, const auto& d) { return c.vertices == d.vertices && c.neighbours == d.neighbours; }));
    };
    for (const unsigned threads : {2U, 4U}) expect_equal(one, Delaunay3(cloud.points, Context({.threads = threads})));
    // One thread does not divide points whose cells are sorted in the end.
    const DelaunayOptions sorted{.is_canonical = true};
    expect_equal(Delaunay3(cloud.points, Context({.threads = 1}), sorted),
                 Delaunay3(cloud.points, Context({.threads = 2}), sorted));
  }
}

TEST(DelaunayThreads, AreCancelledAtAnyPoll) {
  Random random(75);
  const Input input(testing::random_points(random, 1500, testing::unit), nullptr);
  constexpr InsertionSplit split{.regions = 4, .least_points = 32};
  const DelaunaySigns signs = input.plain_signs();
  const Context counting({.threads = 4, .most_polls = 1'000'000});
  input.result_of(signs, counting, split);
  const std::uint64_t polls = counting.polls();
  ASSERT_GT(polls, 10U);
  for (std::uint64_t most = 0; most + 1 < polls; most += tests_take_fewer_rounds ? 5 : 1) {
    for (const unsigned threads : {1U, 2U, 4U}) {
      const Context context({.threads = threads, .most_polls = most});
      EXPECT_THROW(input.result_of(signs, context, split), Cancelled) << most << " of " << polls;
    }
  }
}

/// Progress grows, up to what is late, and is reported by one thread at a time.
TEST(DelaunayThreads, ReportProgressOneAtATime) {
  Random random(76);
  const Input input(testing::random_points(random, 4000, testing::unit), nullptr);
  std::atomic<int> inside{0};
  bool has_met = false;
  double last = 0;
  const auto report = [&](std::string_view /*stage*/, double done) {
    has_met = has_met || inside.fetch_add(1) != 0;
    last = done;
    inside.fetch_sub(1);
  };
  const DelaunaySigns signs = input.plain_signs();
  input.result_of(signs, Context({.threads = 4, .progress = report}), {.regions = 4, .least_points = 32});
  EXPECT_FALSE(has_met);
  EXPECT_GT(last, 0.5);
  EXPECT_LE(last, 1.0);
}

/// The predicates of other points, of which one call fails, on whichever thread it comes.
class FailingSigns {
 public:
  static constexpr bool may_hide = false;

  FailingSigns(const DelaunaySigns& signs, std::int64_t calls) : signs_(signs), left_(calls) {}

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return signs_.orientation(a, b, c, d);
  }
  bool in_conflict(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q) const {
    if (left_.fetch_sub(1) == 0) throw std::bad_alloc();
    return signs_.in_conflict(a, b, c, d, q);
  }
  bool has_failed() const { return left_ < 0; }

 private:
  const DelaunaySigns& signs_;
  mutable std::atomic<std::int64_t> left_;
};

TEST(DelaunayThreads, PassOnWhatIsThrown) {
  Random random(77);
  const Input input(testing::random_points(random, 800, testing::unit), nullptr);
  constexpr InsertionSplit split{.regions = 4, .least_points = 32};
  const DelaunaySigns signs = input.plain_signs();
  int failures = 0;
  for (std::int64_t calls = 0;; calls = calls * 3 / 2 + 100) {
    const FailingSigns failing(signs, calls);
    const Context context({.threads = 1 + static_cast<unsigned>(calls % 4)});
    try {
      input.result_of(failing, context, split);
    } catch (const std::bad_alloc&) {
      ++failures;
      continue;
    }
    EXPECT_FALSE(failing.has_failed());
    break;
  }
  EXPECT_GT(failures, 5);
}

TEST(RankRegion, HoldsWhatFollowsItsBeginning) {
  for (const std::uint32_t begin : {0U, 3U, 9U}) {
    for (std::uint32_t length = 1; length <= 10; ++length) {
      const RankRegion region{begin, length, 10};
      std::set<std::uint32_t> of_runs;
      for (const auto& [from, to] : region.runs()) {
        for (std::uint32_t v = from; v < to; ++v) EXPECT_TRUE(of_runs.insert(v).second);
      }
      EXPECT_EQ(of_runs.size(), length);
      for (std::uint32_t v = 0; v < 10; ++v) {
        EXPECT_EQ(region.contains(v), (v + 10 - begin) % 10 < length);
        EXPECT_EQ(region.contains(v), of_runs.count(v) == 1);
      }
      EXPECT_FALSE(region.contains(vertex_at_infinity));
    }
  }
  const RankRegion region{2, 3, 10};
  EXPECT_TRUE(region.owns({2, 3, 4, 9}));
  EXPECT_FALSE(region.owns({2, 3, 9, vertex_at_infinity}));
  EXPECT_TRUE(region.owns_facet(9, 4, 3));
  EXPECT_FALSE(region.owns_facet(9, 4, vertex_at_infinity));
}

TEST(CellPool, GivesEachPlaceOnce) {
  CellPool pool;
  pool.add_run(10, 20);
  pool.add_run(30, 33);
  pool.add_run(5, 5);
  pool.add(3);
  pool.add(2);
  EXPECT_EQ(pool.size(), 15U);
  EXPECT_EQ(pool.places().size(), 15U);
  std::vector<CellPool> parts = pool.divided(2);
  EXPECT_EQ(pool.size(), 0U);
  std::set<std::uint32_t> taken;
  while (parts[0].size() > 2) EXPECT_TRUE(taken.insert(parts[0].take()).second);
  pool.take_all_of(parts[0]);
  pool.take_all_of(parts[1]);
  while (pool.size() > 0) EXPECT_TRUE(taken.insert(pool.take()).second);
  EXPECT_EQ(taken.size(), 15U);
}

TEST(StarNumbers, NumbersInOrderOfArrival) {
  StarNumbers numbers;
  for (std::uint32_t step : {1U, 256U, 0x9E3779B1U}) {
    for (int round = 0; round < 2; ++round) {
      for (std::uint32_t i = 0; i < StarNumbers::most; ++i) EXPECT_EQ(numbers.number(i * step), i);
    }
    numbers.clear();
  }
}

}  // namespace
}  // namespace quoin
