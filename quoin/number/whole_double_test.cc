// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/whole_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "quoin/base/test_rounds.h"
#include "quoin/number/rational.h"

namespace quoin {
namespace {

TEST(WholeDouble, IsTheIntegerThatItIs) {
  std::mt19937_64 random(6);
  for (int round = 0; round < test_rounds(20000); ++round) {
    const int exponent = static_cast<int>(random() % 128);
    const double x = std::trunc(std::ldexp(static_cast<double>(random() >> 11), exponent - 54));
    for (const double signed_x : {x, -x})
      ASSERT_EQ(Rational(to_integer(from_whole_double(signed_x))), Rational(signed_x)) << x;
  }
  for (const double x : {0.0, -0.0, 1.0, -1.0, 0x1p52, 0x1p53, 0x1p64, -0x1p64, 0x1p126, -0x1.fffffffffffffp126})
    EXPECT_EQ(Rational(to_integer(from_whole_double(x))), Rational(x));
}

}  // namespace
}  // namespace quoin
