// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/simplex_text.h"

#include <gtest/gtest.h>

#include "quoin/base/error.h"

namespace quoin {
namespace {

std::string refusal_of(const std::string& text, bool has_values) {
  try {
    if (has_values) {
      read_filtration(text, "x.txt", Context());
    } else {
      read_simplices(text, "x.txt", Context());
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(SimplexText, LinesAreSimplices) {
  const SimplexList list = read_simplices("\xEF\xBB\xBF# a triangle\r\n2 0 1  # and\n\n 7\r\n", "x.txt", Context());
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(std::vector<std::uint32_t>(list[0].begin(), list[0].end()), (std::vector<std::uint32_t>{2, 0, 1}));
  EXPECT_EQ(list[1][0], 7U);
}

TEST(SimplexText, ValuesAreExact) {
  const FiltrationText text =
      read_filtration("1/3 0\n0.5 1\n2/6 2\n12345678901234567891 0 1\n-1e-3 3\n", "x.txt", Context());
  EXPECT_EQ(text.grades, (std::vector<std::uint32_t>{1, 2, 1, 3, 0}));
  ASSERT_EQ(text.values.size(), 4U);
  EXPECT_EQ(text.values[0], Rational(-1e-3));
  EXPECT_EQ(text.values[1], Rational(Integer(1), Integer(3)));
  EXPECT_EQ(text.values[3].to_string(), "12345678901234567891");
  const FiltrationText doubles = read_filtration("0 0\n-0.0 1\n1e-300 0 1\n", "x.txt", Context());
  EXPECT_EQ(doubles.grades, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(SimplexText, RefusalsNameTheLine) {
  EXPECT_NE(refusal_of("0 1\n0 x\n", false).find("x.txt:2: 'x' is not the number of a vertex"), std::string::npos);
  EXPECT_NE(refusal_of("0 1\n\n-1\n", false).find("x.txt:3"), std::string::npos);
  EXPECT_NE(refusal_of("4294967295\n", false).find("x.txt:1"), std::string::npos);
  EXPECT_NE(refusal_of("99999999999999999999\n", false).find("x.txt:1"), std::string::npos);
  EXPECT_NE(refusal_of("0 1 0\n", false).find("vertex 0 stands here twice"), std::string::npos);
  EXPECT_NE(refusal_of("1.5\n", false).find("x.txt:1"), std::string::npos);
  EXPECT_NE(refusal_of("0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20\n", false).find("21 vertices"),
            std::string::npos);
  for (const bool has_values : {false, true})
    EXPECT_NE(refusal_of("# none\n", has_values).find("no simplex"), std::string::npos);
  for (const char* value : {"nan", "inf", "1e999", "1/0", "x", "--1", "1/2/3"})
    EXPECT_NE(refusal_of(std::string(value) + " 0\n", true).find("x.txt:1: "), std::string::npos) << value;
  EXPECT_NE(refusal_of("3\n", true).find("x.txt:1: a simplex needs a vertex"), std::string::npos);
}

TEST(SimplexText, IsToldByItsFirstWord) {
  EXPECT_TRUE(begins_like_simplices("# of\n 12 3"));
  EXPECT_FALSE(begins_like_simplices("OFF\n1 2 3"));
  EXPECT_FALSE(begins_like_simplices("# nothing\n"));
  EXPECT_FALSE(begins_like_simplices("v 1 2 3"));
  EXPECT_FALSE(begins_like_simplices("-1 2"));
}

}  // namespace
}  // namespace quoin
