// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/predicates2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::families;
using testing::Family;
using testing::near_degenerate;
using testing::Random;
using testing::reproduce;
using Triple = std::array<Point2, 3>;
using Quadruple = std::array<Point2, 4>;

Sign orientation_of(const Triple& p, Tier& tier) {
  return orientation(p[0], p[1], p[2], tier);
}
Sign in_circle_of(const Quadruple& p, Tier& tier) {
  return in_circle(p[0], p[1], p[2], p[3], tier);
}
// The determinants of the affine rows are these predicates without a change of sign: the rows (a, 1), (b, 1), (c, 1)
// reduce to (b - a, c - a); in the circle test d comes last, as in (a - d, b - d, c - d) times the cofactor + 1.
Sign rational_orientation(const Triple& p) {
  return testing::sign_of_rows(p, false);
}
Sign rational_in_circle(const Quadruple& p) {
  return testing::sign_of_rows(p, true);
}

std::int64_t integer(double x) {
  return static_cast<std::int64_t>(x);
}

TEST(Predicates2, OrientationOnTheWholeGrid) {
  const auto grid = testing::grid2(3);
  for (const Point2& a : grid) {
    for (const Point2& b : grid) {
      for (const Point2& c : grid) {
        const auto area = integer(b.x - a.x) * integer(c.y - a.y) - integer(b.y - a.y) * integer(c.x - a.x);
        ASSERT_EQ(orientation(a, b, c), sign_of(area)) << reproduce(Triple{a, b, c});
      }
    }
  }
}

TEST(Predicates2, InCircleOnTheWholeGrid) {
  const auto grid = testing::grid2(3);
  int zeros = 0;
  for (const Point2& a : grid) {
    for (const Point2& b : grid) {
      for (const Point2& c : grid) {
        for (const Point2& d : grid) {
          const auto minor = [&](const Point2& p, const Point2& q, const Point2& r) {
            const auto lift = integer(p.x - d.x) * integer(p.x - d.x) + integer(p.y - d.y) * integer(p.y - d.y);
            return lift * (integer(q.x - d.x) * integer(r.y - d.y) - integer(q.y - d.y) * integer(r.x - d.x));
          };
          const Sign expected = sign_of(minor(a, b, c) + minor(b, c, a) + minor(c, a, b));
          zeros += static_cast<int>(expected == Sign::zero);
          ASSERT_EQ(in_circle(a, b, c, d), expected) << reproduce(Quadruple{a, b, c, d});
        }
      }
    }
  }
  EXPECT_GT(zeros, 10'000);
}

TEST(Predicates2, EveryTierAgreesWithRationals) {
  Random random(11);
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < test_rounds(4'000); ++i) {
      const auto p = near_degenerate<Point2, 3>(random, family);
      const auto q = near_degenerate<Point2, 4>(random, family);
      Tier tier{};
      const Sign turn = rational_orientation(p);
      ASSERT_EQ(orientation_of(p, tier), turn) << reproduce(p);
      ASSERT_EQ(detail::exact_orientation(p[0], p[1], p[2], tier), turn) << reproduce(p);
      const Sign inside = rational_in_circle(q);
      ASSERT_EQ(in_circle_of(q, tier), inside) << reproduce(q);
      ASSERT_EQ(detail::exact_in_circle(q[0], q[1], q[2], q[3], tier), inside) << reproduce(q);
    }
  }
}

TEST(Predicates2, SwappingTwoArgumentsNegates) {
  Random random(12);
  for (const Family& family : families()) {
    for (int i = 0; i < 500; ++i) {
      auto p = near_degenerate<Point2, 3>(random, family);
      auto q = near_degenerate<Point2, 4>(random, family);
      Tier tier{};
      const Sign turn = orientation_of(p, tier);
      const Sign inside = in_circle_of(q, tier);
      const std::size_t k = random() % 2;
      std::swap(p[k], p[2]);
      std::swap(q[k], q[2 + random() % 2]);
      ASSERT_EQ(orientation_of(p, tier), -turn) << reproduce(p);
      ASSERT_EQ(in_circle_of(q, tier), -inside) << reproduce(q);
    }
  }
}

TEST(Predicates2, ExactScalingAndTranslationKeepTheSign) {
  Random random(13);
  for (int i = 0; i < 5'000; ++i) {
    Quadruple p;
    for (Point2& point : p) point = testing::make_point(&point, random, families()[1].coordinate);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 2000) - 1000);
    const double by = testing::small_integer(random, 1 << 20);
    Quadruple q = p;
    for (Point2& point : q) point = {(4 * point.x + by) * scale, (4 * point.y - by) * scale};
    ASSERT_EQ(orientation(q[0], q[1], q[2]), orientation(p[0], p[1], p[2])) << reproduce(q);
    ASSERT_EQ(in_circle(q[0], q[1], q[2], q[3]), in_circle(p[0], p[1], p[2], p[3])) << reproduce(q);
  }
}

TEST(Predicates2, KnownSigns) {
  const Point2 a{0, 0};
  const Point2 b{1, 0};
  const Point2 c{0, 1};
  EXPECT_EQ(orientation(a, b, c), Sign::positive);
  EXPECT_EQ(in_circle(a, b, c, {0.5, 0.5}), Sign::positive);
  EXPECT_EQ(in_circle(a, b, c, {1, 1}), Sign::zero);
  EXPECT_EQ(in_circle(a, b, c, {2, 2}), Sign::negative);
}

TEST(Predicates2, TheFilterDecidesRandomPointsAndLaterTiersDegenerateOnes) {
  Random random(14);
  std::map<Tier, int> turns;
  std::map<Tier, int> circles;
  for (int i = 0; i < 10'000; ++i) {
    Quadruple p;
    for (Point2& point : p) point = testing::make_point(&point, random, families()[0].coordinate);
    Tier tier{};
    orientation(p[0], p[1], p[2], tier);
    ++turns[tier];
    in_circle(p[0], p[1], p[2], p[3], tier);
    ++circles[tier];
  }
  EXPECT_GE(turns[Tier::filter], 9'999);
  EXPECT_GE(circles[Tier::filter], 9'990);

  Tier tier{};
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {3, 3}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::expansion);
  EXPECT_EQ(orientation({0.1, 0.1}, {1, 1}, {0.7, 0.7}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits61);
  EXPECT_EQ(orientation({0x1p-80, 0x1p-80}, {1, 1}, {0.7, 0.7}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits124);
  EXPECT_EQ(orientation({1e-300, 1e-300}, {1e300, 1e300}, {0.7, 0.7}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::big);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits61);
}

}  // namespace
}  // namespace quoin
