// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/location.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <thread>

#include "quoin/arrangement/linear_location.h"
#include "quoin/arrangement/location_scenes.h"
#include "quoin/arrangement/walk_locator.h"

namespace quoin {
namespace {

std::string name(Location l) {
  const char* kinds[] = {"vertex ", "edge ", "face "};
  return kinds[static_cast<int>(l.kind())] + std::to_string(l.index());
}

TEST(PointLocation, AllStrategiesAgreeWithScans) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    const NaiveLocator<LinearFamily> naive(scene.arrangement);
    const TrapezoidLocator<LinearFamily> trapezoids(scene.arrangement);
    const WalkLocator<LinearFamily> walk(scene.arrangement);
    const GridLocator<LinearFamily> grid(scene.arrangement);
    const std::vector<Location> batch =
        locate_batch(scene.arrangement, std::span<const LinearPoint>(scene.queries), Context());
    for (std::size_t i = 0; i < scene.queries.size(); ++i) {
      const LinearPoint& p = scene.queries[i];
      SCOPED_TRACE(testing::Message() << "query " << i << " (" << p.x << ", " << p.y << ")");
      const Location expected = naive.locate(p);
      ASSERT_EQ(name(trapezoids.locate(p)), name(expected));
      ASSERT_EQ(name(walk.locate(p)), name(expected));
      ASSERT_EQ(name(grid.locate(p)), name(expected));
      ASSERT_EQ(name(batch[i]), name(expected));
    }
  }
}

TEST(PointLocation, RaysAgreeWithScans) {
  for (const Scene& scene : location_scenes()) {
    SCOPED_TRACE(scene.name);
    const NaiveLocator<LinearFamily> naive(scene.arrangement);
    const TrapezoidLocator<LinearFamily> trapezoids(scene.arrangement);
    const WalkLocator<LinearFamily> walk(scene.arrangement);
    for (std::size_t i = 0; i < scene.queries.size(); ++i) {
      const LinearPoint& p = scene.queries[i];
      for (const Direction direction : {Direction::down, Direction::up}) {
        SCOPED_TRACE(testing::Message() << "query " << i << " (" << p.x << ", " << p.y << ") "
                                        << (direction == Direction::up ? "up" : "down"));
        const Location expected = naive.shoot(p, direction);
        ASSERT_EQ(name(trapezoids.shoot(p, direction)), name(expected));
        ASSERT_EQ(name(walk.shoot(p, direction)), name(expected));
      }
    }
  }
}

}  // namespace
}  // namespace quoin
