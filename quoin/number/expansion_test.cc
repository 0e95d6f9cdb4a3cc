// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/expansion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "quoin/number/rational.h"
#include "quoin/number/test_doubles.h"

namespace quoin {
namespace {

using testing::Random;
using testing::small_integer;
using testing::with_exponent;

template <std::size_t N>
Rational value_of(const Expansion<N>& e) {
  Rational sum;
  for (const double part : e.parts()) sum += Rational(part);
  return sum;
}

// Components are ordered, not zero, and none reaches into the bits of the next.
template <std::size_t N>
void expect_nonoverlapping(const Expansion<N>& e) {
  for (std::size_t i = 0; i < e.parts().size(); ++i) {
    ASSERT_NE(e.parts()[i], 0);
    if (i == 0) continue;
    const Rational large(e.parts()[i]);
    const int low_bit =
        static_cast<int>(large.numerator().trailing_zeros()) - static_cast<int>(large.denominator().trailing_zeros());
    ASSERT_LT(std::ilogb(e.parts()[i - 1]), low_bit);
  }
}

double factor(Random& random, int family) {
  switch (family % 4) {
    case 0:
      return with_exponent(random, -200, 199);
    case 1:
      return with_exponent(random, -3, 3);
    case 2:
      return small_integer(random, 3);
    default:
      return 1 + std::ldexp(small_integer(random, 4), -52);
  }
}

TEST(Expansion, SumsAndProductsOfThreeFactorsAreExact) {
  Random random(4);
  for (int i = 0; i < 40'000; ++i) {
    const double a = factor(random, i);
    const double b = factor(random, i / 4);
    const double c = factor(random, i);
    const double d = factor(random, i / 4);
    const double e = factor(random, i / 16);
    SCOPED_TRACE(::testing::Message() << std::hexfloat << a << " " << b << " " << c << " " << d << " " << e);
    const auto minor = exact_product(a, d) - exact_product(b, c);
    const Rational expected = Rational(a) * Rational(d) - Rational(b) * Rational(c);
    ASSERT_EQ(value_of(minor), expected);
    ASSERT_EQ(minor.sign(), expected.sign());
    expect_nonoverlapping(minor);
    const auto scaled = minor * e;
    ASSERT_EQ(value_of(scaled), expected * Rational(e));
    expect_nonoverlapping(scaled);
    const auto product = exact_difference(a, b) * exact_sum(c, d) + scaled;
    ASSERT_EQ(value_of(product), (Rational(a) - Rational(b)) * (Rational(c) + Rational(d)) + expected * Rational(e));
    expect_nonoverlapping(product);
    const Rational off = abs(Rational(product.estimate()) - value_of(product));
    ASSERT_LE(off, abs(value_of(product)) * Rational(0x1p-51));
  }
}

TEST(Expansion, CancelsToZero) {
  const auto a = exact_product(0x1.23456789abcdep3, 0x1.fedcba9876543p-7);
  const auto zero = a - a;
  EXPECT_TRUE(zero.parts().empty());
  EXPECT_EQ(zero.sign(), Sign::zero);
  EXPECT_EQ((zero * 3.0).sign(), Sign::zero);
  EXPECT_EQ((zero * a).sign(), Sign::zero);
  EXPECT_EQ((zero + a).sign(), Sign::positive);
  EXPECT_EQ((zero - a).sign(), Sign::negative);
  EXPECT_EQ(Expansion<1>(0.0).sign(), Sign::zero);
}

TEST(Expansion, SumsStayExactAtTheEndsOfTheRange) {
  const auto sum = exact_sum(0x1p1023, 0x1p-1074) + exact_sum(-0x1p1023, 0x1p-1074);
  EXPECT_EQ(value_of(sum), Rational(0x1p-1073));
}

}  // namespace
}  // namespace quoin
