// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/block_writer.h"

#include <gtest/gtest.h>

#include <sstream>
#include <streambuf>

#include "quoin/base/error.h"

namespace quoin::io {
namespace {

/// Takes so many characters, then throws, as a buffer that polls does.
class BufferThatIsCancelled : public std::streambuf {
 public:
  explicit BufferThatIsCancelled(std::size_t most) : left_(most) {}

 protected:
  int_type overflow(int_type c) override {
    if (left_ == 0) throw Cancelled("cancelled");
    --left_;
    return traits_type::not_eof(c);
  }

 private:
  std::size_t left_;
};

TEST(BlockWriter, HandsOnAllThatWasWritten) {
  std::ostringstream out;
  const Context context;
  BlockWriter writer(out, context);
  std::string expected;
  for (std::size_t i = 0; i < 40'000; ++i) {
    writer.number(i).text(" ");
    expected += std::to_string(i) + " ";
  }
  writer.finish();
  EXPECT_EQ(out.str(), expected);
}

TEST(BlockWriter, LeavesAlthoughTheStreamThrowsToo) {
  for (const std::size_t most : {0, 1, 65536, 70'000}) {
    for (const std::uint64_t polls : {0, 1, 2, 1000}) {
      BufferThatIsCancelled buffer(most);
      std::ostream out(&buffer);
      out.exceptions(std::ios::badbit);
      const Context context({.threads = 1, .most_polls = polls});
      const auto write = [&] {
        BlockWriter writer(out, context);
        for (std::size_t i = 0; i < 40'000; ++i) writer.number(i).text(" ");
        writer.finish();
      };
      EXPECT_THROW(write(), Cancelled) << most << " characters, " << polls << " polls";
    }
  }
}

}  // namespace
}  // namespace quoin::io
