// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "quoin/base/error.h"

namespace quoin {
namespace {

TEST(Parallel, EveryChunkRunsOnceOrTheLoopThrows) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    const Context context({.threads = threads});
    std::vector<std::atomic<int>> seen(1000);
    for_each_chunk(context, seen.size(), 7, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++seen[i];
    });
    for (const auto& count : seen) EXPECT_EQ(count, 1);
    EXPECT_THROW(for_each_chunk(context, 100, 1,
                                [](const Chunk& chunk) {
                                  if (chunk.index == 50) throw std::runtime_error("chunk 50");
                                }),
                 std::runtime_error);
  }
}

// What runs beside a task that throws must not take an unfinished loop of its own for a finished one.
TEST(Parallel, LoopsBesideATaskThatThrowsAreWhole) {
  const Context context({.threads = 2});
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::atomic<bool> was_cut_short{false};
    const auto fail = [&] {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      throw InputError("no");
    };
    const auto loop = [&] {
      std::atomic<std::size_t> done{0};
      for_each_chunk(context, 64, 1, [&](const Chunk&) {
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        ++done;
      });
      if (done != 64) was_cut_short = true;
    };
    EXPECT_THROW(run_both(context, fail, loop), InputError);
    EXPECT_THROW(run_both(context, loop, fail), InputError);
    EXPECT_FALSE(was_cut_short) << "repeat " << repeat;
  }
}

TEST(Parallel, CancellationStopsNestedLoops) {
  for (const unsigned threads : {1U, 2U}) {
    Context context({.threads = threads});
    std::atomic<std::size_t> done{0};
    const auto loop = [&] {
      for_each_chunk(context, 100000, 1, [&](const Chunk&) {
        if (++done == 100) context.cancel();
      });
    };
    EXPECT_THROW(run_both(context, loop, loop), Cancelled);
    EXPECT_LT(done, 1000U);
  }
}

}  // namespace
}  // namespace quoin
