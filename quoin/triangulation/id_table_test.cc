// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/id_table.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/number/test_doubles.h"

namespace quoin {
namespace {

/// Ids stand for numbers, whose hashes are often equal or next to each other, and at the end of the table.
TEST(IdTable, FindsWhatIsThere) {
  testing::Random random(1);
  for (const std::uint64_t hashes : {1U, 3U, 17U, 1000U}) {
    const auto hash_of = [hashes](std::uint32_t id) { return std::uint64_t{0} - id % hashes; };
    IdTable table;
    std::map<std::uint32_t, bool> there;
    EXPECT_EQ(table.find(hash_of(5), [](std::uint32_t) { return true; }), IdTable::none);
    for (int step = 0; step < test_rounds(4000); ++step) {
      const auto id = static_cast<std::uint32_t>(random() % 100);
      const auto is_it = [id](std::uint32_t other) { return other == id; };
      ASSERT_EQ(table.find(hash_of(id), is_it), there[id] ? id : IdTable::none);
      if (there[id]) {
        table.take(id, hash_of);
      } else {
        table.reserve_one(hash_of);
        table.put(id, hash_of(id));
      }
      there[id] = !there[id];
    }
    for (std::uint32_t id = 0; id < 100; ++id) {
      const auto is_it = [id](std::uint32_t other) { return other == id; };
      ASSERT_EQ(table.find(hash_of(id), is_it), there[id] ? id : IdTable::none);
    }
  }
}

}  // namespace
}  // namespace quoin
