// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/occupancy_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace quoin {
namespace {

// Thin boxes near a plane through the middle of [-scale, scale]^3, as rounded triangles lie about a curve of contact,
// or anywhere.
FloatBox random_box(std::mt19937_64& random, float scale, bool near_middle) {
  std::uniform_real_distribution<float> unit(-1, 1);
  FloatBox box = empty_box();
  const std::array<float, 3> at{near_middle ? 0.01F * unit(random) : unit(random), unit(random), unit(random)};
  for (std::size_t k = 0; k < 3; ++k) {
    const float size = random() % 4 == 0 ? 0 : 0.05F * unit(random);
    box.lo[k] = scale * std::clamp(std::min(at[k], at[k] + size), -1.0F, 1.0F);
    box.hi[k] = scale * std::clamp(std::max(at[k], at[k] + size), -1.0F, 1.0F);
  }
  return box;
}

TEST(OccupancyGrid, NeverDeniesAMeetingAndDeniesMostOthers) {
  std::mt19937_64 random(5);
  const float largest = std::numeric_limits<float>::max();
  for (const float scale : {1.0F, 1e-40F, 1e-30F, 1e30F, largest}) {
    std::vector<FloatBox> added;
    FloatBox all = empty_box();
    for (int i = 0; i < 100; ++i) {
      added.push_back(random_box(random, scale, true));
      extend(all, added.back());
    }
    OccupancyGrid grid({all.lo[0], all.lo[1], all.lo[2], all.hi[0], all.hi[1], all.hi[2]});
    for (const FloatBox& box : added) EXPECT_GE(grid.add(box), 1U);
    int meetings = 0;
    int denied = 0;
    for (int i = 0; i < 20'000; ++i) {
      const FloatBox box = random_box(random, scale, i % 2 == 0);
      const bool meets = std::any_of(added.begin(), added.end(), [&](const FloatBox& b) { return meet(b, box); });
      meetings += meets ? 1 : 0;
      const bool may = grid.may_meet(box);
      denied += may ? 0 : 1;
      ASSERT_TRUE(may || !meets) << "scale " << scale;
    }
    EXPECT_GT(meetings, 100);
    // At the ends of the range only the bounds deny.
    const bool has_cells = scale > 1e-38F && scale < largest;
    EXPECT_GT(denied, has_cells ? 15'000 : 9'000) << "scale " << scale;
  }
}

TEST(OccupancyGrid, BoxesWithoutBoundsMeetEverything) {
  const float infinity = std::numeric_limits<float>::infinity();
  OccupancyGrid grid({-infinity, -infinity, 0, infinity, infinity, 1});
  grid.add({{-infinity, -infinity, 0}, {infinity, infinity, 1}});
  EXPECT_TRUE(grid.may_meet({{5, -3, 0.5F}, {6, infinity, 0.5F}}));
  EXPECT_FALSE(grid.may_meet({{5, -3, 2}, {6, infinity, 3}}));
}

}  // namespace
}  // namespace quoin
