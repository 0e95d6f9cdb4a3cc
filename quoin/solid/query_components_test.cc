// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "quoin/solid/query/shell_components.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

Solid box(const Point3& lo, const Point3& hi) {
  return Solid::from_leaf(make_leaf(shapes::box(lo, hi), {}, one_thread).leaf, one_thread);
}

// The shell of a face whose rounded corners all have this coordinate along the axis.
std::uint32_t shell_at(const Brep& b, std::size_t axis, double coordinate) {
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    bool is_there = true;
    for (const PointId p : b.loop(b.face_first_loop[f])) is_there = is_there && b.points.rounded(p)[axis] == coordinate;
    if (is_there) return b.face_shells[f];
  }
  ADD_FAILURE() << "no face at " << coordinate;
  return 0;
}

// Every piece numbered, and its number the same for shells named together.
void expect_groups(const Solid& solid, const std::vector<std::vector<std::uint32_t>>& groups) {
  const std::vector<std::uint32_t> components = components_of_shells(solid.boundary(), one_thread);
  ASSERT_EQ(components.size(), solid.boundary().shells.size());
  EXPECT_EQ(groups.size(), solid.boundary().component_count);
  std::vector<bool> taken(solid.boundary().component_count, false);
  for (const auto& group : groups) {
    for (const std::uint32_t shell : group) EXPECT_EQ(components[shell], components[group[0]]) << "shell " << shell;
    ASSERT_LT(components[group[0]], taken.size());
    EXPECT_FALSE(taken[components[group[0]]]) << "two pieces have one number";
    taken[components[group[0]]] = true;
  }
}

TEST(ShellComponents, OfBoxesInsideBoxes) {
  // A shell with a smaller one in its cavity, and a block beside them.
  const Solid outer = subtract(box({0, 0, 0}, {12, 12, 12}), std::vector{box({1, 1, 1}, {11, 11, 11})}, one_thread);
  const Solid inner = subtract(box({2, 2, 2}, {10, 10, 10}), std::vector{box({3, 3, 3}, {9, 9, 9})}, one_thread);
  const Solid all = unite(std::vector{inner, box({20, 0, 0}, {21, 1, 1}), outer}, one_thread);
  const Brep& b = all.boundary();
  ASSERT_EQ(b.shells.size(), 5U);
  expect_groups(
      all, {{shell_at(b, 2, 12), shell_at(b, 2, 11)}, {shell_at(b, 2, 2), shell_at(b, 2, 3)}, {shell_at(b, 0, 20)}});
}

TEST(ShellComponents, OfHookedCavities) {
  // Two channels that hook into one another: upward from one is the other, and the other way round.
  const auto channel = [](const Point3& lo, const Point3& hi, const Point3& bar_lo, const Point3& bar_hi) {
    return subtract(box(lo, hi), std::vector{box(bar_lo, bar_hi)}, one_thread);
  };
  const Solid below = channel({4, 5, 1}, {12, 7, 9}, {6, 4, 3}, {10, 8, 7});
  const Solid above = channel({7, 2, 5}, {9, 10, 13}, {6, 4, 6.5}, {10, 8, 11});
  const Solid left = box({0, 0, 0}, {16, 16, 16});
  const Solid right = box({20, 0, 0}, {36, 16, 16});
  const Solid hollow = subtract(left, std::vector{below, above}, one_thread);
  const Solid all = unite(std::vector{hollow, right}, one_thread);
  const Brep& b = all.boundary();
  ASSERT_EQ(b.shells.size(), 4U);
  expect_groups(all, {{shell_at(b, 0, 0), shell_at(b, 2, 1), shell_at(b, 2, 13)}, {shell_at(b, 0, 20)}});
}

TEST(ShellComponents, WhereTheLineMeetsAnEdgeThatTwoPiecesShare) {
  // Two blocks with an edge in common right above a cavity's middle; the cavity belongs to neither.
  const Solid hollow = subtract(box({0, 0, 0}, {8, 8, 8}), std::vector{box({3, 3, 3}, {5, 5, 5})}, one_thread);
  const Solid one = subtract(box({2, 2, 20}, {4, 6, 24}), std::vector{box({2.5, 3, 21}, {3.5, 5, 23})}, one_thread);
  const Solid other = box({4, 2, 24}, {6, 6, 28});
  const Solid all = unite(std::vector{hollow, one, other}, one_thread);
  const Brep& b = all.boundary();
  ASSERT_EQ(b.component_count, 3U);
  expect_groups(
      all, {{shell_at(b, 2, 0), shell_at(b, 2, 3)}, {shell_at(b, 2, 20), shell_at(b, 2, 21)}, {shell_at(b, 2, 28)}});
}

TEST(ShellComponents, OfWhatReachesInfinity) {
  const Solid hollow = subtract(box({2, 2, 2}, {8, 8, 8}), std::vector{box({3, 3, 3}, {7, 7, 7})}, one_thread);
  const Solid around = complement(box({0, 0, 0}, {10, 10, 10}), one_thread);
  const Solid pit = complement(box({0, 0, 30}, {10, 10, 40}), one_thread);
  const Solid all = unite(std::vector{hollow, intersect(std::vector{around, pit}, one_thread)}, one_thread);
  const Brep& b = all.boundary();
  ASSERT_TRUE(b.is_unbounded);
  ASSERT_EQ(b.shells.size(), 4U);
  const auto components = components_of_shells(b, one_thread);
  EXPECT_EQ(components[shell_at(b, 2, 0)], 0U);
  EXPECT_EQ(components[shell_at(b, 2, 30)], 0U);
  EXPECT_EQ(components[shell_at(b, 2, 2)], 1U);
  EXPECT_EQ(components[shell_at(b, 2, 3)], 1U);
}

}  // namespace
}  // namespace quoin
