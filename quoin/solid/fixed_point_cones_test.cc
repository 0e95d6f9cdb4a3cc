// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/fixed_point_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "quoin/base/test_rounds.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

// Two boxes, one turned, moved to where a building stands in map coordinates: the corners of what they have in common
// are no doubles.
Solid building(const Point3& at, double size) {
  Mesh upright = shapes::box({0, 0, 0}, {3, 2, 2});
  Mesh leaning = shapes::box({-1, -1, -1}, {1, 1, 1});
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  for (Point3& p : leaning.vertices)
    p = {1.5 + 2 * (c * p.x - s * p.y), 1 + 2 * (s * p.x + c * p.y), 1 + p.z + 0.1 * p.x};
  std::vector<Solid> operands;
  for (Mesh* mesh : {&upright, &leaning}) {
    for (Point3& p : mesh->vertices) p = {at.x + size * p.x, at.y + size * p.y, at.z + size * p.z};
    const LeafResult made = make_leaf(*mesh, {}, one_thread);
    EXPECT_NE(made.leaf, nullptr);
    operands.push_back(Solid::from_leaf(made.leaf, one_thread));
  }
  return intersect(operands, one_thread);
}

std::vector<std::uint32_t> all_faces(const Brep& b) {
  std::vector<std::uint32_t> faces(b.face_count());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

TEST(FixedPointCones, EncloseTheVolumeFromAnyPoint) {
  for (const Point3& at : {Point3{0, 0, 0}, Point3{512345.678, 5412345.25, 123.5}, Point3{-1e12, 3e11, 7}}) {
    const Solid solid = building(at, 10);
    const Brep& b = solid.boundary();
    ASSERT_GT(b.points.point_count(), b.points.explicit_count());
    const Rational six_volumes = volume(b, one_thread) * Rational(6);
    for (const Point3& from : {Point3{0, 0, 0}, b.points.rounded(b.loop_vertices[0]), Point3{1e3, -1e3, 0.1}}) {
      const auto cones = FixedPointCones::of(b, all_faces(b), from, one_thread);
      ASSERT_TRUE(cones);
      EXPECT_LE(cones->low(), six_volumes);
      EXPECT_GE(cones->high(), six_volumes);
    }
    EXPECT_EQ(rounded_volume(b, one_thread), (six_volumes / Rational(6)).to_double());
  }
}

// What a vertex of the solid makes of it does not depend on where the origin is.
TEST(FixedPointCones, FromAVertexTheyAreCloseEverywhere) {
  for (const double far : {0.0, 0x1p20, 0x1p40}) {
    const Solid solid = building({far, far, far}, 1);
    const Brep& b = solid.boundary();
    const auto near = FixedPointCones::of(b, all_faces(b), b.points.rounded(b.loop_vertices[0]), one_thread);
    ASSERT_TRUE(near);
    EXPECT_LT((near->high() - near->low()).to_double(), 0x1p-95);
  }
}

TEST(FixedPointCones, PointsThatAreAlmostOne) {
  // All corners of the second are a few last digits apart, and the cones' own point is one of the rounded ones.
  for (const double size : {0x1p-30, 0x1p-40}) {
    const Solid solid = building({1000, 1000, 1000}, size);
    const Brep& b = solid.boundary();
    const Rational six_volumes = volume(b, one_thread) * Rational(6);
    const auto cones = FixedPointCones::of(b, all_faces(b), b.points.rounded(b.loop_vertices[0]), one_thread);
    ASSERT_TRUE(cones);
    EXPECT_LE(cones->low(), six_volumes);
    EXPECT_GE(cones->high(), six_volumes);
  }
}

// Faces over doubles on wide grids beside faces over constructed points: both kinds of cones to one vertex.
TEST(FixedPointCones, VolumesOverDoublesOfManySizesBesideConstructedPoints) {
  std::mt19937_64 random(11);
  for (int round = 0; round < test_rounds(30); ++round) {
    const int spread = round % 3 == 0 ? 5 : round % 3 == 1 ? 30 : 80;
    const auto number = [&] {
      return std::ldexp(static_cast<double>(1 + random() % (1U << 30)), static_cast<int>(random() % spread) - 30);
    };
    std::vector<Solid> boxes;
    for (int i = 0; i < 2; ++i) {
      const Point3 low{-number(), -number(), -number()};
      const Mesh box = shapes::box(low, {number(), number(), number()});
      boxes.push_back(Solid::from_leaf(make_leaf(box, {}, one_thread).leaf, one_thread));
    }
    const Solid both = unite(boxes, one_thread);
    const Rational exact = volume(both.boundary(), one_thread);
    ASSERT_GT(exact, Rational(0));
    EXPECT_EQ(rounded_volume(both.boundary(), one_thread), exact.to_double()) << round;
  }
}

TEST(FixedPointCones, NothingBeyondTheRange) {
  const Solid solid = building({0, 0, 0}, 1);
  EXPECT_FALSE(FixedPointCones::of(solid.boundary(), all_faces(solid.boundary()),
                                   {std::numeric_limits<double>::infinity(), 0, 0}, one_thread));
}

}  // namespace
}  // namespace quoin
