// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/smith_form.h"

#include <gtest/gtest.h>

#include <numeric>

#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

TEST(SmithForm, DivisorsAreQuotientsOfCommonDivisorsOfMinors) {
  std::mt19937_64 random(21);
  for (int round = 0; round < test_rounds(300); ++round) {
    SCOPED_TRACE(round);
    const std::size_t rows = 1 + random() % 3;
    const std::size_t columns = 1 + random() % 3;
    IntegerMatrix matrix(rows, std::vector<Integer>(columns));
    const std::int64_t size = round % 3 == 0 ? 2 : round % 3 == 1 ? 12 : 1000;
    for (auto& row : matrix)
      for (Integer& x : row) x = Integer(static_cast<std::int64_t>(random() % (2 * size + 1)) - size);
    const std::vector<Integer> divisors = elementary_divisors(matrix, Context());
    Integer product(1);
    for (std::size_t k = 1; k <= std::min(rows, columns); ++k) {
      Integer common(0);
      for (std::uint32_t r = 0; r < 1U << rows; ++r) {
        for (std::uint32_t c = 0; c < 1U << columns; ++c) {
          std::vector<std::size_t> of_rows;
          std::vector<std::size_t> of_columns;
          for (std::size_t i = 0; i < rows; ++i)
            if ((r >> i & 1) != 0) of_rows.push_back(i);
          for (std::size_t j = 0; j < columns; ++j)
            if ((c >> j & 1) != 0) of_columns.push_back(j);
          if (of_rows.size() != k || of_columns.size() != k) continue;
          Integer determinant(0);
          std::vector<std::size_t> order(k);
          std::iota(order.begin(), order.end(), 0U);
          do {
            Integer term(1);
            for (std::size_t i = 0; i < k; ++i) {
              term *= matrix[of_rows[i]][of_columns[order[i]]];
              for (std::size_t j = i + 1; j < k; ++j)
                if (order[i] > order[j]) term = -term;
            }
            determinant += term;
          } while (std::next_permutation(order.begin(), order.end()));
          common = greatest_common_divisor(common, determinant);
        }
      }
      if (common == Integer(0)) {
        ASSERT_EQ(divisors.size(), k - 1);
        break;
      }
      ASSERT_GE(divisors.size(), k);
      product *= divisors[k - 1];
      ASSERT_EQ(product, common);
    }
  }
}

TEST(SmithForm, HiddenDiagonals) {
  // A diagonal behind random row and column operations, with entries of any size.
  std::mt19937_64 random(22);
  for (int round = 0; round < test_rounds(20); ++round) {
    SCOPED_TRACE(round);
    const std::size_t n = 8;
    std::vector<Integer> expected{1, 1, 2, 6, 12, Integer(12) << 80};
    IntegerMatrix matrix(n, std::vector<Integer>(n));
    for (std::size_t i = 0; i < expected.size(); ++i) matrix[i][i] = expected[i];
    for (int step = 0; step < 60; ++step) {
      const std::size_t i = random() % n;
      const std::size_t j = (i + 1 + random() % (n - 1)) % n;
      const Integer f(static_cast<std::int64_t>(random() % 7) - 3);
      for (std::size_t l = 0; l < n; ++l) {
        if (step % 2 == 0) matrix[i][l] += f * matrix[j][l];
        if (step % 2 != 0) matrix[l][i] += f * matrix[l][j];
      }
    }
    ASSERT_EQ(elementary_divisors(matrix, Context()), expected);
  }
  EXPECT_TRUE(elementary_divisors({}, Context()).empty());
  EXPECT_TRUE(elementary_divisors(IntegerMatrix(2, std::vector<Integer>(3)), Context()).empty());
}

}  // namespace
}  // namespace quoin
