// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/scaled_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::Random;
using Five = std::array<Point3, 5>;

constexpr double scale = 0x1p60;
constexpr double unit = 0x1p-60;

bool is_decided(const Five& p, int& sign) {
  return detail::in_sphere_of_integers({&p[0], &p[1], &p[2], &p[3], &p[4]}, scale, unit, sign);
}

/// What the header promises, read from the bits.
bool is_promised(const Five& p) {
  for (const Point3& q : p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::fabs(q[axis]) > 2 || std::fmod(q[axis], unit) != 0) return false;
      const Rational difference = Rational(q[axis]) - Rational(p[4][axis]);
      if (difference < Rational(-2) || difference >= Rational(2)) return false;
    }
  }
  return true;
}

/// How many of the rounds were decided.
template <class Make>
int check(const Make& make, int rounds) {
  Random random(20);
  int decided = 0;
  for (int round = 0; round < test_rounds(rounds); ++round) {
    const Five p = make(random);
    int sign = 7;
    const bool is_done = is_decided(p, sign);
    EXPECT_EQ(is_done, is_promised(p)) << testing::reproduce(p);
    if (!is_done) continue;
    ++decided;
    EXPECT_EQ(sign, -to_int(testing::sign_of_rows(p, true))) << testing::reproduce(p);
    if (::testing::Test::HasFailure()) break;
  }
  return decided;
}

Point3 on_sphere(Random& random, const Point3& about, double spread) {
  std::normal_distribution<double> normal;
  Point3 p;
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = about[axis] + spread * normal(random);
    square += p[axis] * p[axis];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) p[axis] /= std::sqrt(square);
  return p;
}

TEST(ScaledSphere, DecidesPointsOfASphereThatAreNearEachOther) {
  for (const double spread : {1e-6, 1e-3, 0.1, 1.0}) {
    const auto make = [&](Random& random) {
      const Point3 about = on_sphere(random, {}, 1);
      Five p;
      for (Point3& q : p) q = on_sphere(random, about, spread);
      return p;
    };
    EXPECT_GT(check(make, 2000), test_cases(1500)) << spread;
  }
}

// All coordinates and differences at the ends of their ranges, where columns of products are largest.
TEST(ScaledSphere, HoldsTheLargestCoordinates) {
  const auto make = [](Random& random) {
    constexpr double below = 0x1.fffffffffffffp0;
    const std::array<double, 8> ends{-2, below, -below, 1, -1, below / 2, unit, 0};
    Five p;
    for (Point3& q : p) q = {ends[random() % 8], ends[random() % 8], ends[random() % 8]};
    if (random() % 8 == 0) p[random() % 4].y = 2;
    if (random() % 4 != 0) p[4] = {0, 0, 0};
    return p;
  };
  EXPECT_GT(check(make, 5000), test_cases(1500));
}

TEST(ScaledSphere, TellsPointsOfOneSphere) {
  const auto make = [](Random& random) {
    Five p;
    for (Point3& q : p) {
      const auto sign = [&random] { return random() % 2 == 0 ? 1.0 : -1.0; };
      q = {3 * sign(), 4 * sign(), 12 * sign()};
      if (random() % 2 == 0) std::swap(q.x, q.y);
      for (std::size_t axis = 0; axis < 3; ++axis) q[axis] *= 0x1p-4;
    }
    // One of them off by one bit of the last place, or not.
    if (random() % 2 == 0) p[random() % 5][random() % 3] += random() % 2 == 0 ? unit : -unit;
    return p;
  };
  EXPECT_EQ(check(make, 5000), test_rounds(5000));
}

TEST(ScaledSphere, RefusesWhatIsNoInteger) {
  const auto make = [](Random& random) {
    Five p;
    for (Point3& q : p) {
      for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = testing::with_exponent(random, -6, 0);
    }
    const std::array<double, 7> awkward{2 * unit, unit, unit / 2, 0x1p-1074, 0x1.0000000000001p1, 0x1p1023, 0x1.8p-8};
    p[random() % 5][random() % 3] = awkward[random() % 7];
    return p;
  };
  const int decided = check(make, 5000);
  EXPECT_GT(decided, test_cases(100));
  EXPECT_LT(decided, 4900);
}

}  // namespace
}  // namespace quoin
