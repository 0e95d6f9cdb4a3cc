// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_penetration.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/proximity.h"
#include "quoin/solid/placement.h"
#include "quoin/solid/query/distance.h"
#include "quoin/solid/test_solids.h"

namespace quoin {

namespace {

using namespace testing;

RationalPoint3 vector(int x, int y, int z, int of = 1) {
  return RationalPoint3{Rational(x), Rational(y), Rational(z)} * (Rational(1) / Rational(of));
}

Solid l_shape() {
  return box({0, 0, 0}, {3, 1, 1}) | box({0, 0, 0}, {1, 3, 1});
}

}  // namespace

TEST(SolidPenetration, OfBoxesAndOfShapesWithNotches) {
  const SolidPenetration boxes(box({0, 0, 0}, {2, 2, 2}), box({0, 0, 0}, {3, 3, 3}), one_thread);
  EXPECT_EQ(boxes.shortest(vector(0, 0, 0), one_thread)->squared_depth, Rational(4));
  EXPECT_EQ(boxes.along(vector(0, 0, 0), vector(0, 0, 1), one_thread), Rational(3));
  EXPECT_EQ(boxes.along(vector(0, 0, 0), vector(0, 0, -2), one_thread), Rational(1));
  EXPECT_FALSE(boxes.shortest(vector(3, 0, 0), one_thread).has_value()) << "they touch";
  EXPECT_EQ(boxes.along(vector(3, 0, 0), vector(-1, 0, 0), one_thread), Rational(0));
  EXPECT_THROW(boxes.along(vector(0, 0, 0), vector(0, 0, 0), one_thread), InputError);
  // A peg that stands in a frame has room to all sides; pushed into the wall it leaves by the nearest way, which may be
  // the hole.
  const Solid frame = box({-3, -3, -1}, {3, 3, 1}) - box({-2, -2, -2}, {2, 2, 2});
  const SolidPenetration peg(box({-1, -1, -5}, {1, 1, 5}), frame, one_thread);
  EXPECT_FALSE(peg.shortest(vector(0, 0, 0), one_thread).has_value());
  const auto pushed = peg.shortest(vector(3, 0, 0, 2), one_thread);
  EXPECT_EQ(pushed->squared_depth, Rational(0.25));
  EXPECT_EQ(pushed->separation, vector(-1, 0, 0, 2));
  EXPECT_EQ(peg.along(vector(3, 0, 0, 2), vector(1, 0, 0), one_thread), Rational(2.5));
  EXPECT_THROW(SolidPenetration(~frame, frame, one_thread), InputError);
}

TEST(SolidPenetration, OfSizesWhoseSquaresAreNoDoubles) {
  for (const double size : {1.0, 0x1p-538, 0x1p500}) {
    const auto sized = [&](const Point3& low, const Point3& high) {
      return box({low.x * size, low.y * size, low.z * size}, {high.x * size, high.y * size, high.z * size});
    };
    const Solid shape = sized({0, 0, 0}, {8, 8, 8}) | sized({-6, 2, 2}, {1, 3, 3});
    for (const auto& [dx, dy] : {std::array{1.9, 1.5}, std::array{1.5, 1.9}}) {
      const SolidPenetration found(shape, sized({8 - dx, 8 - dy, -20}, {30, 30, 30}), one_thread);
      const Rational depth = Rational(1.5) * Rational(size);
      EXPECT_EQ(found.shortest(vector(0, 0, 0), one_thread)->squared_depth, depth * depth);
    }
  }
}

/// Where the separation leads, the two only touch; a little less of it, and they overlap.
TEST(SolidPenetration, SeparationsLeadToContact) {
  std::mt19937_64 random(5);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<std::uint64_t>(end)); };
  const Solid shape = l_shape();
  const Solid other = l_shape() | box({0, 0, 0}, {1, 1, 3});
  const SolidPenetration penetration(shape, other, one_thread);
  const SolidProximity proximity(shape, other, one_thread);
  int overlaps = 0;
  for (int round = 0; round < test_rounds(60); ++round) {
    const RationalPoint3 t = vector(below(25) - 12, below(25) - 12, below(25) - 12, 4);
    const bool is_deep = proximity.distance(t, one_thread).relation == Interference::overlapping;
    const auto shortest = penetration.shortest(t, one_thread);
    ASSERT_EQ(shortest.has_value(), is_deep);
    if (!is_deep) continue;
    ++overlaps;
    EXPECT_EQ(dot(shortest->separation, shortest->separation), shortest->squared_depth);
    const RationalPoint3 direction = vector(below(7) - 3, below(7) - 3, below(7) - 3 == 0 ? 1 : 2);
    const Rational depth = penetration.along(t, direction, one_thread);
    EXPECT_GE(depth * depth * dot(direction, direction), shortest->squared_depth);
    for (const RationalPoint3& way : {shortest->separation, direction * depth}) {
      EXPECT_EQ(proximity.distance(t + way, one_thread).relation, Interference::touching);
      EXPECT_EQ(proximity.distance(t + way * Rational(0.999), one_thread).relation, Interference::overlapping);
    }
  }
  EXPECT_GE(overlaps, test_cases(10));
}

}  // namespace quoin
