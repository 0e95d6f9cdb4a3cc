// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_sum.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/solid/mesh.h"
#include "quoin/solid/test_solids.h"

namespace quoin {

namespace {

using namespace testing;
using Random = std::mt19937_64;
using Points = std::vector<Point3>;

Solid hull_of(const Points& points) {
  const ConvexHull hull = convex_hull(points, one_thread);
  if (hull.dimension < 3) return {};
  return Solid::from_boundary(convex_boundary(hull, points, "hull"), "hull", one_thread);
}

Solid united(const std::vector<Solid>& solids) {
  return unite(solids, one_thread);
}

Solid sum_of(const Solid& a, const Solid& b) {
  Solid sum = minkowski_sum(a, b, one_thread);
  expect_valid(sum);
  return sum;
}

/// A solid as convex pieces of vertices with exact sums.
using Pieces = std::vector<Points>;

Solid solid_of(const Pieces& pieces) {
  std::vector<Solid> solids;
  for (const Points& p : pieces) solids.push_back(hull_of(p));
  return united(solids);
}

/// The definition: the union of the hulls of all sums of vertices of two pieces.
Solid sum_of_pieces(const Pieces& a, const Pieces& b) {
  std::vector<Solid> sums;
  for (const Points& p : a) {
    for (const Points& q : b) {
      Points sum;
      for (const Point3& x : p) {
        for (const Point3& y : q) sum.push_back({x.x + y.x, x.y + y.y, x.z + y.z});
      }
      sums.push_back(hull_of(sum));
    }
  }
  return united(sums);
}

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(end));
}

/// Boxes, tetrahedra and wedges of a small grid, mostly joined; many touch, or lie in common planes.
Points piece_on_grid(Random& random, int size) {
  Points points;
  if (below(random, 3) != 0) {
    Point3 low;
    Point3 high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = below(random, size);
      high[axis] = low[axis] + 1 + below(random, 3);
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
      points.push_back({(corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                        (corner & 4U) != 0 ? high.z : low.z});
    }
    return points;
  }
  do {
    points.clear();
    for (int i = 0; i < 4 + below(random, 3); ++i) {
      const double x = below(random, size);
      const double y = below(random, size);
      points.push_back({x, y, static_cast<double>(below(random, size))});
    }
  } while (convex_hull(points, one_thread).dimension < 3);
  return points;
}

Pieces pieces_on_grid(Random& random) {
  Pieces pieces;
  for (int i = 1 + below(random, 4); i > 0; --i) pieces.push_back(piece_on_grid(random, 2 + below(random, 5)));
  return pieces;
}

Solid frame() {
  return box({-3, -3, -1}, {3, 3, 1}) - box({-2, -2, -2}, {2, 2, 2});
}

bool contains(const Solid& s, const Point3& p) {
  return SolidLocator(s.boundary(), one_thread).locate(p).place != Place::out;
}

}  // namespace

TEST(SolidSum, IsTheUnionOfTheSumsOfConvexPieces) {
  for (std::uint64_t seed = 0; seed < test_rounds(25U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Pieces a = pieces_on_grid(random);
    const Pieces b = pieces_on_grid(random);
    const Solid sum = sum_of(solid_of(a), solid_of(b));
    ASSERT_NO_FATAL_FAILURE(expect_same_set(sum, sum_of_pieces(a, b)));
    if (::testing::Test::HasFailure()) break;
  }
}

/// Coordinates whose sums doubles do not hold.
TEST(SolidSum, OfSumsThatAreNotDoublesIsTheSameMovedBack) {
  for (std::uint64_t seed = 0; seed < test_rounds(4U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Pieces a = pieces_on_grid(random);
    Pieces b = pieces_on_grid(random);
    const Rational before = volume_of(sum_of(solid_of(a), solid_of(b)));
    for (Points& p : a) {
      for (Point3& x : p) x = {x.x * 0x1p60, x.y * 0x1p60, x.z * 0x1p60};
    }
    for (Points& p : b) {
      for (Point3& x : p) x = {x.x * 0x1p60 + 0x1p30, x.y * 0x1p60, x.z * 0x1p60};
    }
    const Rational cube = Rational(0x1p60) * Rational(0x1p60) * Rational(0x1p60);
    EXPECT_EQ(volume_of(sum_of(solid_of(a), solid_of(b))), before * cube);
  }
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const Solid b = box({0, 0, 0}, {0x1p-60, 0x1p-60, 0x1p-60});
  const Rational side = Rational(1) + Rational(0x1p-60);
  EXPECT_EQ(volume_of(sum_of(a, b)), side * side * side);
}

/// The largest double less a little: what the rounded sum leaves overflows, though the sum does not.
TEST(SolidSum, OfSumsNearTheLargestDouble) {
  const double h = 0x1p970;
  const double most = std::numeric_limits<double>::max();
  const Solid l = box({-5 * h, 0, 0}, {-3 * h, 1, 1}) | box({-5 * h, 0, 0}, {-4 * h, 2, 1});
  const Solid sum = sum_of(l, box({0, 0, 0}, {most, 1, 1}));
  const Rational long_part = (Rational(most) + Rational(2) * Rational(h)) * Rational(4);
  const Rational short_part = (Rational(most) + Rational(h)) * Rational(2);
  EXPECT_EQ(volume_of(sum), long_part + short_part);
}

TEST(SolidSum, DoesNotDependOnTheOrderAndDistributesOverUnions) {
  for (std::uint64_t seed = 0; seed < test_rounds(6U); ++seed) {
    Random random(1000 + seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Solid a = solid_of(pieces_on_grid(random));
    const Solid b = solid_of(pieces_on_grid(random));
    const Solid c = solid_of(pieces_on_grid(random));
    expect_same_set(sum_of(a, c), sum_of(c, a));
    expect_same_set(sum_of(a | b, c), sum_of(a, c) | sum_of(b, c));
    expect_same_set(sum_of(sum_of(a, b), c), sum_of(a, sum_of(b, c)));
    if (::testing::Test::HasFailure()) break;
  }
}

/// Engineering note, 5.4: a solid and another one reflected that meet in a ring have Euler number 0.
TEST(SolidSum, HoldsThePlacesWhereTheTwoMeetInARing) {
  EXPECT_EQ(volume_of(sum_of(frame(), frame())), Rational(576)) << "12 x 12 x 4: the hole is gone";
  const Solid torus = solid(shapes::torus(12, 8, 3, 1));
  const Solid ball = solid(shapes::geodesic_sphere(2, 2.5));
  EXPECT_TRUE(contains(sum_of(torus, ball), {0, 0, 0}));
  EXPECT_TRUE(contains(sum_of(ball, torus), {0, 0, 0}));
  const Solid small = solid(shapes::geodesic_sphere(2, 1.5));
  EXPECT_FALSE(contains(sum_of(torus, small), {0, 0, 0}));
  // Two pieces of a ring each, and two more that close it.
  const Solid c = frame() - box({-4, -1, -2}, {0, 1, 2});
  const Solid bowl = box({-3, -3, -3}, {3, 3, 1}) - box({-2, -2, -2}, {2, 2, 2});
  EXPECT_TRUE(contains(sum_of(c, c), {0, 0, 0}));
  EXPECT_TRUE(contains(sum_of(bowl, frame()), {0, 0, 0}));
  EXPECT_TRUE(contains(sum_of(frame(), bowl), {0, 0, 0}));
}

/// A plate with teeth of equal steps in its rims.
Mesh toothed_plate(int teeth) {
  Mesh mesh;
  std::vector<Point2> rim;
  for (int i = 0; i <= teeth; ++i) rim.push_back({4, static_cast<double>(i)});
  for (int i = teeth; i >= 0; --i) rim.push_back({0, static_cast<double>(i)});
  const auto n = static_cast<std::uint32_t>(rim.size());
  for (const Point2& p : rim) mesh.vertices.push_back({p.x, p.y, 2});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double tooth = i % 2 == 0 ? 0 : 0.25;
    mesh.vertices.push_back({rim[i].x > 2 ? rim[i].x + tooth : rim[i].x - tooth, rim[i].y, 0});
  }
  std::vector<std::uint32_t> top(n);
  std::iota(top.begin(), top.end(), 0U);
  mesh.add_face(top);
  std::vector<std::uint32_t> bottom;
  for (std::uint32_t i = 2 * n; i > n; --i) bottom.push_back(i - 1);
  mesh.add_face(bottom);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.add_face(Tile{i, n + i, n + next});
    mesh.add_face(Tile{i, n + next, next});
  }
  return mesh;
}

/// Many tiles of the convolution face each other in one place there; all of them belong to one wall.
TEST(SolidSum, OfSurfacesWhoseSumsCoverOneAnother) {
  const Solid plate = solid(toothed_plate(24));
  const std::array<Point2, 4> outer{{{0, -3}, {1, 0}, {0, 3}, {-1, 0}}};
  const std::array<Point2, 4> inner{{{0, -1}, {0.25, 0}, {0, 1}, {-0.25, 0}}};
  std::vector<Solid> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    Points corners;
    for (const Point2& p : {outer[i], outer[(i + 1) % 4], inner[(i + 1) % 4], inner[i]}) {
      corners.push_back({p.x, p.y, 0});
      corners.push_back({p.x, p.y, 1});
    }
    sides.push_back(hull_of(corners));
  }
  const Solid sum = sum_of(plate, united(sides));
  EXPECT_EQ(volume_of(sum), Rational(537));
  for (Solid& side : sides) side = sum_of(plate, side);
  expect_same_set(sum, united(sides));
}

/// Vertices may be less than any double.
TEST(SolidSum, OfAnyScale) {
  for (const std::uint64_t seed : {0U, 1U, 2U}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto tetrahedron = [&](std::int64_t range) {
      Points points(4);
      for (Point3& p : points) {
        for (unsigned axis = 0; axis < 3; ++axis) {
          p[axis] = static_cast<double>(static_cast<std::int64_t>(random() % (2 * range + 1)) - range);
        }
      }
      return points;
    };
    const Points whole = tetrahedron(9);
    const Points bite = tetrahedron(9);
    const Points other = tetrahedron(1 << 20);
    const auto scaled = [&](const Points& points, int exponent) {
      Points result;
      for (const Point3& p : points) {
        result.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
      }
      return hull_of(result);
    };
    const auto sum_at = [&](int exponent) {
      return sum_of(scaled(whole, exponent - 1074) - scaled(bite, exponent - 1074), scaled(other, exponent + 40));
    };
    const Solid tiny = sum_at(0);
    const Solid large = sum_at(574);
    EXPECT_EQ(counts_of(tiny), counts_of(large));
    EXPECT_EQ(volume_of(tiny) * Rational(0x1p861) * Rational(0x1p861), volume_of(large));
  }
}

TEST(SolidSum, KeepsHolesThatTheOtherDoesNotFill) {
  const Solid cavity = box({-3, -3, -3}, {3, 3, 3}) - box({-2, -2, -2}, {2, 2, 2});
  const auto cube = [](double r) { return box({-r, -r, -r}, {r, r, r}); };
  EXPECT_EQ(volume_of(sum_of(cavity, cube(1))), Rational(512 - 8));
  EXPECT_EQ(volume_of(sum_of(cavity, cube(2))), Rational(1000))
      << "filled but for one point, which no regular set leaves";
  EXPECT_EQ(volume_of(sum_of(frame(), cube(1))), Rational(8 * 8 * 4 - 2 * 2 * 4));
  EXPECT_EQ(sum_of(frame(), cube(1)).boundary().face_count(), 10U);
  // A shell inside a shell: sums of all pairs.
  const Solid nested = cavity | cube(1);
  EXPECT_EQ(volume_of(sum_of(nested, cube(0.25))), Rational(274.625 - 42.875 + 15.625));
}

TEST(SolidSum, OfSolidsThatTouchThemselves) {
  const Solid edge = box({0, 0, 0}, {1, 1, 1}) | box({1, 1, 0}, {2, 2, 1});
  const Solid corner = box({0, 0, 0}, {1, 1, 1}) | box({1, 1, 1}, {2, 2, 2});
  const Solid unit = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(volume_of(sum_of(edge, unit)), Rational(14));
  EXPECT_EQ(volume_of(sum_of(corner, unit)), Rational(15));
  const Pieces pieces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  expect_same_set(sum_of(solid_of(pieces), solid_of(pieces)), sum_of_pieces(pieces, pieces));
}

TEST(SolidSum, OfAPointSizedTetrahedronMovesTheOther) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Solid speck = solid(shapes::tetrahedron(tiny));
  const Solid sum = sum_of(frame(), speck);
  EXPECT_GT(volume_of(sum), volume_of(frame()));
  EXPECT_TRUE((frame() - sum).is_empty());
}

TEST(SolidSum, WithAPolytopeOfAnyDimensionIsWhatItSweeps) {
  const auto polytope = [](const Points& points) { return Polytope::hull_of(points, one_thread); };
  const Solid l = box({0, 0, 0}, {2, 1, 1}) | box({0, 0, 0}, {1, 2, 1});
  EXPECT_EQ(volume_of(minkowski_sum(l, polytope({{0, 0, 0}, {0, 0, 2}}), one_thread)), Rational(9));
  EXPECT_EQ(volume_of(minkowski_sum(l, polytope({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), one_thread)),
            Rational(8));
  EXPECT_EQ(volume_of(minkowski_sum(l, polytope({{5, 6, 7}}), one_thread)), Rational(3));
  const Points tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  expect_same_set(minkowski_sum(frame(), polytope(tetrahedron), one_thread), sum_of(frame(), hull_of(tetrahedron)));
  EXPECT_EQ(volume_of(erosion(l, polytope({{0, 0, 0}, {0.5, 0, 0}}), one_thread)), Rational(2));
  EXPECT_EQ(volume_of(erosion(frame(), polytope({{0, 0, -0.5}, {0, 0, 0.5}}), one_thread)), Rational(20));
  expect_same_set(erosion(frame(), polytope(tetrahedron), one_thread),
                  erosion(frame(), hull_of(tetrahedron), one_thread));
  EXPECT_THROW(erosion(~l, polytope(tetrahedron), one_thread), InputError);
}

TEST(SolidSum, RefusesWhatHasNoSum) {
  const Solid unit = box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(minkowski_sum(unit, Solid(), one_thread).is_empty());
  EXPECT_TRUE(minkowski_sum(Solid(), unit, one_thread).is_empty());
  EXPECT_THROW(minkowski_sum(unit, ~unit, one_thread), InputError);
  EXPECT_THROW(minkowski_sum(~unit, unit, one_thread), InputError);
  const Solid huge = box({0, 0, 0}, {1.7e308, 1, 1});
  EXPECT_THROW(minkowski_sum(huge, huge, one_thread), InputError);
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(minkowski_sum(frame(), frame(), cancelled), Cancelled);
}

TEST(SolidSum, IsTheSameOnTwoThreads) {
  const Context two({.threads = 2});
  const Solid torus = solid(shapes::torus(10, 6, 3, 1));
  const Solid star = solid(shapes::tetrahedron(1)) | solid(shapes::octahedron(1.25));
  const Solid one = minkowski_sum(torus, star, one_thread);
  const Solid other = minkowski_sum(torus, star, two);
  EXPECT_EQ(one.boundary().loop_vertices, other.boundary().loop_vertices);
  EXPECT_EQ(one.boundary().face_first_loop, other.boundary().face_first_loop);
}

TEST(Erosion, IsTheSetOfPlacesWhereTheToolFits) {
  const auto cube = [](double r) { return box({-r, -r, -r}, {r, r, r}); };
  EXPECT_EQ(volume_of(erosion(cube(3), cube(1), one_thread)), Rational(64));
  EXPECT_EQ(volume_of(erosion(frame(), cube(0.25), one_thread)), Rational(15));
  EXPECT_TRUE(erosion(frame(), cube(1), one_thread).is_empty()) << "it fits in single directions only";
  EXPECT_TRUE(erosion(cube(1), cube(2), one_thread).is_empty());
  EXPECT_TRUE(erosion(Solid(), cube(2), one_thread).is_empty());
  EXPECT_THROW(erosion(cube(2), Solid(), one_thread), InputError);
  EXPECT_THROW(erosion(~cube(2), cube(1), one_thread), InputError);
}

TEST(Erosion, OfSizesBeyondSinglePrecision) {
  const Solid rod = box({0, 0, 0}, {1e39, 1, 1});
  const double tiny = 0x1p-100;
  const Rational less = Rational(1) - Rational(tiny);
  EXPECT_EQ(volume_of(erosion(rod, box({0, 0, 0}, {tiny, tiny, tiny}), one_thread)),
            (Rational(1e39) - Rational(tiny)) * less * less);
  const Solid cube = box({0, 0, 0}, {0x1p70, 0x1p70, 0x1p70});
  const Rational side = Rational(0x1p70) - Rational(1);
  EXPECT_EQ(volume_of(erosion(cube, box({-3, 5, 0}, {-2, 6, 1}), one_thread)), side * side * side);
}

/// Of a tool in parts that are far from each other, all have to fit.
TEST(Erosion, ByAToolInParts) {
  const Solid rooms = box({0, 0, 0}, {3, 3, 3}) | box({10, 0, 0}, {13, 3, 3});
  const Solid tool = box({0, 0, 0}, {1, 1, 1}) | box({10, 0, 0}, {12, 1, 1});
  const Solid places = erosion(rooms, tool, one_thread);
  expect_same_set(places, box({0, 0, 0}, {1, 2, 2}));
  EXPECT_TRUE(erosion(box({0, 0, 0}, {3, 3, 3}), tool, one_thread).is_empty());
}

TEST(Erosion, AgreesWithPlacingTheToolAtSamplePoints) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(20U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Pieces pieces = pieces_on_grid(random);
    for (Points& p : pieces) {
      for (Point3& x : p) x = {4 * x.x, 4 * x.y, 4 * x.z};
    }
    const Solid a = solid_of(pieces);
    const Pieces tool = {piece_on_grid(random, 2 + below(random, 2))};
    const Solid eroded = erosion(a, solid_of(tool), one_thread);
    expect_valid(eroded);
    for (int i = 0; i < 20; ++i) {
      const Point3 t{below(random, 32) * 0.5 - 3.25, below(random, 32) * 0.5 - 3.25, below(random, 32) * 0.5 - 3.25};
      Points moved;
      for (const Point3& p : tool[0]) moved.push_back({p.x + t.x, p.y + t.y, p.z + t.z});
      const bool fits = (hull_of(moved) - a).is_empty();
      inside += fits ? 1 : 0;
      EXPECT_EQ(contains(eroded, t), fits);
    }
    // Opening: what the tool sweeps where it fits lies in the set.
    EXPECT_TRUE((sum_of(eroded, solid_of(tool)) - a).is_empty());
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GE(inside, test_cases(10));
}

}  // namespace quoin
