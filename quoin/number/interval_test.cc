// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "quoin/number/test_doubles.h"

namespace quoin {
namespace {

using testing::awkward;
using testing::Random;
using testing::small_integer;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

void expect_valid(const Interval& a) {
  ASSERT_TRUE(a.lower() <= a.upper());
  ASSERT_LT(a.lower(), infinity);
  ASSERT_GT(a.upper(), -infinity);
}

Interval any_interval(Random& random) {
  double a = awkward(random);
  double b = random() % 3 == 0 ? a : awkward(random);
  if (a > b) std::swap(a, b);
  switch (random() % 8) {
    case 0:
      return {-infinity, b};
    case 1:
      return {a, infinity};
    case 2:
      return Interval::unbounded();
    default:
      return {a, b};
  }
}

std::vector<Rational> members(const Interval& a) {
  const double low = std::max(a.lower(), -largest);
  const double high = std::min(a.upper(), largest);
  return {Rational(low), Rational(high), (Rational(low) + Rational(high)) / Rational(2)};
}

TEST(Interval, OperationsHoldTheResultsOfTheirMembers) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const Interval a = any_interval(random);
    const Interval b = any_interval(random);
    SCOPED_TRACE(::testing::Message() << std::hexfloat << a.lower() << " " << a.upper() << " " << b.lower() << " "
                                      << b.upper());
    for (const Interval& c : {a + b, a - b, a * b, a / b, square(a), abs(a), -a}) expect_valid(c);
    for (const Rational& x : members(a)) {
      ASSERT_TRUE(square(a).contains(x * x));
      ASSERT_TRUE(abs(a).contains(abs(x)));
      ASSERT_TRUE((-a).contains(-x));
      for (const Rational& y : members(b)) {
        ASSERT_TRUE((a + b).contains(x + y));
        ASSERT_TRUE((a - b).contains(x - y));
        ASSERT_TRUE((a * b).contains(x * y));
        if (y.sign() != Sign::zero) {
          ASSERT_TRUE((a / b).contains(x / y));
        }
      }
    }
  }
}

// Between points the result is one double, or two neighbours around the exact value.
TEST(Interval, ResultsOfPointsAreTight) {
  Random random(6);
  for (int i = 0; i < 20'000; ++i) {
    const double a = awkward(random);
    const double b = awkward(random);
    SCOPED_TRACE(::testing::Message() << std::hexfloat << a << " " << b);
    const auto is_tight = [](const Interval& c) {
      return c.upper() <= std::nextafter(std::nextafter(c.lower(), infinity), infinity);
    };
    ASSERT_TRUE(is_tight(Interval(a) + Interval(b)));
    ASSERT_TRUE(is_tight(Interval(a) * Interval(b)));
    if (b != 0) {
      ASSERT_TRUE(is_tight(Interval(a) / Interval(b)));
    }
    ASSERT_TRUE(is_tight(square_root(Interval(std::fabs(a)))));
  }
}

TEST(Interval, SmallIntegersStayPoints) {
  for (int a = -20; a <= 20; ++a) {
    for (int b = -20; b <= 20; ++b) {
      ASSERT_EQ(Interval(a) + Interval(b), Interval(a + b));
      ASSERT_EQ(Interval(a) - Interval(b), Interval(a - b));
      ASSERT_EQ(Interval(a) * Interval(b), Interval(a * b));
      if (b != 0) {
        ASSERT_EQ(Interval(a * b) / Interval(b), Interval(a));
      }
    }
    ASSERT_EQ(square_root(Interval(a * a)), Interval(std::abs(a)));
  }
}

TEST(Interval, OverflowAndUnderflowGiveBoundsNeverNumbersThatAreNone) {
  EXPECT_EQ(Interval(largest) + Interval(largest), Interval(largest, infinity));
  EXPECT_EQ(Interval(-largest) * Interval(2), Interval(-infinity, -largest));
  EXPECT_EQ(Interval(smallest) * Interval(0.5), Interval(-smallest, smallest));
  EXPECT_EQ(Interval(0) * Interval::unbounded(), Interval(0));
  EXPECT_EQ(Interval(1) / Interval(0, 1), Interval::unbounded());
  EXPECT_EQ((Interval::unbounded() - Interval::unbounded()).sign(), std::nullopt);
  EXPECT_EQ(square_root(Interval(-1, infinity)), Interval(0, infinity));
}

TEST(Interval, RootsHoldTheirSquares) {
  Random random(7);
  for (int i = 0; i < 20'000; ++i) {
    const double a = std::fabs(awkward(random));
    const Interval root = square_root(Interval(a));
    ASSERT_LE(Rational(root.lower()) * Rational(std::max(root.lower(), 0.0)), Rational(a)) << std::hexfloat << a;
    ASSERT_GE(Rational(root.upper()) * Rational(root.upper()), Rational(a)) << std::hexfloat << a;
  }
}

TEST(Interval, EnclosesRationals) {
  const Interval third = Interval::around(Rational(1) / Rational(3));
  EXPECT_TRUE(third.contains(Rational(1) / Rational(3)));
  EXPECT_EQ(third.upper(), std::nextafter(third.lower(), 1.0));
  EXPECT_TRUE(Interval::around(Rational(0.1)).is_point());
  EXPECT_EQ(Interval::around(Rational(largest) * Rational(2)), Interval(largest, infinity));
  EXPECT_EQ(Interval::around(-Rational(smallest) / Rational(3)), Interval(-smallest, 0));
}

TEST(Interval, NarrowOnes) {
  EXPECT_TRUE(Interval(0).is_narrow());
  EXPECT_TRUE(Interval(largest).is_narrow());
  for (const double scale : {1.0, 0x1p500, -0x1p-500}) {
    const double far = scale * (1 - 0x1p-47);
    const double farther = scale * (1 - 0x1p-46);
    EXPECT_TRUE(Interval(std::min(scale, far), std::max(scale, far)).is_narrow());
    EXPECT_FALSE(Interval(std::min(scale, farther), std::max(scale, farther)).is_narrow());
  }
  EXPECT_FALSE(Interval(0, smallest).is_narrow());
  EXPECT_FALSE(Interval(largest, infinity).is_narrow());
  EXPECT_FALSE(Interval(-infinity, 1).is_narrow());
  EXPECT_FALSE(Interval::unbounded().is_narrow());
}

TEST(Interval, SignsAndOrder) {
  EXPECT_EQ(Interval(1, 2).sign(), Sign::positive);
  EXPECT_EQ(Interval(-2, -1).sign(), Sign::negative);
  EXPECT_EQ(Interval(0).sign(), Sign::zero);
  EXPECT_EQ(Interval(0, 1).sign(), std::nullopt);
  EXPECT_EQ(compare(Interval(0, 1), Interval(2, 3)), Sign::negative);
  EXPECT_EQ(compare(Interval(2, 3), Interval(0, 1)), Sign::positive);
  EXPECT_EQ(compare(Interval(2), Interval(2)), Sign::zero);
  EXPECT_EQ(compare(Interval(0, 2), Interval(2, 3)), std::nullopt);
}

}  // namespace
}  // namespace quoin
