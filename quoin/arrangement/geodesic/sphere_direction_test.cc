// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/sphere_direction.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "quoin/arrangement/geodesic/direction_pool.h"
#include "quoin/arrangement/geodesic/test_geodesics.h"

namespace quoin {
namespace {

using test_geodesics::is_zero;
using test_geodesics::same_ray;
using test_geodesics::text;
using test_geodesics::to_rationals;
using test_geodesics::Triple;

/// Doubles of all sizes, subnormal ones among them, often of one size.
Vector3 draw_vector(std::mt19937_64& random) {
  const auto draw = [&](int exponent) {
    const auto digits = static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * (random() % 2 == 0 ? 1 : -1);
    return random() % 5 == 0 ? 0.0 : std::ldexp(random() % 3 == 0 ? std::floor(digits * 0x1p-50) : digits, exponent);
  };
  constexpr std::array<int, 5> exponents{-1074, -1040, -53, 0, 900};
  const int common = exponents[random() % 5];
  const auto exponent = [&] {
    return random() % 4 == 0 ? exponents[random() % 5] : common + static_cast<int>(random() % 40);
  };
  return {draw(exponent()), draw(exponent()), draw(exponent())};
}

/// Integers around the sizes where the form changes.
Triple draw_integers(std::mt19937_64& random) {
  Triple result;
  const std::size_t bits = std::array<std::size_t, 7>{3, 61, 62, 63, 125, 126, 127}[random() % 7];
  for (Rational& value : result) {
    const Integer top = Integer(1) << (bits - 1);
    const Integer low = Integer(static_cast<int>(random() % 1000));
    value = Rational(random() % 2 == 0 ? top + low : (top << 1) - low - Integer(1));
    if (random() % 2 == 0) value = -value;
    if (random() % 8 == 0) value = 0;
  }
  return result;
}

TEST(SphereDirection, DoublesConvertExactly) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Vector3 v = draw_vector(random);
    const Triple exact{Rational(v.x), Rational(v.y), Rational(v.z)};
    const SphereDirection d = v;
    ASSERT_EQ(d.is_valid(), !is_zero(exact));
    if (!d.is_valid()) continue;
    ASSERT_TRUE(same_ray(to_rationals(d.integers()), exact)) << text(exact);
    ASSERT_EQ(d.primitive().integers(), SphereDirection(exact).primitive().integers()) << text(exact);
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(d.sign(axis), exact[axis].sign());
  }
}

TEST(SphereDirection, ProductsAreExactAcrossTheForms) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20000; ++i) {
    const Triple a = draw_integers(random);
    const Triple b = draw_integers(random);
    const SphereDirection d = a;
    const SphereDirection e = b;
    ASSERT_EQ(dot_sign(d, e), test_geodesics::scalar_product(a, b).sign()) << text(a) << text(b);
    const Triple product = test_geodesics::cross_product(a, b);
    const SphereDirection found = cross(d, e);
    ASSERT_EQ(found.is_valid(), !is_zero(product)) << text(a) << text(b);
    if (found.is_valid()) {
      ASSERT_TRUE(same_ray(to_rationals(found.integers()), product)) << text(a) << text(b);
    }
    ASSERT_EQ(d.is_valid(), !is_zero(a));
    ASSERT_EQ((-d).integers(), SphereDirection(test_geodesics::opposite(a)).integers());
  }
}

TEST(SphereDirection, WhatIsNotFiniteIsNoDirection) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(SphereDirection(Vector3{0, bad, 1}).is_finite());
    EXPECT_FALSE(SphereDirection(Vector3{0, bad, 1}).is_valid());
  }
  EXPECT_TRUE(SphereDirection(Vector3{0, 0, 0}).is_finite());
  EXPECT_FALSE(SphereDirection(Vector3{0, 0, 0}).is_valid());
}

TEST(DirectionPool, KeepsEqualIntegersOnceAndGivesThemBack) {
  std::mt19937_64 random(5);
  DirectionPool pool;
  std::vector<std::array<Integer, 3>> known;
  for (int i = 0; i < 3000; ++i) {
    const SphereDirection d = i % 3 == 0 && !known.empty() ? SphereDirection(known[random() % known.size()])
                                                           : SphereDirection(draw_integers(random));
    if (!d.is_valid()) continue;
    const std::uint32_t number = pool.insert(d);
    ASSERT_LE(number, known.size());
    if (number == known.size()) known.push_back(d.integers());
    ASSERT_EQ(known[number], d.integers());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Integer loaded;
      pool.load(number, axis, loaded);
      ASSERT_EQ(loaded, d.integer(axis));
      FixedInt<4> fixed;
      pool.load(number, axis, fixed);
      ASSERT_EQ(to_integer(fixed), d.integer(axis));
      ASSERT_EQ(pool.sign(number, axis), d.sign(axis));
    }
    ASSERT_EQ(pool.insert(d), number);
  }
  ASSERT_EQ(pool.size(), known.size());
}

}  // namespace
}  // namespace quoin
