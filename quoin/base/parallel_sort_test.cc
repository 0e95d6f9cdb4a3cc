// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/parallel_sort.h"

#include <gtest/gtest.h>

#include <random>

namespace quoin {
namespace {

TEST(ParallelSort, IsTheSameOnAnyNumberOfThreads) {
  std::mt19937_64 random(5);
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}, sort_grain - 1, sort_grain,
                                  sort_grain + 1, std::size_t{100003}}) {
    for (const std::uint64_t range : {1U, 2U, 1000U, 1U << 31U}) {
      std::vector<std::uint64_t> list(count);
      for (std::uint64_t& x : list) x = random() % range;
      std::vector<std::vector<std::uint64_t>> inputs{list};
      std::sort(list.begin(), list.end());
      inputs.push_back(list);
      inputs.emplace_back(list.rbegin(), list.rend());
      for (const unsigned threads : {1U, 2U, 4U}) {
        const Context context({.threads = threads});
        for (std::vector<std::uint64_t> input : inputs) {
          sort_parallel(context, input);
          ASSERT_EQ(input, list) << count << " below " << range << " on " << threads;
        }
      }
    }
  }
}

}  // namespace
}  // namespace quoin
