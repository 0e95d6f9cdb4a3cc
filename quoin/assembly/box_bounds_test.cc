// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/box_bounds.h"

#include <gtest/gtest.h>

#include "quoin/assembly/test_assemblies.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace test_assemblies;

Box3 random_box(Random& random) {
  const auto number = [&] { return double(random() % 5); };
  const Point3 low{number(), number(), number()};
  return {low, {low.x + 1 + number(), low.y + 1 + number(), low.z + 1 + number()}};
}

// Outside of what boxes tell, nothing inside them meets.
TEST(BoxBounds, HoldWhatIsBlocked) {
  Random random(2);
  for (int round = 0; round < test_rounds(100); ++round) {
    const Box3 a = random_box(random);
    const Box3 b = random_box(random);
    const auto bounds = project_boxes(a, b, one_thread);
    const Points moving = box(a.low(), a.high());
    const Points other = box(b.low(), b.high());
    for (int k = 0; k < 10; ++k) {
      const SphereDirection d = random_direction(random);
      const bool is_hit = hits(moving, other, rational(d));
      EXPECT_EQ(bounds ? bounds->contains(d) : is_hit, is_hit) << text_of(d);
    }
  }
}

// What is said to be covered is inside one of the regions; some of it has to be found.
TEST(BoxBounds, CoveredBoxesBlockNothingMore) {
  Random random(4);
  int covered = 0;
  for (int round = 0; round < test_rounds(400); ++round) {
    const Box3 a = random_box(random);
    Box3 b = random_box(random);
    b = Box3({b.low().x + 6, b.low().y, b.low().z}, {b.high().x + 6, b.high().y, b.high().z});
    const auto wide = project_boxes(random_box(random), random_box(random), one_thread);
    if (!wide || !are_surely_covered(a, b, {&*wide, 1})) continue;
    ++covered;
    const ConvexRegion narrow = *project_boxes(a, b, one_thread);
    for (const RegionDirection& corner : narrow.corners) EXPECT_TRUE(wide->contains(corner));
  }
  EXPECT_GE(covered, test_cases(20));
  const ConvexRegion half{{RegionDirection(direction(1, 0, 0))}, {}};
  const Box3 unit({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(are_surely_covered(unit, {{2, 0, 0}, {3, 1, 1}}, {&half, 1}));
  EXPECT_FALSE(are_surely_covered(unit, {{1, 0, 0}, {2, 1, 1}}, {&half, 1})) << "boxes that touch";
  EXPECT_FALSE(are_surely_covered(unit, {{-2, 0, 0}, {-1.5, 1, 1}}, {&half, 1}));
  EXPECT_FALSE(are_surely_covered(unit, {{2, 0, 0}, {3, 1, 1}}, {}));
}

}  // namespace
}  // namespace quoin
