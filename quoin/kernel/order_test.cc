// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/order.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "quoin/kernel/plane.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::families;
using testing::Family;
using testing::near_degenerate;
using testing::Random;
using testing::reproduce;
using Quadruple = std::array<Point3, 4>;

Vector3 vector_of(const Point3& p) {
  return {p.x, p.y, p.z};
}

Sign rational_dot(const std::vector<Rational>& d, const std::vector<Rational>& p, const std::vector<Rational>& q) {
  Rational sum;
  for (std::size_t i = 0; i < d.size(); ++i) sum += d[i] * (p[i] - q[i]);
  return sum.sign();
}

Sign rational_along_line(const Quadruple& p) {
  const auto a = testing::coordinates(p[0]);
  auto d = testing::coordinates(p[1]);
  for (std::size_t i = 0; i < 3; ++i) d[i] -= a[i];
  return rational_dot(d, testing::coordinates(p[2]), testing::coordinates(p[3]));
}

TEST(Order, LexicographicOnTheGrid) {
  const auto grid = testing::grid3(2);  // by z, then x, then y
  for (const Point3& p : grid) {
    for (const Point3& q : grid) {
      const Sign expected = sign_of(9 * (p.x - q.x) + 3 * (p.y - q.y) + (p.z - q.z));
      ASSERT_EQ(compare_lexicographically(p, q), expected);
      ASSERT_EQ(lexicographically_less(p, q), expected == Sign::negative);
      const Sign planar = sign_of(3 * (p.x - q.x) + (p.y - q.y));
      ASSERT_EQ(compare_lexicographically(Point2{p.x, p.y}, Point2{q.x, q.y}), planar);
      ASSERT_EQ(lexicographically_less(Point2{p.x, p.y}, Point2{q.x, q.y}), planar == Sign::negative);
    }
  }
  EXPECT_EQ(compare_lexicographically(Point3{0.0, 0, 0}, Point3{-0.0, 0, 0}), Sign::zero);
}

TEST(Order, EveryTierAgreesWithRationals) {
  Random random(31);
  std::map<Tier, int> tiers;
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < 2'000; ++i) {
      const auto p = near_degenerate<Point3, 4>(random, family);
      SCOPED_TRACE(reproduce(p));
      Tier tier{};
      const Sign along =
          rational_dot(testing::coordinates(p[0]), testing::coordinates(p[1]), testing::coordinates(p[2]));
      ASSERT_EQ(compare_along(vector_of(p[0]), p[1], p[2], tier), along);
      ++tiers[tier];
      ASSERT_EQ(compare_along(vector_of(p[0]), p[2], p[1]), -along);
      ASSERT_EQ(compare_along(Vector3{-p[0].x, -p[0].y, -p[0].z}, p[1], p[2]), -along);
      const Sign line = rational_along_line(p);
      ASSERT_EQ(compare_along_line(p[0], p[1], p[2], p[3], tier), line);
      ++tiers[tier];
      ASSERT_EQ(compare_along_line(p[1], p[0], p[2], p[3]), -line);
      ASSERT_EQ(compare_along_line(p[2], p[3], p[0], p[1]), line);
      const auto planar = [](const Point3& q) { return Point2{q.x, q.y}; };
      const Sign in_plane = rational_dot(testing::coordinates(planar(p[0])), testing::coordinates(planar(p[1])),
                                         testing::coordinates(planar(p[2])));
      ASSERT_EQ(compare_along(Vector2{p[0].x, p[0].y}, planar(p[1]), planar(p[2])), in_plane);
    }
  }
  for (const Tier tier : {Tier::filter, Tier::expansion, Tier::bits61, Tier::bits124, Tier::big}) {
    EXPECT_GT(tiers[tier], 100) << static_cast<int>(tier);
  }
}

TEST(Order, TheFilterDecidesRandomPointsAndLaterTiersDegenerateOnes) {
  Random random(32);
  std::map<Tier, int> tiers;
  for (int i = 0; i < 10'000; ++i) {
    Quadruple p;
    for (Point3& point : p) point = testing::make_point(&point, random, families()[0].coordinate);
    Tier tier{};
    compare_along_line(p[0], p[1], p[2], p[3], tier);
    ++tiers[tier];
    compare_along(vector_of(p[0]), p[2], p[3], tier);
    ++tiers[tier];
    side(p[0], {vector_of(p[1]), p[2].x}, tier);
    ++tiers[tier];
  }
  EXPECT_GE(tiers[Tier::filter], 29'998);
  Tier tier{};
  EXPECT_EQ(compare_along(Vector3{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::expansion);
  EXPECT_EQ(compare_along(Vector3{1e-300, 1e-300, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::big);
  EXPECT_EQ(compare_along_line({0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits61);
}

Sign rational_side(const Point3& p, const Plane3& plane) {
  const Vector3& n = plane.normal;
  return (Rational(n.x) * Rational(p.x) + Rational(n.y) * Rational(p.y) + Rational(n.z) * Rational(p.z) -
          Rational(plane.offset))
      .sign();
}

TEST(Plane, SideAgreesWithRationals) {
  Random random(33);
  std::map<Tier, int> tiers;
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < 2'000; ++i) {
      const auto p = near_degenerate<Point3, 2>(random, family);
      const Vector3 n = vector_of(p[1]);
      const double near = n.x * p[0].x + n.y * p[0].y + n.z * p[0].z;
      const bool is_near = std::isfinite(near) && i % 2 == 0;
      const Plane3 plane{n, is_near ? near : family.coordinate(random)};
      SCOPED_TRACE(::testing::Message() << reproduce(p) << std::hexfloat << plane.offset);
      Tier tier{};
      const Sign expected = rational_side(p[0], plane);
      ASSERT_EQ(side(p[0], plane, tier), expected);
      ++tiers[tier];
      ASSERT_EQ(side(p[0], {{-n.x, -n.y, -n.z}, -plane.offset}), -expected);
    }
  }
  for (const Tier tier : {Tier::filter, Tier::expansion, Tier::big}) EXPECT_GT(tiers[tier], 100);
}

}  // namespace
}  // namespace quoin
