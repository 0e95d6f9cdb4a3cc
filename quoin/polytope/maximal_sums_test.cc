// SPDX-License-Identifier: Apache-2.0
//
// The largest sums, of which the numbers of all cells are published.
#include "quoin/polytope/maximal_sums.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_sums.h"

namespace quoin {
namespace {

using namespace test_polytopes;
using Sizes = std::vector<std::size_t>;

/// Every summand has its number of facets, and the sum is of solids.
Counts check_maximal(const Sizes& sizes) {
  const std::vector<Polytope> summands = maximal_summands(sizes, one_thread);
  EXPECT_EQ(summands.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(summands[i].dimension(), 3);
    EXPECT_EQ(summands[i].facet_count(), sizes[i]);
    EXPECT_EQ(summands[i].vertex_count(), 2 * sizes[i] - 4);  // simple
  }
  const PolytopeSumOfMany sum = minkowski_sum(summands, one_thread);
  EXPECT_EQ(sum.facet_count(), most_facets_of_sum(sizes));
  EXPECT_EQ(sum.vertex_count() + sum.facet_count(), sum.edge_count() + 2);
  return {sum.vertex_count(), sum.edge_count(), sum.facet_count()};
}

// Minkowski thesis, section 4 and the table of known maxima.
TEST(MaximalSums, OfTwo) {
  EXPECT_EQ(check_maximal({4, 4}), (Counts{16, 32, 18}));
  EXPECT_EQ(check_maximal({4, 5}), (Counts{24, 47, 25}));
  EXPECT_EQ(check_maximal({5, 5}), (Counts{36, 70, 36}));
  EXPECT_EQ(check_maximal({5, 6}), (Counts{48, 93, 47}));
  EXPECT_EQ(check_maximal({6, 6}), (Counts{64, 124, 62}));
  EXPECT_EQ(check_maximal({7, 8}), (Counts{120, 233, 115}));
  EXPECT_EQ(check_maximal({4, 11}), (Counts{72, 137, 67}));
  EXPECT_EQ(check_maximal({10, 10}).facets, 246U);
  EXPECT_EQ(check_maximal({11, 11}), (Counts{324, 634, 312}));
  EXPECT_EQ(check_maximal({20, 20}), (Counts{1296, 2560, 1266}));
}

TEST(MaximalSums, OfThreeAndFour) {
  EXPECT_EQ(check_maximal({4, 4, 4}).facets, 42U);
  EXPECT_EQ(check_maximal({4, 5, 7}).facets, 106U);
  EXPECT_EQ(check_maximal({5, 7, 5}).facets, 135U);
  EXPECT_EQ(check_maximal({4, 4, 4, 4}).facets, 76U);
}

TEST(MaximalSums, OfNoneOneAndLargeOnes) {
  EXPECT_EQ(most_facets_of_sum(Sizes{}), 0U);
  EXPECT_TRUE(maximal_summands(Sizes{}, one_thread).empty());
  EXPECT_EQ(check_maximal({9}).facets, 9U);
  EXPECT_EQ(check_maximal({101, 101}).facets, 39012U);
  EXPECT_THROW(most_facets_of_sum(Sizes{4, 3}), InputError);
  EXPECT_THROW(maximal_summands(Sizes{3}, one_thread), InputError);
}

}  // namespace
}  // namespace quoin
