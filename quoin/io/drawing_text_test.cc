// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/drawing_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "quoin/io/text_lines.h"
#include "quoin/number/test_doubles.h"

namespace quoin::io {
namespace {

using quoin::testing::Random;

TEST(DrawingText, RunningSumsAreTheNearestDoublesOfExactSums) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    RunningSum sum;
    Rational exact;
    for (int k = 0; k < 12; ++k) {
      const double value = i % 3 == 0   ? quoin::testing::with_exponent(random, -900, 900)
                           : i % 3 == 1 ? quoin::testing::with_exponent(random, -30, 30)
                                        : quoin::testing::small_integer(random, 9) / 10;
      exact += Rational(value);
      sum.add(value);
      ASSERT_EQ(sum.value(), exact.to_double()) << i << " " << k;
      const Rational error = abs(exact - Rational(sum.value()));
      ASSERT_GE(Rational(sum.error()), error);
      ASSERT_EQ(sum.error() == 0, error.sign() == Sign::zero);
    }
  }
}

TEST(DrawingText, RunningSumsOverflowToInfinity) {
  RunningSum sum;
  sum.set(1.7976931348623157e308);
  sum.add(1.7976931348623157e308);
  EXPECT_TRUE(std::isinf(sum.value()));
}

TEST(DrawingText, LengthsOfNumbers) {
  for (const char* number : {"1", "-1", "+1.5", ".5", "1.", "1e5", "1E-05", "-.5e+3"})
    EXPECT_EQ(number_length(std::string(number) + "x"), std::string(number).size()) << number;
  EXPECT_EQ(number_length("1.5.5"), 3U);
  EXPECT_EQ(number_length("1e"), 1U);
  EXPECT_EQ(number_length("1-1"), 1U);
  for (const char* none : {"", "-", ".", "e5", "inf", "nan", "-.e1", "x1"}) EXPECT_EQ(number_length(none), 0U) << none;
}

TEST(DrawingText, NumbersOutOfRangeAreTooSmallOrTooLargeByTheirSize) {
  const std::string zeros(400, '0');
  const auto value = [](const std::string& word) {
    double number = -1;
    return parse_number(word, number) ? number : HUGE_VAL;
  };
  EXPECT_EQ(value("1e-400"), 0);
  EXPECT_EQ(value("-1e-400"), 0);
  EXPECT_EQ(value("0." + zeros + "1"), 0);
  EXPECT_EQ(value("1" + zeros), HUGE_VAL);
  EXPECT_EQ(value("1" + zeros + "e-10"), HUGE_VAL);
  EXPECT_EQ(value("0." + zeros + "1e10"), 0);
  EXPECT_EQ(value("1e-99999999999999999999"), 0);
  EXPECT_EQ(value("1e99999999999999999999"), HUGE_VAL);
  EXPECT_EQ(value("1e-9223372036854775808"), 0);
  EXPECT_EQ(value("1e+400"), HUGE_VAL);
}

TEST(DrawingText, UpperDecimalsAreNotBelow) {
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::fabs(quoin::testing::with_exponent(random, -1070, 1000));
    EXPECT_GE(std::stod(upper_decimals(value)), value);
    if (value > 1e-300) {
      EXPECT_LE(std::stod(upper_decimals(value)), value * 1.016);
    }
  }
}

TEST(DrawingText, LinesEndInThreeWays) {
  EXPECT_EQ(line_of("a\nb\r\nc\rd", 0), 1U);
  EXPECT_EQ(line_of("a\nb\r\nc\rd", 2), 2U);
  EXPECT_EQ(line_of("a\nb\r\nc\rd", 5), 3U);
  EXPECT_EQ(line_of("a\nb\r\nc\rd", 7), 4U);
}

}  // namespace
}  // namespace quoin::io
