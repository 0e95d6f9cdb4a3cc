// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_area.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "quoin/arrangement/sets/test_sets.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

const Context context;

using testing::set_of;

// Coordinates of all magnitudes, rings that cross; the oracle is the exact area.
TEST(RoundedArea, IsThatOfTheExactArea) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 200; ++round) {
      const int spread = std::array{0, 3, 50, 160}[random() % 4];
      const auto coordinate = [&] {
        const double mantissa = round % 2 == 0 ? double(random() % 9) - 4 : double(random() % 1000003) / 1000003 - 0.5;
        return std::ldexp(mantissa, spread == 0 ? 0 : int(random() % (2 * spread + 1)) - spread);
      };
      std::vector<std::vector<Point2>> rings(1 + random() % 3);
      for (auto& ring : rings) {
        while (ring.size() < 3 + static_cast<std::size_t>(round % 5)) {
          const Point2 p{coordinate(), coordinate()};
          if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
        }
      }
      const LinearPolygonSet set = set_of(rings, FillRule::even_odd);
      EXPECT_EQ(rounded_area(set), area(set).to_double()) << "seed " << seed << " round " << round;
    }
  }
}

TEST(RoundedArea, Extremes) {
  EXPECT_EQ(rounded_area(LinearPolygonSet()), 0);
  const auto square = [](double size) {
    return set_of({{{0, 0}, {size, 0}, {size, size}, {0, size}}}, FillRule::even_odd);
  };
  EXPECT_EQ(rounded_area(square(1e200)), HUGE_VAL);
  EXPECT_EQ(rounded_area(square(5e-324)), 0);
  EXPECT_EQ(rounded_area(square(0x1p-537)), 0x1p-1074);
  // Halfway between two doubles: 1 + 2^-53, to even.
  EXPECT_EQ(rounded_area(set_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{2, 0}, {3, 0}, {3, 0x1p-53}, {2, 0x1p-53}}},
                                FillRule::even_odd)),
            1);
  EXPECT_THROW(rounded_area(square(1).complement()), InputError);
}

}  // namespace
}  // namespace quoin
