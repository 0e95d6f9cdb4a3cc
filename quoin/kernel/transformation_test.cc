// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/transformation.h"

#include <gtest/gtest.h>

#include <limits>

#include "quoin/base/error.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::any_finite;
using testing::Random;
using testing::small_integer;

Transformation any_transformation(Random& random, double (*entry)(Random&)) {
  std::array<std::array<double, 4>, 3> rows{};
  for (auto& row : rows) {
    for (double& x : row) x = entry(random);
  }
  return Transformation::from_doubles(rows);
}

TEST(Transformation, ComposingIsApplyingOneAfterTheOther) {
  Random random(61);
  for (int i = 0; i < 500; ++i) {
    const auto entry = i % 2 == 0 ? [](Random& r) { return small_integer(r, 3); } : any_finite;
    const Transformation a = any_transformation(random, entry);
    const Transformation b = any_transformation(random, entry);
    const Transformation c = any_transformation(random, entry);
    const Point3 p{any_finite(random), small_integer(random, 5), any_finite(random)};
    ASSERT_EQ((a * b)(p), a(b(p)));
    ASSERT_EQ((a * b) * c, a * (b * c));
    ASSERT_EQ((a * b).determinant(), a.determinant() * b.determinant());
  }
}

TEST(Transformation, InverseUndoes) {
  Random random(62);
  int inverted = 0;
  for (int i = 0; i < 500; ++i) {
    const auto entry = i % 2 == 0 ? [](Random& r) { return small_integer(r, 2); } : any_finite;
    const Transformation a = any_transformation(random, entry);
    if (a.determinant().sign() == Sign::zero) {
      ASSERT_THROW(a.inverse(), InputError);
      continue;
    }
    ++inverted;
    ASSERT_EQ(a * a.inverse(), Transformation());
    ASSERT_EQ(a.inverse() * a, Transformation());
  }
  EXPECT_GT(inverted, 400);
}

TEST(Transformation, RotationsKeepDistancesAndOrientation) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Transformation turn = Transformation::rotation(axis, Rational(1) / Rational(3));
    EXPECT_EQ(turn.determinant(), Rational(1));
    const RationalPoint3 q = turn(Point3{1, 2, 3});
    EXPECT_EQ(q.x * q.x + q.y * q.y + q.z * q.z, Rational(14));
    EXPECT_EQ(Transformation::rotation(axis, Rational(1)), Transformation::quarter_turns(axis, 1));
    EXPECT_EQ(Transformation::rotation(axis, Rational(-1)), Transformation::quarter_turns(axis, -1));
    const Transformation quarter = Transformation::quarter_turns(axis, 1);
    EXPECT_EQ(quarter * quarter, Transformation::quarter_turns(axis, 2));
    EXPECT_EQ(quarter * quarter * quarter, Transformation::quarter_turns(axis, 7));
    EXPECT_EQ(Transformation::quarter_turns(axis, -4), Transformation());
    Point3 p{};
    p[(axis + 1) % 3] = 1;
    Point3 expected{};
    expected[(axis + 2) % 3] = 1;
    EXPECT_EQ(quarter.image_if_exact(p), expected);
  }
}

TEST(Transformation, SaysWhetherAnImageIsExact) {
  const Transformation third = Transformation::scaling(Rational(1) / Rational(3), Rational(1), Rational(1));
  EXPECT_EQ(third.image_if_exact({3, 5, 7}), (Point3{1, 5, 7}));
  EXPECT_EQ(third.image_if_exact({1, 5, 7}), std::nullopt);
  EXPECT_EQ(third.rounded_image({1, 5, 7}), (Point3{1.0 / 3, 5, 7}));
  const Transformation shift = Transformation::translation(Rational(1), Rational(0), Rational(0));
  EXPECT_EQ(shift.image_if_exact({0x1p-53, 0, 0}), std::nullopt);
  EXPECT_EQ(shift.image_if_exact({0x1p-52, 0, 0}), (Point3{1 + 0x1p-52, 0, 0}));
  const Transformation twice = Transformation::scaling(Rational(2), Rational(2), Rational(2));
  EXPECT_EQ(twice.image_if_exact({0x1p1023, 0, 0}), std::nullopt);
  EXPECT_EQ(twice.inverse().image_if_exact({5e-324, 0, 0}), std::nullopt);
  EXPECT_EQ(twice.image_if_exact({5e-324, 0, 0}), (Point3{1e-323, 0, 0}));
}

TEST(Transformation, ImagesAgreeWithRationals) {
  Random random(63);
  for (int i = 0; i < 2'000; ++i) {
    const Transformation a = any_transformation(random, [](Random& r) { return small_integer(r, 3); });
    const Point3 p{testing::with_exponent(random, -2, 2), small_integer(random, 9), testing::awkward(random)};
    const RationalPoint3 q = a(p);
    const auto exact = a.image_if_exact(p);
    const Point3 rounded = a.rounded_image(p);
    const bool is_finite = std::isfinite(rounded.x) && std::isfinite(rounded.y) && std::isfinite(rounded.z);
    const bool is_exact =
        is_finite && RationalPoint3{Rational(rounded.x), Rational(rounded.y), Rational(rounded.z)} == q;
    ASSERT_EQ(exact.has_value(), is_exact);
    if (is_exact) {
      ASSERT_EQ(*exact, rounded);
    }
  }
}

TEST(Transformation, RefusesEntriesThatAreNotFinite) {
  std::array<std::array<double, 4>, 3> rows{};
  rows[1][3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Transformation::from_doubles(rows), InputError);
}

}  // namespace
}  // namespace quoin
