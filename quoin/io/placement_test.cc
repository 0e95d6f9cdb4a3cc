// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "quoin/base/test_rounds.h"

namespace quoin::io {
namespace {

// Of few bits, of all bits, near powers of two, tiny, huge and zero.
double awkward(std::mt19937_64& random) {
  const double sign = random() % 2 == 0 ? 1 : -1;
  const int exponent = static_cast<int>(random() % 7) - 3;
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return sign * std::ldexp(1, exponent * 20);
    case 2:
      return sign * std::ldexp(1 + 0x1p-52, exponent * 9);
    case 3:
      return sign * std::ldexp(1 - 0x1p-53, exponent * 9);
    case 4:
      return sign * static_cast<double>(random() % 16);
    case 5:
      return sign * std::ldexp(static_cast<double>(random() >> 11),
                               random() % 40 == 0 ? 900 : -1000 + 950 * (static_cast<int>(random() % 2)));
    default:
      return sign * std::ldexp(static_cast<double>(random() >> 11), exponent - 53);
  }
}

Transformation awkward_map(std::mt19937_64& random) {
  for (;;) {
    std::array<std::array<double, 4>, 3> rows{};
    for (auto& row : rows) {
      for (double& entry : row) entry = awkward(random);
    }
    Transformation map = Transformation::from_doubles(rows);
    if (map.determinant().sign() != Sign::zero) return map;
  }
}

// Every coordinate is what rationals say, and so are the number of rounded ones and the largest distance.
TEST(Placement, ImagesAreTheNearestDoubles) {
  std::mt19937_64 random(3);
  int rounded = 0;
  for (int round = 0; round < test_rounds(8000); ++round) {
    Transformation map = awkward_map(random);
    if (random() % 4 == 0) map = map * awkward_map(random);
    const Placement placement(map);
    EXPECT_EQ(placement.is_mirror(), map.determinant().sign() == Sign::negative);
    const Point3 p{awkward(random), awkward(random), awkward(random)};
    RoundingCount count;
    const Point3 image = placement.image(p, count);
    const RationalPoint3 exact = map(p);
    const Point3 expected = map.rounded_image(p);
    ASSERT_EQ(image, expected) << p.x << " " << p.y << " " << p.z;
    std::size_t coordinates = 0;
    Rational largest;
    for (const auto& [nearest, value] :
         {std::pair(expected.x, exact.x), {expected.y, exact.y}, {expected.z, exact.z}}) {
      if (!std::isfinite(nearest) || Rational(nearest) == value) continue;
      ++coordinates;
      largest = std::max(largest, abs(value - Rational(nearest)));
    }
    ASSERT_EQ(count.coordinates, coordinates);
    ASSERT_GE(Rational(count.largest), largest);
    ASSERT_LE(Rational(count.largest), largest * Rational(1 + 0x1p-40) + Rational(std::numeric_limits<double>::min()));
    rounded += static_cast<int>(coordinates);
  }
  EXPECT_GE(rounded, test_cases(4000));
}

// Sums in the middle between two doubles, and just beside it.
TEST(Placement, TiesGoToEven) {
  std::mt19937_64 random(4);
  for (int round = 0; round < test_rounds(5000); ++round) {
    const double large = 1 + std::ldexp(static_cast<double>(random() % 8), -52);
    const double half = random() % 2 == 0 ? 0x1p-53 : -0x1p-53;
    const double beside =
        std::ldexp(static_cast<double>(static_cast<int>(random() % 3)) - 1, -static_cast<int>(random() % 300) - 60);
    const Transformation map = Transformation::from_doubles({{{large, half, beside, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
    const Point3 p{1, 1, 1};
    RoundingCount count;
    ASSERT_EQ(Placement(map).image(p, count), map.rounded_image(p)) << large << " " << half << " " << beside;
    ASSERT_EQ(count.coordinates, map.image_if_exact(p) ? 0U : 1U);
  }
}

TEST(Placement, TheIdentityAndExactShiftsRoundNothing) {
  RoundingCount count;
  const Point3 p{0.1, 1e300, 5e-324};
  EXPECT_EQ(Placement(Transformation()).image(p, count), p);
  EXPECT_EQ(Placement(Transformation::translation(0, 0, 0)).image(p, count), p);
  EXPECT_EQ(Placement(Transformation::translation(2, -3, 0.5)).image({1, 2, 3}, count), (Point3{3, -1, 3.5}));
  EXPECT_EQ(count.coordinates, 0U);
}

}  // namespace
}  // namespace quoin::io
