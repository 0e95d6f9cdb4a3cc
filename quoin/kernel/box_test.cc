// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/box.h"

#include <gtest/gtest.h>

#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

TEST(Box3, IsTheSetOfItsPoints) {
  const auto grid = testing::grid3(2);
  testing::Random random(51);
  for (int i = 0; i < 2'000; ++i) {
    const auto any = [&] { return grid[random() % grid.size()]; };
    const Box3 a(any(), any());
    const Box3 b(any(), any());
    Box3 both = a;
    both.extend(b);
    bool is_inside = true;
    bool meets = false;
    for (const Point3& p : grid) {
      is_inside = is_inside && (!b.contains(p) || a.contains(p));
      meets = meets || (a.contains(p) && b.contains(p));
      ASSERT_TRUE(both.contains(p) || !(a.contains(p) || b.contains(p)));
    }
    ASSERT_EQ(a.contains(b), is_inside);
    ASSERT_EQ(a.overlaps(b), meets);
    ASSERT_EQ(b.overlaps(a), meets);
    ASSERT_TRUE(both.contains(a) && both.contains(b));
  }
}

TEST(Box3, NothingIsABox) {
  const Box3 nothing;
  const Box3 point({1, 2, 3}, {1, 2, 3});
  EXPECT_TRUE(nothing.is_empty());
  EXPECT_FALSE(point.is_empty());
  EXPECT_FALSE(nothing.overlaps(point));
  EXPECT_FALSE(nothing.overlaps(nothing));
  EXPECT_TRUE(point.contains(nothing));
  EXPECT_FALSE(nothing.contains(point));
  EXPECT_FALSE(nothing.contains(Point3{0, 0, 0}));
  Box3 extended;
  extended.extend(nothing);
  EXPECT_EQ(extended, nothing);
  extended.extend(Point3{1, 2, 3});
  EXPECT_EQ(extended, point);
  EXPECT_TRUE(point.overlaps(Box3({1, 2, 3}, {4, 4, 4})));
}

TEST(Box3, HoldsTheWholeRange) {
  constexpr double most = 0x1.fffffffffffffp1023;
  const Box3 all({-most, -most, -most}, {most, most, most});
  EXPECT_TRUE(all.contains(Point3{most, -5e-324, 0}));
  EXPECT_FALSE(Box3({0, 0, 0}, {1, 1, 1}).contains(Point3{-5e-324, 0, 0}));
}

}  // namespace
}  // namespace quoin
