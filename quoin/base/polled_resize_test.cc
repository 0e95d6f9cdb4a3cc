// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/polled_resize.h"

#include <gtest/gtest.h>

#include <vector>

#include "quoin/base/error.h"

namespace quoin {
namespace {

TEST(PolledResize, MakesWhatResizeMakes) {
  const Context context;
  for (const std::size_t size : {0, 1, 3, 4'194'304, 5'000'000}) {
    std::vector<unsigned char> list{7, 8};
    std::vector<unsigned char> expected = list;
    resize_and_poll(list, size, context, 9);
    if (size > expected.size()) expected.resize(size, 9);
    EXPECT_TRUE(list == expected) << size;
  }
}

TEST(PolledResize, IsCancelledWithinMegabytes) {
  constexpr std::size_t most = std::size_t{1} << 23;  // bytes between two polls
  std::vector<double> list;
  const Context counting({.threads = 1, .most_polls = 1000});
  resize_and_poll(list, std::size_t{1} << 22, counting);
  EXPECT_GE(counting.polls() * most, list.size() * sizeof(double));
  list.clear();
  EXPECT_THROW(resize_and_poll(list, std::size_t{1} << 22, Context({.threads = 1, .most_polls = 1})), Cancelled);
  EXPECT_LE(list.size() * sizeof(double), most);
}

}  // namespace
}  // namespace quoin
