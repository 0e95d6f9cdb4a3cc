// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_numbers.h"

#include <gtest/gtest.h>

#include <random>

#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

// Doubles, rationals that are doubles, rationals that are none, runs of these, places without a number.
TEST(ExactNumbers, AreWhatAListOfRationalsIs) {
  std::mt19937 random(3);
  for (int round = 0; round < test_rounds(200); ++round) {
    ExactNumbers numbers;
    std::vector<std::optional<Rational>> plain;
    for (int i = 0; i < 30; ++i) {
      const Rational fraction = Rational(static_cast<int>(random() % 5)) / Rational(static_cast<int>(1 + random() % 3));
      const double value = static_cast<double>(random() % 4) / 8;
      switch (random() % 4) {
        case 0:
          numbers.add(value);
          plain.emplace_back(value);
          break;
        case 1:
          numbers.add_none();
          plain.emplace_back();
          break;
        default:
          numbers.add(fraction);
          plain.emplace_back(fraction);
      }
    }
    ASSERT_EQ(numbers.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_EQ(numbers.is_none(i), !plain[i]);
      if (!plain[i]) {
        EXPECT_EQ(numbers.word(i), "-");
        continue;
      }
      EXPECT_EQ(numbers.exact(i), *plain[i]);
      EXPECT_EQ(numbers.rounded(i), plain[i]->to_double());
      EXPECT_EQ(io::parse_exact(numbers.word(i)).rational(), *plain[i]);
    }
  }
}

TEST(ExactNumbers, GradesAreRanks) {
  ExactNumbers numbers;
  const Rational third = Rational(1) / Rational(3);
  for (const Rational& value : {Rational(2), third, third, Rational(-1), Rational(2), third}) numbers.add(value);
  const Grades<Rational> grades = numbers.grades();
  EXPECT_EQ(grades.grade, (std::vector<std::uint32_t>{2, 1, 1, 0, 2, 1}));
  EXPECT_EQ(grades.values, (std::vector<Rational>{Rational(-1), third, Rational(2)}));
}

TEST(ExactNumbers, BeyondTheLargestDouble) {
  ExactNumbers numbers;
  const Rational huge = Rational(1e300) * Rational(1e300);
  numbers.add(huge);
  numbers.add(-0.0);
  EXPECT_FALSE(numbers.is_none(0));
  EXPECT_EQ(numbers.exact(0), huge);
  EXPECT_TRUE(std::isinf(numbers.rounded(0)));
  EXPECT_EQ(numbers.word(1), "0");
}

}  // namespace
}  // namespace quoin
