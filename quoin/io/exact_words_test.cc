// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_words.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "quoin/base/error.h"

namespace quoin {
namespace {

TEST(ExactWords, NumbersReadBack) {
  std::mt19937 random(3);
  const auto check = [](double value) {
    const io::ExactNumber back = io::parse_exact(io::exact_word(value));
    ASSERT_TRUE(back.value.has_value()) << io::exact_word(value);
    ASSERT_EQ(*back.value, value) << io::exact_word(value);
  };
  for (const double value : {0.0, -0.0, 1.0, -1.0, 0.1, 1e15, 1e16, 0x1p53, 0x1p53 + 2, 0x1p60, 1e22,
                             123456789012345680000.0, 0x1p1023, 5e-324, -1e-310}) {
    check(value);
  }
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>((static_cast<std::uint64_t>(random()) << 32) | random());
    if (std::isfinite(value)) check(value);
  }
  for (int i = 0; i < 5000; ++i) {
    Integer p(static_cast<int>(random() % 2000) - 1000);
    for (auto k = random() % 5; k > 0; --k) p = p * Integer(static_cast<int>(random() % 100000) + 1);
    const Rational value(p, Integer(1 + static_cast<int>(random() % 40)));
    ASSERT_EQ(io::parse_exact(io::exact_word(value)).rational(), value) << value.to_string();
  }
  EXPECT_EQ(io::exact_word(Rational(Integer(1), Integer(3))), "1/3");
  EXPECT_EQ(io::exact_word(Rational(Integer(1), Integer(4))), "0.25");
  for (const char* word :
       {"", "nan", "inf", "1/0", "1e999", "1/", "--1", "1.5/2", "0x10", "1e", "99999999999999999x"}) {
    EXPECT_THROW(io::parse_exact(word), InputError) << word;
  }
}

}  // namespace
}  // namespace quoin
