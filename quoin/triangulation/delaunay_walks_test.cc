// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_walks.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/delaunay_location.h"
#include "quoin/triangulation/flat_location.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Random;

const Context& alone() {
  static const Context context({.threads = 1});
  return context;
}

double part(Random& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}

constexpr int length = 8000;

/// A long thin box of points, or, of the same number, a strip of the plane z = 0, so that walks from end to end cross
/// thousands of cells.
std::vector<Point3> long_points(Random& random, bool is_flat) {
  std::vector<Point3> points;
  for (int i = 0; i < length; ++i) {
    for (int k = 0; k < 4; ++k) {
      points.push_back({i + 0.5 * part(random), part(random), is_flat ? 0 : part(random)});
    }
  }
  return points;
}

std::optional<DelaunayLocation> walk_in_space(const Delaunay3& t, const Point3& p, std::size_t steps,
                                              std::uint32_t start) {
  return walk_to(p, steps, t.cells(), start, [&t](std::uint32_t v) { return t.point(v); });
}

bool is_same(const DelaunayLocation& a, const DelaunayLocation& b) {
  return a.kind == b.kind && a.cell == b.cell && a.slots == b.slots;
}

TEST(DelaunayWalks, EndAtTheLimitOfSteps) {
  Random random(1);
  const Delaunay3 t(long_points(random, false), alone());
  for (int k = 0; k < 20; ++k) {
    const Point3 p{length * part(random), part(random), part(random)};
    const auto start = static_cast<std::uint32_t>(random() % t.cells().size());
    const std::optional<DelaunayLocation> found = walk_in_space(t, p, any_steps, start);
    ASSERT_TRUE(found);
    // The least number of steps that is enough.
    std::size_t low = 0;
    std::size_t high = t.cells().size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (const auto some = walk_in_space(t, p, middle, start)) {
        ASSERT_TRUE(is_same(*some, *found));
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    ASSERT_LT(low, t.cells().size());
    std::size_t tests = 0;  // four at most in each cell but the last
    ASSERT_TRUE(walk_at_most(low, t.cells(), 3, start, [&](std::uint32_t cell, unsigned slot) {
      ++tests;
      const auto& v = t.cells()[cell].vertices;
      const auto& [a, b, c] = facet_slots[slot];
      return orientation(t.point(v[a]), t.point(v[b]), t.point(v[c]), p);
    }));
    EXPECT_LE(low, tests);
    EXPECT_LE(tests, 4 * (low + 1));
    if (found->kind == DelaunayLocation::Kind::cell) {
      EXPECT_TRUE(walk_in_space(t, p, 0, found->cell));
    }
  }
}

/// From the other end, where the limit is met, and from everywhere.
TEST(DelaunayWalks, HintsDoNotChangeWhatIsFound) {
  for (const bool is_flat : {false, true}) {
    Random random(is_flat ? 2 : 3);
    const Delaunay3 t(long_points(random, is_flat), alone());
    ASSERT_EQ(t.dimension(), is_flat ? 2U : 3U);
    const DelaunayLocator locator(t);
    const std::uint32_t first = locator.locate({0.1, 0.5, is_flat ? 0 : 0.5}).cell;
    if (!is_flat) {
      EXPECT_FALSE(walk_in_space(t, {length - 1, 0.5, 0.5}, most_steps_from_hint, first));
    } else {
      EXPECT_FALSE(FlatLocator(t).walk_in_plane({length - 1, 0.5, 0}, first, most_steps_from_hint));
    }
    for (int k = 0; k < 200; ++k) {
      const Point3 p{(length + 10) * part(random), part(random), is_flat ? 0 : part(random)};
      const DelaunayLocation expected = locator.locate(p);
      const DelaunayLocation from_end = locator.locate(p, first);
      const DelaunayLocation found = locator.locate(p, static_cast<std::uint32_t>(random() % t.cells().size()));
      if (expected.kind == DelaunayLocation::Kind::outside) {
        EXPECT_EQ(from_end.kind, expected.kind);
        EXPECT_EQ(found.kind, expected.kind);
        continue;
      }
      ASSERT_EQ(expected.kind, is_flat ? DelaunayLocation::Kind::facet : DelaunayLocation::Kind::cell);
      EXPECT_TRUE(is_same(from_end, expected));
      EXPECT_TRUE(is_same(found, expected));
    }
  }
}

}  // namespace
}  // namespace quoin
