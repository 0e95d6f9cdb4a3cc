// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_motion.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "quoin/arrangement/sets/test_sets.h"

namespace quoin {
namespace {

using testing::are_equal;

TEST(PlanarMotion, MovesWhatReachesInfinity) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_line(list, Point2{0, 0}, Point2{3, 1}, "line");
  family.add_line(list, Point2{1, 0}, Point2{1, 5}, "line");
  family.add_ray(list, Point2{4, -2}, Point2{4, -3}, "ray");
  family.add_segment(list, Point2{-2, 3}, Point2{-1, 3}, "segment");
  family.add_point(list, Point2{-3, 4}, "point");
  const LinearArrangement drawn = arrange(std::move(family), list, Context());
  std::mt19937 random(4);
  const RationalPoint2 there{Rational(Integer(1), Integer(3)), Rational(7)};
  const RationalPoint2 back{Rational(Integer(-1), Integer(3)), Rational(-7)};
  for (int round = 0; round < 50; ++round) {
    const auto bits = [&](std::size_t size) {
      std::vector<bool> result(size);
      for (std::size_t i = 0; i < size; ++i) result[i] = random() % 2 == 1;
      return result;
    };
    const LinearPolygonSet set(drawn, bits(drawn.vertex_count()), bits(drawn.edge_count()), bits(drawn.face_count()));
    const LinearPolygonSet moved = translated(set, there, Context());
    dcel::check_links(moved.arrangement().cells());
    EXPECT_TRUE(are_equal(translated(moved, back, Context()), set)) << "round " << round;
    const LinearPolygonSet turned = reflected(set, there, Context());
    dcel::check_links(turned.arrangement().cells());
    EXPECT_TRUE(are_equal(reflected(turned, there, Context()), set)) << "round " << round;
    EXPECT_TRUE(are_equal(translated(reflected(set, Context()), there, Context()), turned)) << "round " << round;
    EXPECT_EQ(turned.arrangement().counts().unbounded_faces, set.arrangement().counts().unbounded_faces);
  }
}

}  // namespace
}  // namespace quoin
