// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "quoin/solid/measure.h"
#include "quoin/solid/query/interference.h"
#include "quoin/solid/shapes.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

Solid solid(const Mesh& mesh) {
  return Solid::from_leaf(make_leaf(mesh, {}, one_thread).leaf, one_thread);
}
Solid box(const Point3& lo, const Point3& hi) {
  return solid(shapes::box(lo, hi));
}

// Both orders of arguments.
Interference kind(const Solid& a, const Solid& b) {
  const Interference result = interference(a, b, one_thread).kind;
  EXPECT_EQ(interference(b, a, one_thread).kind, result);
  return result;
}

TEST(Interference, OfCubes) {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(kind(cube, cube), Interference::overlapping);
  EXPECT_EQ(kind(cube, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})), Interference::overlapping);
  EXPECT_EQ(kind(cube, box({1, 0, 0}, {2, 1, 1})), Interference::touching);
  EXPECT_EQ(kind(cube, box({1, 1, 0}, {2, 2, 1})), Interference::touching);
  EXPECT_EQ(kind(cube, box({1, 1, 1}, {2, 2, 2})), Interference::touching);
  EXPECT_EQ(kind(cube, box({1, 0.25, 0.25}, {2, 0.75, 0.75})), Interference::touching);
  EXPECT_EQ(kind(cube, box({1, -1, 0.5}, {2, 2, 3})), Interference::touching);
  const double tiny = 0x1p-50;
  EXPECT_EQ(kind(cube, box({1 + tiny, 0, 0}, {2, 1, 1})), Interference::apart);
  EXPECT_EQ(kind(cube, box({1 - tiny, 0, 0}, {2, 1, 1})), Interference::overlapping);
  EXPECT_EQ(volume(interference(cube, box({1 - tiny, 0, 0}, {2, 1, 1}), one_thread).common.boundary(), one_thread),
            Rational(tiny));
}

TEST(Interference, OfCornersAndCrossingEdges) {
  const Solid cube = box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(kind(cube, solid(shapes::translated(shapes::octahedron(1), {2, 0, 0}))), Interference::touching);
  EXPECT_EQ(kind(cube, solid(shapes::translated(shapes::octahedron(1), {2.25, 0, 0}))), Interference::apart);
  // Two bars with square sections on edge, across one another: one point in the middle of an edge of each.
  const Mesh bar{{{-3, -1, 0}, {-3, 0, -1}, {-3, 1, 0}, {-3, 0, 1}, {3, -1, 0}, {3, 0, -1}, {3, 1, 0}, {3, 0, 1}},
                 {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7},
                 {0, 4, 8, 12, 16, 20, 24},
                 {},
                 {}};
  Mesh across = bar;
  for (Point3& p : across.vertices) p = {p.y, p.x, p.z + 2};
  across = shapes::reversed(across);
  EXPECT_EQ(kind(solid(bar), solid(across)), Interference::touching);
  EXPECT_EQ(kind(solid(bar), solid(shapes::translated(across, {0, 0, 0x1p-40}))), Interference::apart);
  EXPECT_EQ(kind(solid(bar), solid(shapes::translated(across, {0, 0, -0x1p-40}))), Interference::overlapping);
}

TEST(Interference, OfNestedShellsAndComplements) {
  const Solid outer = box({0, 0, 0}, {4, 4, 4});
  const Solid hole = box({1, 1, 1}, {3, 3, 3});
  const Solid hollow = subtract(outer, {&hole, 1}, one_thread);
  EXPECT_EQ(kind(hollow, box({1.5, 1.5, 1.5}, {2, 2, 2})), Interference::apart);
  EXPECT_EQ(kind(hollow, hole), Interference::touching);
  EXPECT_EQ(kind(outer, complement(outer, one_thread)), Interference::touching);
  EXPECT_EQ(kind(hole, complement(outer, one_thread)), Interference::apart);
  EXPECT_EQ(kind(outer, Solid()), Interference::apart);
}

}  // namespace
}  // namespace quoin
