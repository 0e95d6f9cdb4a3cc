// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/value_stops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

std::uint32_t below(std::mt19937& random, std::uint32_t end) {
  return static_cast<std::uint32_t>(random() % end);
}

TEST(ValueStops, EachGradeEntersWithTheFirstStopThatIsNotBefore) {
  std::mt19937 random(1);
  for (int round = 0; round < test_rounds(200); ++round) {
    const std::uint32_t grades = below(random, 60);
    const std::uint32_t most = below(random, 30);
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t i = 0; i < below(random, 4); ++i) wanted.push_back(below(random, 70));
    const ValueStops stops(grades, most, wanted);
    ASSERT_LE(stops.count(), std::max<std::size_t>(most, most + 1 + wanted.size()));
    if (grades <= most) {
      ASSERT_EQ(stops.count(), grades);
    }
    for (std::uint32_t s = 1; s < stops.count(); ++s) ASSERT_LT(stops.grade(s - 1), stops.grade(s));
    for (std::uint32_t g = 0; g < grades; ++g) {
      const std::uint32_t stop = stops.of(g);
      ASSERT_LT(stop, stops.count());
      ASSERT_GE(stops.grade(stop), g);
      if (stop > 0) {
        ASSERT_LT(stops.grade(stop - 1), g);
      }
      if (std::ranges::count(wanted, g) > 0) {
        ASSERT_EQ(stops.grade(stop), g);
      }
    }
    if (grades > 0) {
      ASSERT_EQ(stops.grade(stops.count() - 1), grades - 1);
    }
  }
}

TEST(ValueStops, AreSpreadEvenly) {
  const ValueStops stops(1'000'000, 1000);
  EXPECT_EQ(stops.count(), 1001U);
  for (std::uint32_t s = 1; s < stops.count(); ++s) EXPECT_LE(stops.grade(s) - stops.grade(s - 1), 1000U);
}

}  // namespace
}  // namespace quoin
