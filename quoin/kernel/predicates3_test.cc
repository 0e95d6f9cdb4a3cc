// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/predicates3.h"

#include <gtest/gtest.h>

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
using Quadruple = std::array<Point3, 4>;
using Quintuple = std::array<Point3, 5>;
using Integers = std::array<std::int64_t, 3>;

Sign orientation_of(const Quadruple& p, Tier& tier) {
  return orientation(p[0], p[1], p[2], p[3], tier);
}
Sign in_sphere_of(const Quintuple& p, Tier& tier) {
  return in_sphere(p[0], p[1], p[2], p[3], p[4], tier);
}
// Rows (a, 1) .. (d, 1): taking the first from the others leaves minus the cofactor of its last column.
Sign rational_orientation(const Quadruple& p) {
  return -testing::sign_of_rows(p, false);
}
// Taking the last row from the others leaves the determinant of in_sphere's rows, of which it is the negative.
Sign rational_in_sphere(const Quintuple& p) {
  return -testing::sign_of_rows(p, true);
}

Integers difference(const Point3& p, const Point3& q) {
  return {static_cast<std::int64_t>(p.x - q.x), static_cast<std::int64_t>(p.y - q.y),
          static_cast<std::int64_t>(p.z - q.z)};
}
std::int64_t determinant(const Integers& a, const Integers& b, const Integers& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
std::int64_t lift(const Integers& a) {
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}
Sign integer_in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  const Integers ra = difference(a, e);
  const Integers rb = difference(b, e);
  const Integers rc = difference(c, e);
  const Integers rd = difference(d, e);
  return sign_of(lift(ra) * determinant(rb, rc, rd) - lift(rb) * determinant(ra, rc, rd) +
                 lift(rc) * determinant(ra, rb, rd) - lift(rd) * determinant(ra, rb, rc));
}

TEST(Predicates3, OrientationOnTheWholeGrid) {
  const auto grid = testing::grid3(2);
  for (const Point3& a : grid) {
    for (const Point3& b : grid) {
      for (const Point3& c : grid) {
        for (const Point3& d : grid) {
          const Sign expected = sign_of(determinant(difference(b, a), difference(c, a), difference(d, a)));
          ASSERT_EQ(orientation(a, b, c, d), expected) << reproduce(Quadruple{a, b, c, d});
        }
      }
    }
  }
}

// Every configuration of five vertices of the cube of side 1, and every choice of five points of the grid 0 .. 2 with
// the first one at a corner, edge midpoint, face centre or the centre.
TEST(Predicates3, InSphereOnGrids) {
  const auto cube = testing::grid3(1);
  for (std::size_t code = 0; code < 8 * 8 * 8 * 8 * 8; ++code) {
    const auto vertex = [&](std::size_t k) { return cube[(code >> (3 * k)) % 8]; };
    const Quintuple p{vertex(0), vertex(1), vertex(2), vertex(3), vertex(4)};
    Tier tier{};
    ASSERT_EQ(in_sphere_of(p, tier), integer_in_sphere(p[0], p[1], p[2], p[3], p[4])) << reproduce(p);
  }
  const auto grid = testing::grid3(2);
  int zeros = 0;
  for (const Point3& a : {grid[0], grid[1], grid[4], grid[13]}) {
    for (std::size_t b = 0; b < grid.size(); ++b) {
      for (std::size_t c = b + 1; c < grid.size(); ++c) {
        for (std::size_t d = c + 1; d < grid.size(); ++d) {
          for (std::size_t e = d + 1; e < grid.size(); ++e) {
            const Quintuple p{a, grid[b], grid[c], grid[d], grid[e]};
            const Sign expected = integer_in_sphere(p[0], p[1], p[2], p[3], p[4]);
            zeros += static_cast<int>(expected == Sign::zero);
            Tier tier{};
            ASSERT_EQ(in_sphere_of(p, tier), expected) << reproduce(p);
          }
        }
      }
    }
  }
  EXPECT_GT(zeros, 5'000);
}

TEST(Predicates3, EveryTierAgreesWithRationals) {
  Random random(21);
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < test_rounds(1'000); ++i) {
      const auto p = near_degenerate<Point3, 4>(random, family);
      const auto q = near_degenerate<Point3, 5>(random, family);
      Tier tier{};
      const Sign side = rational_orientation(p);
      ASSERT_EQ(orientation_of(p, tier), side) << reproduce(p);
      ASSERT_EQ(detail::exact_orientation(p[0], p[1], p[2], p[3], tier), side) << reproduce(p);
      const Sign inside = rational_in_sphere(q);
      ASSERT_EQ(in_sphere_of(q, tier), inside) << reproduce(q);
      ASSERT_EQ(detail::exact_in_sphere(q[0], q[1], q[2], q[3], q[4], tier), inside) << reproduce(q);
    }
  }
}

// Around the limits of the filters: points near the largest coordinates they accept and where products underflow.
TEST(Predicates3, FiltersDecideRightlyAtTheEndsOfTheirRanges) {
  Random random(22);
  for (const int exponent : {-1070, -350, -30, -16, -14, -400, -380, -250, -215, -130, -110,
                             135,   139,  140, 141, 338, 339,  340,  341,  350,  680,  1022}) {
    for (int i = 0; i < test_rounds(300); ++i) {
      Quintuple p;
      for (Point3& point : p) {
        for (unsigned axis = 0; axis < 3; ++axis) {
          const int least = random() % 4 == 0 ? -1074 : exponent;
          point[axis] = std::ldexp(testing::small_integer(random, 3), random() % 2 == 0 ? exponent : least);
        }
      }
      const Quadruple q{p[0], p[1], p[2], p[3]};
      Tier tier{};
      ASSERT_EQ(orientation_of(q, tier), rational_orientation(q)) << reproduce(q);
      ASSERT_EQ(in_sphere_of(p, tier), rational_in_sphere(p)) << reproduce(p);
    }
  }
}

TEST(Predicates3, SwappingTwoArgumentsNegates) {
  Random random(23);
  for (const Family& family : families()) {
    for (int i = 0; i < 500; ++i) {
      auto p = near_degenerate<Point3, 4>(random, family);
      auto q = near_degenerate<Point3, 5>(random, family);
      Tier tier{};
      const Sign side = orientation_of(p, tier);
      const Sign inside = in_sphere_of(q, tier);
      std::swap(p[random() % 2], p[2 + random() % 2]);
      std::swap(q[random() % 2], q[2 + random() % 3]);
      ASSERT_EQ(orientation_of(p, tier), -side) << reproduce(p);
      ASSERT_EQ(in_sphere_of(q, tier), -inside) << reproduce(q);
    }
  }
}

TEST(Predicates3, ExactScalingAndTranslationKeepTheSign) {
  Random random(24);
  for (int i = 0; i < 5'000; ++i) {
    Quintuple p;
    for (Point3& point : p) point = testing::make_point(&point, random, families()[1].coordinate);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 2000) - 1000);
    const double by = testing::small_integer(random, 1 << 20);
    Quintuple q = p;
    for (Point3& point : q) {
      point = {(4 * point.x + by) * scale, (4 * point.y - by) * scale, (4 * point.z + by) * scale};
    }
    Tier tier{};
    ASSERT_EQ(orientation(q[0], q[1], q[2], q[3]), orientation(p[0], p[1], p[2], p[3])) << reproduce(q);
    ASSERT_EQ(in_sphere_of(q, tier), in_sphere_of(p, tier)) << reproduce(q);
  }
}

TEST(Predicates3, KnownSigns) {
  const Point3 a{0, 0, 0};
  const Point3 b{1, 0, 0};
  const Point3 c{0, 1, 0};
  const Point3 d{0, 0, 1};
  EXPECT_EQ(orientation(a, b, c, d), Sign::positive);
  EXPECT_EQ(in_sphere(a, b, c, d, {0.5, 0.5, 0.5}), Sign::positive);
  EXPECT_EQ(in_sphere(a, b, c, d, {1, 1, 1}), Sign::zero);
  EXPECT_EQ(in_sphere(a, b, c, d, {2, 2, 2}), Sign::negative);
}

TEST(Predicates3, TheFilterDecidesRandomPointsAndLaterTiersDegenerateOnes) {
  Random random(25);
  std::map<Tier, int> sides;
  std::map<Tier, int> spheres;
  for (int i = 0; i < 10'000; ++i) {
    Quintuple p;
    for (Point3& point : p) point = testing::make_point(&point, random, families()[0].coordinate);
    Tier tier{};
    orientation(p[0], p[1], p[2], p[3], tier);
    ++sides[tier];
    in_sphere_of(p, tier);
    ++spheres[tier];
  }
  EXPECT_GE(sides[Tier::filter], 9'990);
  EXPECT_GE(spheres[Tier::filter], 9'990);

  Tier tier{};
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits61);
  EXPECT_EQ(orientation({0x1p-80, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits124);
  EXPECT_EQ(orientation({1e-300, 0, 0}, {1e300, 0, 0}, {0, 1, 0}, {5, 7, 0}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::big);
  EXPECT_EQ(in_sphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, tier), Sign::zero);
  EXPECT_EQ(tier, Tier::bits61);
}

}  // namespace
}  // namespace quoin
