// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/compact_counts.h"

#include <gtest/gtest.h>

#include <random>

namespace quoin {
namespace {

TEST(CompactCounts, AreZeroAtFirst) {
  const CompactCounts counts(3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(counts[i], 0U);
}

TEST(CompactCounts, KeepTheLargestOfBothWidths) {
  CompactCounts counts(4);
  counts.set(0, 0xFFFF);
  counts.set(1, 7);
  EXPECT_EQ(counts[0], 0xFFFFU);
  counts.set(2, 0x10000);
  counts.set(3, 0xFFFFFFFF);
  EXPECT_EQ(counts[0], 0xFFFFU);
  EXPECT_EQ(counts[1], 7U);
  EXPECT_EQ(counts[2], 0x10000U);
  EXPECT_EQ(counts[3], 0xFFFFFFFFU);
}

TEST(CompactCounts, AreWhatAVectorIs) {
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> expected(100);
  CompactCounts counts(expected.size());
  for (unsigned bits = 1; bits <= 32; ++bits) {
    for (int repeat = 0; repeat < 50; ++repeat) {
      const std::size_t i = random() % expected.size();
      expected[i] = static_cast<std::uint32_t>(random() >> (64 - bits));
      counts.set(i, expected[i]);
    }
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(counts[i], expected[i]) << i << " " << bits;
  }
}

}  // namespace
}  // namespace quoin
