// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/error_free.h"

#include <gtest/gtest.h>

#include "quoin/number/rational.h"
#include "quoin/number/test_doubles.h"

namespace quoin {
namespace {

using testing::any_finite;
using testing::awkward;
using testing::Random;
using testing::with_exponent;

Rational value_of(const TwoDoubles& sum) {
  return Rational(sum.value) + Rational(sum.tail);
}

TEST(ErrorFree, SumsAndDifferencesAreExactForAllFiniteDoubles) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const double a = i % 2 == 0 ? awkward(random) : any_finite(random);
    const double b = i % 3 == 0
                         ? with_exponent(random, std::ilogb(a == 0 ? 1 : a) / 2, 60 + std::ilogb(a == 0 ? 1 : a) / 2)
                         : awkward(random);
    if (std::fabs(b) == 0x1.fffffffffffffp1023) continue;
    SCOPED_TRACE(::testing::Message() << std::hexfloat << a << " " << b);
    if (std::isfinite(a + b)) {
      ASSERT_EQ(value_of(two_sum(a, b)), Rational(a) + Rational(b));
    }
    if (std::isfinite(a - b)) {
      ASSERT_EQ(value_of(two_difference(a, b)), Rational(a) - Rational(b));
    }
    if (std::isfinite(a + b) && std::fabs(a) >= std::fabs(b)) {
      ASSERT_EQ(value_of(fast_two_sum(a, b)), Rational(a) + Rational(b));
    }
  }
}

TEST(ErrorFree, ProductsAreExactInTheirRange) {
  Random random(2);
  int in_range = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double a = i % 2 == 0 ? awkward(random) : any_finite(random);
    const double b = i % 3 == 0 ? awkward(random) : any_finite(random);
    if (!is_product_exact_range(a, b)) continue;
    ++in_range;
    SCOPED_TRACE(::testing::Message() << std::hexfloat << a << " " << b);
    ASSERT_EQ(value_of(two_product(a, b)), Rational(a) * Rational(b));
  }
  EXPECT_GT(in_range, 20'000);
}

TEST(ErrorFree, ProductsAtTheEndsOfTheRange) {
  const double odd = 0x1.fffffffffffffp0;
  for (const int total : {-959, -960, 1018}) {
    for (int i = std::max(-995, total - 994); i <= std::min(994, total + 1022); i += 7) {
      const double a = std::ldexp(odd, i);
      const double b = std::ldexp(odd, total - i);
      if (!is_product_exact_range(a, b)) continue;
      ASSERT_EQ(value_of(two_product(a, b)), Rational(a) * Rational(b)) << i << " " << total;
    }
  }
  EXPECT_FALSE(is_product_exact_range(0x1p-500, 0x1p-500));
  EXPECT_FALSE(is_product_exact_range(0x1p996, 0x1p-996));
  EXPECT_FALSE(is_product_exact_range(0, 0x1p1023));
  EXPECT_TRUE(is_product_exact_range(0, 0x1p-1074));
}

TEST(ErrorFree, SplitsHaveHalvesOfTwentySixBits) {
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    const double x =
        i % 2 == 0 ? with_exponent(random, -1022, 994) : std::ldexp(static_cast<double>(random() >> 12), -1074);
    const TwoDoubles halves = split(x);
    ASSERT_EQ(value_of(halves), Rational(x)) << std::hexfloat << x;
    for (const double half : {halves.value, halves.tail}) {
      const Integer digits = Rational(half).numerator();
      ASSERT_LE(digits.bit_length() - digits.trailing_zeros(), 26U) << std::hexfloat << x;
    }
  }
}

// (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60: rounded, the last term is lost and the difference of equal products is zero; a
// fused multiply-subtract keeps it in one of the products. The operands are read from memory, so that the compiler
// cannot compute the answer itself.
TEST(ErrorFree, NoMultiplicationIsFusedWithAnAddition) {
  volatile double source = 1 + 0x1p-30;
  const double a = source;
  const double b = source;
  const double c = source;
  const double d = source;
  EXPECT_EQ(a * b - c * d, 0);
  const double square = a * b;
  volatile double stored = square;
  EXPECT_EQ(a * b - stored, 0);
  EXPECT_EQ(a * b + -square, 0);
  EXPECT_EQ(square, 1 + 0x1p-29);
#ifdef FP_FAST_FMA
  GTEST_LOG_(INFO) << "the target has a fused multiply-add: this test sees whether contraction is off";
#endif
}

}  // namespace
}  // namespace quoin
