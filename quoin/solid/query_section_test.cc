// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "quoin/base/error.h"
#include "quoin/solid/query/point_location.h"
#include "quoin/solid/query/section.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context one_thread({.threads = 1});

Solid solid(const Mesh& mesh) {
  const LeafResult result = make_leaf(mesh, {}, one_thread);
  EXPECT_NE(result.leaf, nullptr);
  return Solid::from_leaf(result.leaf, one_thread);
}

Solid box(const Point3& lo, const Point3& hi) {
  return solid(shapes::box(lo, hi));
}

Section cut(const Solid& s, const RationalPoint3& normal, const Rational& offset) {
  return section(s.boundary(), {normal, offset}, one_thread);
}

std::size_t corner_count(const Section& s) {
  std::size_t count = 0;
  for (const auto& loop : s.loops) count += loop.size();
  return count;
}

// Even-odd over all loops, for a point on no loop, in the projection along z or x.
bool contains(const Section& s, const RationalPoint3& p, unsigned axis) {
  const unsigned u = (axis + 1) % 3;
  bool inside = s.is_unbounded;
  for (const auto& loop : s.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint3& a = s.points[loop[i]];
      const RationalPoint3& b = s.points[loop[(i + 1) % loop.size()]];
      if ((a[u] > p[u]) == (b[u] > p[u])) continue;
      const Sign left = projected_area(a, b, p, axis).sign();
      if (left == (b[u] > p[u] ? Sign::negative : Sign::positive)) inside = !inside;
    }
  }
  return inside;
}

TEST(Section, OfACube) {
  const Solid cube = solid(shapes::cube(1));
  EXPECT_EQ(area_vector(cut(cube, {0, 0, 1}, Rational(0.5))), (RationalPoint3{0, 0, 1}));
  EXPECT_EQ(area_vector(cut(cube, {0, 0, 1}, 1)), (RationalPoint3{0, 0, 1}));  // the part below the plane ends there
  EXPECT_TRUE(cut(cube, {0, 0, 1}, 0).loops.empty());
  EXPECT_EQ(area_vector(cut(cube, {0, 0, -1}, 0)), (RationalPoint3{0, 0, -1}));
  EXPECT_TRUE(cut(cube, {0, 0, 1}, 2).loops.empty());
  const Section hexagon = cut(cube, {1, 1, 1}, Rational(1.5));
  ASSERT_EQ(hexagon.loops.size(), 1U);
  EXPECT_EQ(hexagon.loops[0].size(), 6U);
  EXPECT_EQ(area_vector(hexagon), (RationalPoint3{0.75, 0.75, 0.75}));
  const Section triangle = cut(cube, {1, 1, 1}, 1);  // through three vertices
  EXPECT_EQ(corner_count(triangle), 3U);
  EXPECT_EQ(area_vector(triangle), (RationalPoint3{0.5, 0.5, 0.5}));
  const Section diagonal = cut(cube, {1, -1, 0}, 0);  // along two edges
  EXPECT_EQ(corner_count(diagonal), 4U);
  EXPECT_EQ(area_vector(diagonal), (RationalPoint3{1, -1, 0}));
  EXPECT_TRUE(cut(cube, {1, 1, 0}, 0).loops.empty());  // touches an edge
  EXPECT_THROW(cut(cube, {0, 0, 0}, 0), InputError);
}

TEST(Section, OfAHollowAndOfAnUnboundedSolid) {
  const Solid outer = box({0, 0, 0}, {4, 4, 4});
  const Solid inner = box({1, 1, 1}, {2, 2, 2});
  const Section ring = cut(subtract(outer, {&inner, 1}, one_thread), {0, 0, 1}, Rational(1.5));
  EXPECT_EQ(ring.loops.size(), 2U);
  EXPECT_EQ(area_vector(ring).z, Rational(15));
  const Section around = cut(complement(inner, one_thread), {0, 0, 1}, Rational(1.5));
  EXPECT_TRUE(around.is_unbounded);
  EXPECT_EQ(area_vector(around).z, Rational(-1));
}

// A ridge that lies in the plane leaves slivers that vanish, also where only part of a face's line is a ridge.
TEST(Section, RidgesInThePlaneLeaveNothing) {
  const Mesh roof_mesh{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {1, 1, 1}, {3, 1, 1}},
                       {0, 3, 2, 1, 0, 1, 5, 4, 2, 3, 4, 5, 1, 2, 5, 3, 0, 4},
                       {0, 4, 8, 12, 15, 18},
                       {},
                       {}};
  const Solid roof = solid(roof_mesh);
  EXPECT_TRUE(cut(roof, {0, 0, 1}, 1).loops.empty());
  EXPECT_EQ(area_vector(cut(roof, {0, 0, -1}, 0)).z, Rational(-8));
  // The roof next to a block of the same height whose wall goes on along the ridge.
  const Solid s = unite(std::array{roof, box({2, 1, 0}, {5, 3, 1})}, one_thread);
  const Section top = cut(s, {0, 0, 1}, 1);
  ASSERT_EQ(top.loops.size(), 1U);
  EXPECT_EQ(top.loops[0].size(), 4U);
  EXPECT_EQ(area_vector(top).z, Rational(6));
}

// A point of the plane is in the section exactly if the point just below it is in the solid.
TEST(Section, HoldsThePointsJustAboveTheSolidsPoints) {
  const Rational tiny = Rational(1) / Rational(1000);
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::vector<Solid> solids;
    while (solids.size() < 5) {
      const auto coordinate = [&] { return static_cast<double>(random() % 5); };
      const Point3 lo{coordinate(), coordinate(), coordinate()};
      const Point3 hi{coordinate(), coordinate(), coordinate()};
      if (lo.x < hi.x && lo.y < hi.y && lo.z < hi.z) solids.push_back(box(lo, hi));
    }
    const Solid s = seed % 2 == 0 ? unite(solids, one_thread) : symmetric_difference(solids, one_thread);
    const SolidLocator locator(s.boundary(), one_thread);
    // A plane of the grid, a diagonal one through grid points, a general one; none parallel to the axis seen along.
    const std::array<SectionPlane, 4> planes{SectionPlane{{0, 0, 1}, 2}, SectionPlane{{0, 0, -2}, -4},
                                             SectionPlane{{1, 1, 1}, 6}, SectionPlane{{1, -2, 3}, Rational(3.25)}};
    for (const SectionPlane& plane : planes) {
      const Section found = section(s.boundary(), plane, one_thread);
      const RationalPoint3 down = plane.normal * -tiny;
      for (int i = 0; i < 60; ++i) {
        const Rational x = Rational(static_cast<int>(random() % 50)) / Rational(10) + Rational(1) / Rational(37);
        const Rational y = Rational(static_cast<int>(random() % 50)) / Rational(10) + Rational(1) / Rational(41);
        const RationalPoint3 p{x, y, (plane.offset - plane.normal.x * x - plane.normal.y * y) / plane.normal.z};
        const Place below = locator.locate(p + down).place;
        if (is_on_boundary(below)) continue;
        ASSERT_EQ(contains(found, p, 2), below == Place::in) << "seed " << seed << " point " << i;
      }
    }
  }
}

}  // namespace
}  // namespace quoin
