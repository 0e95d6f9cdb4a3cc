// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "quoin/base/test_rounds.h"
#include "quoin/number/rational.h"
#include "quoin/number/two_doubles.h"

namespace quoin {
namespace {

using Random = std::mt19937_64;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t below(Random& random, std::uint64_t end) {
  return random() % end;
}

bool is_even(double x) {
  return (std::bit_cast<std::uint64_t>(x) & 1) == 0;
}

/// By definition: no other double is nearer, and of two as near the even one.
void expect_nearest(const Rational& x, double nearest) {
  if (std::isinf(nearest)) {
    const Rational limit = Rational(std::numeric_limits<double>::max()) + Rational(std::ldexp(1.0, 970));
    ASSERT_TRUE(nearest > 0 ? x >= limit : x <= -limit) << x.to_string();
    return;
  }
  const Rational error = abs(x - Rational(nearest));
  for (const double other : {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)}) {
    if (std::isinf(other)) continue;
    const Rational of_other = abs(x - Rational(other));
    ASSERT_TRUE(error < of_other || (error == of_other && is_even(nearest))) << x.to_string();
  }
}

void expect_two_doubles(const Rational& x) {
  const double nearest = x.to_double();
  const std::optional<TwoDoubles> parts = as_two_doubles(x);
  if (parts) {
    ASSERT_EQ(parts->value, nearest) << x.to_string();
    ASSERT_EQ(Rational(parts->value) + Rational(parts->tail), x);
    return;
  }
  if (std::isinf(nearest)) return;
  const Rational rest = x - Rational(nearest);
  const double tail = rest.to_double();
  ASSERT_TRUE(std::isinf(tail) || Rational(tail) != rest) << x.to_string();
}

/// Of up to `bits` bits, with long runs of equal bits, so that many are near halves of units.
Integer integer_of(Random& random, std::size_t bits) {
  Integer result(0);
  for (std::size_t have = 0; have < bits;) {
    const std::size_t run = 1 + below(random, 40);
    result <<= run;
    if (below(random, 2) == 0) result += (Integer(1) << run) - Integer(1);
    if (below(random, 3) == 0) result += Integer(static_cast<std::int64_t>(below(random, 2)));
    have += run;
  }
  return below(random, 2) == 0 ? result : -result;
}

TEST(RationalRounding, NearestOfPowersAsDenominators) {
  Random random(1);
  for (int round = 0; round < test_rounds(20000); ++round) {
    const Integer p = integer_of(random, 1 + below(random, 250));
    const Integer q = Integer(1) << below(random, below(random, 8) == 0 ? 1300 : 200);
    const Rational x(below(random, 16) == 0 ? p << 900 : p, q);
    expect_nearest(x, x.to_double());
    expect_two_doubles(x);
  }
}

TEST(RationalRounding, NearestOfAnyQuotients) {
  Random random(2);
  for (int round = 0; round < test_rounds(5000); ++round) {
    const Integer q = integer_of(random, 1 + below(random, 150));
    if (q.sign() == Sign::zero) continue;
    const Rational x(integer_of(random, 1 + below(random, 150)), q);
    expect_nearest(x, x.to_double());
    expect_two_doubles(x);
  }
}

TEST(RationalRounding, SumsOfTwoDoubles) {
  Random random(3);
  for (int round = 0; round < test_rounds(20000); ++round) {
    const auto any = [&] {
      const double mantissa = static_cast<double>(static_cast<std::int64_t>(random()) >> below(random, 60));
      return std::ldexp(mantissa,
                        static_cast<int>(below(random, 8) == 0 ? below(random, 1900) : below(random, 80)) - 1000);
    };
    const double a = any();
    const double b = any();
    const Rational x = Rational(a) + Rational(b);
    const TwoDoubles sum = two_sum(a, b);
    const std::optional<TwoDoubles> parts = as_two_doubles(x);
    ASSERT_TRUE(parts.has_value());
    ASSERT_EQ(parts->value, sum.value);
    ASSERT_EQ(parts->tail, sum.tail);
  }
}

TEST(RationalRounding, KnownEnds) {
  const Rational least(std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(least.to_double(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ((least / Rational(2)).to_double(), 0);
  EXPECT_EQ((least * Rational(3) / Rational(4)).to_double(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ((Rational(std::numeric_limits<double>::max()) * Rational(2)).to_double(), infinity);
  EXPECT_FALSE(as_two_doubles(Rational(std::numeric_limits<double>::max()) * Rational(2)).has_value());
  EXPECT_FALSE(as_two_doubles(Rational(Integer(1), Integer(3))).has_value());
  EXPECT_FALSE(as_two_doubles(least / Rational(2)).has_value());
}

}  // namespace
}  // namespace quoin
