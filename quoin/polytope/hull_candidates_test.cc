// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/hull_filter.h"
#include "quoin/polytope/hull_of_some.h"
#include "quoin/polytope/hull_reach.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Point3 in_ball(Random& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  for (;;) {
    const Point3 p{unit(random), unit(random), unit(random)};
    if (p.x * p.x + p.y * p.y + p.z * p.z <= 1) return p;
  }
}

/// Balls, moved and stretched, straight or askew; boxes of a lattice; what is all but flat.
enum class Shape { ball, far_ball, long_ball, needle_askew, lattice, nearly_flat, huge, tiny };
constexpr Shape shapes[] = {Shape::ball,    Shape::far_ball,    Shape::long_ball, Shape::needle_askew,
                            Shape::lattice, Shape::nearly_flat, Shape::huge,      Shape::tiny};

Point3 point_of(Shape shape, Random& random) {
  const Point3 p = in_ball(random);
  switch (shape) {
    case Shape::ball:
      return p;
    case Shape::far_ball:
      return {p.x + 1e6, p.y - 3e7, p.z + 1e5};
    case Shape::long_ball:
      return {p.x * 1e5, p.y, p.z * 1e-4};
    case Shape::needle_askew:
      return {p.x + p.y * 1e-3, p.x - p.z * 1e-3, p.x};
    case Shape::lattice:
      return {std::floor(p.x * 9), std::floor(p.y * 9), std::floor(p.z * 9)};
    case Shape::nearly_flat:
      return {p.x, p.y, p.x * 0.25 + p.z * 0x1p-50};
    case Shape::huge:
      return {p.x * 1e307, p.y * 1e307, p.z * 1e307};
    case Shape::tiny:
      return {p.x * 1e-306, p.y * 1e-306, p.z * 1e-306};
  }
  return p;
}

Points points_of(Shape shape, std::size_t count, Random& random) {
  Points points;
  while (points.size() < count) points.push_back(point_of(shape, random));
  return points;
}

double largest_of(const Points& points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest;
}

bool is_strictly_inside(const HullBuilder& hull, const Point3& p) {
  return std::ranges::all_of(hull.triangles(), [&](const HullBuilder::Triangle& t) {
    const auto& q = hull.points();
    return t.is_free() || orientation(q[t.corners[0]], q[t.corners[1]], q[t.corners[2]], p) == Sign::negative;
  });
}

/// Some of the points themselves, and points as near to the hull's facets, edges and corners as rounding allows.
Points near_hull(const HullBuilder& hull, const Points& points, Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Points result(points.begin(), points.begin() + 100);
  for (const HullBuilder::Triangle& t : hull.triangles()) {
    if (t.is_free()) continue;
    const double a = unit(random);
    const double b = below(random, 2) == 0 ? 0 : unit(random) * (1 - a);
    Point3 p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] = a * hull.points()[t.corners[0]][axis] + b * hull.points()[t.corners[1]][axis] +
                (1 - a - b) * hull.points()[t.corners[2]][axis];
      if (below(random, 2) == 0) p[axis] = std::nextafter(p[axis], below(random, 2) == 0 ? -1e308 : 1e308);
    }
    result.push_back(p);
  }
  return result;
}

TEST(HullReach, HoldsNothingThatIsNotInside) {
  Random random(1);
  for (const Shape shape : shapes) {
    for (int round = 0; round < test_rounds(20); ++round) {
      const Points points = points_of(shape, 100 + static_cast<std::size_t>(below(random, 200)), random);
      const Simplex simplex = find_simplex(points, one_thread);
      if (simplex.count < 4) continue;
      std::vector<std::uint32_t> half;
      for (std::uint32_t i = 0; i < points.size(); i += 2) half.push_back(i);
      const HullOfSome hull(points, half, simplex, one_thread);
      Points asked = near_hull(hull.builder, points, random);
      const double largest = std::max(largest_of(points), largest_of(asked));
      const HullReach reach(hull.builder, largest, one_thread);
      const HullFilter planes(hull.builder, largest);
      std::vector<std::uint32_t> left;
      planes.append_others(asked, 0, asked.size(), 1, left);
      for (std::uint32_t i = 0; i < asked.size(); ++i) {
        const bool is_left = std::ranges::binary_search(left, i);
        if (is_left && !reach.surely_holds(asked[i])) continue;
        ASSERT_TRUE(is_strictly_inside(hull.builder, asked[i]))
            << "shape " << static_cast<int>(shape) << " round " << round << " point " << i;
      }
    }
  }
}

TEST(HullReach, HoldsMostOfWhatIsInside) {
  Random random(2);
  for (const Shape shape : {Shape::ball, Shape::far_ball, Shape::long_ball}) {
    const Points points = points_of(shape, 5000, random);
    const Simplex simplex = find_simplex(points, one_thread);
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back(i);
    const HullOfSome hull(points, all, simplex, one_thread);
    const HullReach reach(hull.builder, largest_of(points), one_thread);
    const auto held = std::ranges::count_if(points, [&](const Point3& p) { return reach.surely_holds(p); });
    EXPECT_GT(held, 4250);
  }
}

TEST(HullCandidates, AreAllCornersAndFewOthers) {
  Random random(3);
  for (const Shape shape : shapes) {
    for (const std::size_t count : {std::size_t{700}, std::size_t{5000}, std::size_t{40000}}) {
      if (count > 10000 && tests_take_fewer_rounds) continue;
      const Points points = points_of(shape, count, random);
      const Simplex simplex = find_simplex(points, one_thread);
      ASSERT_EQ(simplex.count, 4U);
      const auto candidates = hull_candidates(points, largest_of(points), simplex, one_thread);
      ASSERT_TRUE(std::ranges::is_sorted(candidates));
      // The hull of all, without what leaves points out.
      std::vector<std::uint32_t> all(points.size());
      for (std::uint32_t i = 0; i < points.size(); ++i) all[i] = i;
      const HullOfSome whole(points, all, simplex, one_thread);
      for (const HullBuilder::Triangle& t : whole.builder.triangles()) {
        if (t.is_free()) continue;
        for (const std::uint32_t corner : t.corners) {
          const std::uint32_t name = whole.order[corner];
          const bool is_there = std::ranges::binary_search(candidates, name) ||
                                std::ranges::find(simplex.points, name) != simplex.points.end();
          ASSERT_TRUE(is_there) << "shape " << static_cast<int>(shape) << " of " << count << ": " << name;
        }
      }
      const bool is_filled = shape != Shape::nearly_flat && shape != Shape::tiny && shape != Shape::huge;
      if (count < 10000 || !is_filled) continue;
      // One that lies askew is left out by the planes of few points.
      const std::size_t most = shape == Shape::needle_askew ? count * 2 / 3 : count / 4;
      EXPECT_LT(candidates.size(), most) << "shape " << static_cast<int>(shape);
    }
  }
}

/// Of a part of the unit sphere, and of a smaller ball: hulls of parts have as many corners as points on the sphere.
Points with_part_on_sphere(std::size_t count, int on_sphere_in_a_hundred, Random& random) {
  Points points;
  while (points.size() < count) {
    const Point3 p = in_ball(random);
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (length < 0.1) continue;
    const double size = below(random, 100) < on_sphere_in_a_hundred ? 1 / length : 0.9;
    points.push_back({p.x * size, p.y * size, p.z * size});
  }
  return points;
}

TEST(HullCandidates, AreAllPointsOfASphere) {
  Random random(4);
  const Points points = with_part_on_sphere(20000, 100, random);
  EXPECT_EQ(hull_candidates(points, 1, find_simplex(points, one_thread), one_thread).size(), points.size());
}

TEST(HullCandidates, OfASphereAroundABallAreThoseOfTheSphere) {
  if (tests_take_fewer_rounds) GTEST_SKIP() << "large";
  Random random(5);
  const Points points = with_part_on_sphere(400000, 40, random);
  const auto candidates = hull_candidates(points, 1, find_simplex(points, one_thread), one_thread);
  EXPECT_LT(candidates.size(), points.size() / 2);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    if (p.x * p.x + p.y * p.y + p.z * p.z < 0.9) continue;
    ASSERT_TRUE(std::ranges::binary_search(candidates, i)) << i;
  }
}

}  // namespace
}  // namespace quoin
