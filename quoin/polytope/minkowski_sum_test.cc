// SPDX-License-Identifier: Apache-2.0
//
// Sums of polytopes against the hull of all sums of vertices, in coordinates where these are doubles.
#include "quoin/polytope/minkowski_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"
#include "quoin/polytope/test_sums.h"

namespace quoin {
namespace {

using namespace test_polytopes;
/// Both orders of the arguments, compared with the hull.
Counts check_sum(const Points& a, const Points& b) {
  const Polytope p = Polytope::hull_of(a, one_thread);
  const Polytope q = Polytope::hull_of(b, one_thread);
  const PolytopeSum sum = minkowski_sum(p, q, one_thread);
  const Counts counts{sum.vertex_count(), sum.edge_count(), sum.facet_count()};
  if (sum.dimension == 3) {
    EXPECT_EQ(counts.vertices + counts.facets, counts.edges + 2);
  }
  const Cells expected = cells_of_hull(all_sums(std::array{a, b}));
  const Cells found = cells_of_sum(sum, exact_vertices(sum, p, q));
  EXPECT_EQ(found.facets.size(), sum.facet_count());
  EXPECT_EQ(found.vertices.size(), sum.vertex_count());
  EXPECT_EQ(found, expected);
  const PolytopeSum swapped = minkowski_sum(q, p, one_thread);
  EXPECT_EQ(cells_of_sum(swapped, exact_vertices(swapped, q, p)), expected);
  return counts;
}

// Minkowski thesis, sums with certain answers.
TEST(MinkowskiSum, KnownCounts) {
  EXPECT_EQ(check_sum(cube, cube), (Counts{8, 12, 6}));
  EXPECT_EQ(check_sum(octahedron, scaled(octahedron, 3)), (Counts{6, 12, 8}));
  EXPECT_EQ(check_sum(tetrahedron, scaled(tetrahedron, -1)), (Counts{12, 24, 14}));
  EXPECT_EQ(check_sum(cube, octahedron), (Counts{24, 48, 26}));
  EXPECT_EQ(check_sum(tetrahedron, cube), (Counts{16, 24, 10}));
}

/// By a quarter of a turn about the x axis, exactly.
Points turned(Points points) {
  for (Point3& p : points) p = {p.x, -p.z, p.y};
  return points;
}

// The same table: a pyramid over a polygon of sixteen sides, and its copy turned, share two normals of their bases; and
// ellipsoids of revolution, with rings of quadrilaterals that are planar whatever the radii.
TEST(MinkowskiSum, KnownCountsOfTurnedCopies) {
  Points pyramid{{0, -20, 0}};
  for (const auto& [x, z] : {std::pair{20, 0}, {18, 8}, {14, 14}, {8, 18}, {0, 20}}) {
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) pyramid.push_back({double(s * x), 0, double(t * z)});
    }
  }
  EXPECT_EQ(check_sum(pyramid, turned(pyramid)), (Counts{127, 247, 122}));
  EXPECT_EQ(check_sum(pyramid, pyramid), (Counts{17, 32, 17}));
  EXPECT_EQ(check_sum(icosahedron(), scaled(icosahedron(), 2)), (Counts{12, 30, 20}));

  constexpr double unit = 1e7;
  constexpr double part = 3.14159265358979323846 / 16;
  Points ellipsoid{{0, 0, 2 * unit * unit}, {0, 0, -2 * unit * unit}};
  for (int j = 1; j < 16; ++j) {
    const double radius = std::round(unit * std::sin(j * part));
    const double height = 2 * unit * std::round(unit * std::cos(j * part));
    for (int k = 0; k < 32; ++k) {
      ellipsoid.push_back(
          {radius * std::round(unit * std::cos(k * part)), radius * std::round(unit * std::sin(k * part)), height});
    }
  }
  const Polytope p = Polytope::hull_of(ellipsoid, one_thread);
  EXPECT_EQ((Counts{p.vertex_count(), p.edge_count(), p.facet_count()}), (Counts{482, 992, 512}));
  const Polytope q = Polytope::hull_of(turned(ellipsoid), one_thread);
  const PolytopeSum sum = minkowski_sum(p, q, one_thread);
  EXPECT_EQ((Counts{sum.vertex_count(), sum.edge_count(), sum.facet_count()}), (Counts{2258, 4576, 2320}));
}

TEST(MinkowskiSum, OfRandomPolytopesOnSmallGrids) {
  std::size_t ties = 0;
  std::size_t flat = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(4000U); ++seed) {
    Random random(seed);
    const auto draw = [&] { return on_a_small_grid(random, 4, 8); };
    const Points a = draw();
    Points b = seed % 7 == 0 ? a : seed % 7 == 1 ? scaled(a, -1) : seed % 7 == 2 ? scaled(a, 2) : draw();
    if (seed % 2 == 0) std::shuffle(b.begin(), b.end(), random);  // maps may be equal, and numbers not
    const int dimension_a = convex_hull(a, one_thread).dimension;
    const int dimension_b = convex_hull(b, one_thread).dimension;
    SCOPED_TRACE("seed " + std::to_string(seed));
    check_sum(a, b);
    if (HasFailure()) return;
    flat += dimension_a + dimension_b == 5 ? 1U : 0U;
    ties += minkowski_sum(Polytope::hull_of(a, one_thread), Polytope::hull_of(b, one_thread), one_thread).has_ties;
  }
  EXPECT_GT(ties, test_cases(2000U));
  EXPECT_GT(flat, test_cases(100U));
}

TEST(MinkowskiSum, OfPolytopesInGeneralPosition) {
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    Random random(seed);
    const auto draw = [&](int count) {
      Points points;
      std::normal_distribution<double> normal;
      for (int i = 0; i < count; ++i) {
        // Sums of two are doubles.
        const auto coordinate = [&] { return std::round(normal(random) * 0x1p20); };
        points.push_back({coordinate(), coordinate(), coordinate()});
      }
      return points;
    };
    SCOPED_TRACE("seed " + std::to_string(seed));
    check_sum(draw(4 + below(random, 60)), draw(4 + below(random, 60)));
    if (HasFailure()) return;
  }
}

// Prisms and pyramids over one polygon share edges, facets and planes.
TEST(MinkowskiSum, OfPrismsAndPyramids) {
  const std::vector<Point2> polygon{{4, 0}, {3, 3}, {0, 5}, {-2, 4}, {-4, 1}, {-3, -2}, {0, -4}, {3, -2}};
  Points prism;
  Points pyramid{{0, 0, 6}};
  Points slanted;
  Points flat;
  for (const Point2& p : polygon) {
    for (const double z : {0.0, 2.0}) {
      prism.push_back({p.x, p.y, z});
      slanted.push_back({p.x + z, p.y, z});
    }
    pyramid.push_back({p.x, p.y, 0});
    flat.push_back({p.x, p.y, 0});
  }
  const std::vector<Points> solids{prism, pyramid, slanted, cube, octahedron, tetrahedron, scaled(pyramid, -1)};
  for (const Points& a : solids) {
    for (const Points& b : solids) check_sum(a, b);
    check_sum(a, flat);
  }
}

// Each vertex of the sum is extreme in a direction in which both of its summands are; and in every direction the sum
// reaches as far as both together.
TEST(MinkowskiSum, SupportFunctionsAdd) {
  Random random(9);
  std::normal_distribution<double> normal;
  const auto draw = [&] {
    Points points;
    for (int i = 0; i < 200; ++i) {
      Point3 p{normal(random), normal(random), normal(random)};
      const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
      points.push_back({p.x / length, p.y / length, p.z / length});
    }
    return points;
  };
  const Points a = draw();
  const Points b = draw();
  const Polytope p = Polytope::hull_of(a, one_thread);
  const Polytope q = Polytope::hull_of(b, one_thread);
  const PolytopeSum sum = minkowski_sum(p, q, one_thread);
  const std::vector<RationalPoint3> vertices = exact_vertices(sum, p, q);
  for (int i = 0; i < 50; ++i) {
    const RationalPoint3 direction{Rational(normal(random)), Rational(normal(random)), Rational(normal(random))};
    const auto reach = [&](const auto& points) {
      Rational most = dot(direction, points[0]);
      for (const auto& point : points) most = std::max(most, dot(direction, point));
      return most;
    };
    const auto rationals = [](const Points& points) {
      std::vector<RationalPoint3> result;
      for (const Point3& point : points) result.push_back(exact_point(point));
      return result;
    };
    EXPECT_EQ(reach(vertices), reach(rationals(a)) + reach(rationals(b)));
  }
}

// Points, segments, polygons and solids in all pairs; at times of one flat, or one a multiple of the other.
TEST(MinkowskiSum, OfEveryTwoDimensions) {
  std::array<std::array<int, 4>, 4> seen{};
  std::array<int, 4> sums{};
  for (std::uint64_t seed = 0; seed < test_rounds(8000U); ++seed) {
    Random random(seed);
    const Points a = on_a_small_flat(random, static_cast<int>(seed % 4));
    Points b = on_a_small_flat(random, static_cast<int>(seed / 4 % 4));
    const int kind = below(random, 8);
    if (kind == 0) b = scaled(a, below(random, 2) == 0 ? -1 : 2);
    if (kind == 1) {
      // Some points of the other, turned in its flat.
      b.clear();
      for (std::size_t i = 0; i < a.size(); i += 1 + static_cast<std::size_t>(below(random, 2))) {
        const Point3& p = a[i];
        const Point3& q = a[a.size() / 2];
        b.push_back({3 * p.x - 2 * q.x, 3 * p.y - 2 * q.y, 3 * p.z - 2 * q.z});
      }
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    check_sum(a, b);
    if (HasFailure()) return;
    const Polytope p = Polytope::hull_of(a, one_thread);
    const Polytope q = Polytope::hull_of(b, one_thread);
    ++seen.at(static_cast<std::size_t>(p.dimension())).at(static_cast<std::size_t>(q.dimension()));
    if (p.dimension() == 2 && q.dimension() == 2) {
      ++sums.at(static_cast<std::size_t>(minkowski_sum(p, q, one_thread).dimension));
    }
  }
  for (const auto& row : seen) {
    for (const int count : row) EXPECT_GE(count, test_cases(200));
  }
  EXPECT_GE(sums[2], test_cases(40));
  EXPECT_GE(sums[3], test_cases(40));
}

/// Facets as rings of pairs of points, from the smallest.
using PairFacets = std::set<std::vector<std::array<std::uint32_t, 2>>>;

PairFacets pairs_by_hull(const Points& a, const Points& b, int& dimension) {
  std::vector<RationalPoint3> sums;
  for (const Point3& p : a) {
    for (const Point3& q : b) sums.push_back(exact_point(p) + exact_point(q));
  }
  const ConvexHull hull = convex_hull(sums, one_thread);
  dimension = hull.dimension;
  const auto width = static_cast<std::uint32_t>(b.size());
  PairFacets facets;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    std::vector<std::array<std::uint32_t, 2>> facet;
    for (const std::uint32_t v : hull.facet(f)) facet.push_back({v / width, v % width});
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    facets.insert(facet);
  }
  return facets;
}

// Doubles of all sizes, whose sums are none: flats of small integers, each coordinate times a power of two, and some
// points off by the least that doubles can be. The hull is of rationals.
TEST(MinkowskiSum, OfDoublesOfAllSizes) {
  std::array<int, 4> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(200U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto power = [&](int most) { return std::ldexp(1.0, below(random, 2 * most + 1) - most); };
    const int most = seed % 3 == 0 ? 990 : seed % 3 == 1 ? 60 : 1;
    const Point3 common{power(most), power(most), power(most)};
    const auto draw = [&] {
      Points points = on_a_small_flat(random, below(random, 4));
      const bool is_shared = below(random, 2) == 0;
      const Point3 own{power(most), power(most), power(most)};
      for (Point3& p : points) {
        const Point3& scale = is_shared ? common : own;
        p = {p.x * scale.x, p.y * scale.y, p.z * scale.z};
        if (below(random, 6) == 0) p.y = std::nextafter(p.y, 1e300);
      }
      // The first of equal points alone, so that pairs are unique.
      Points unique;
      for (const Point3& p : points) {
        if (std::find(unique.begin(), unique.end(), p) == unique.end()) unique.push_back(p);
      }
      return unique;
    };
    const Points a = draw();
    const Points b = draw();
    const Polytope p = Polytope::hull_of(a, one_thread);
    const Polytope q = Polytope::hull_of(b, one_thread);
    const PolytopeSum sum = minkowski_sum(p, q, one_thread);
    int dimension = -1;
    const PairFacets expected = pairs_by_hull(a, b, dimension);
    ASSERT_EQ(sum.dimension, dimension);
    PairFacets found;
    for (std::size_t f = 0; f < sum.facet_count(); ++f) {
      std::vector<std::array<std::uint32_t, 2>> facet;
      for (const std::uint32_t v : sum.facet(f)) {
        facet.push_back({p.source(sum.vertices[v][0]), q.source(sum.vertices[v][1])});
      }
      std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
      found.insert(facet);
    }
    ASSERT_EQ(found, expected);
    ++seen.at(static_cast<std::size_t>(dimension));
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(4));
}

TEST(MinkowskiSum, MayBeCancelled) {
  const Polytope solid = Polytope::hull_of(cube, one_thread);
  const Polytope other = Polytope::hull_of(octahedron, one_thread);
  const Polytope segment = Polytope::hull_of(Points{{0, 0, 0}, {1, 2, 3}}, one_thread);
  Context context({.threads = 1});
  context.cancel();
  EXPECT_THROW(minkowski_sum(solid, other, context), Cancelled);
  EXPECT_THROW(minkowski_sum(solid, segment, context), Cancelled);
  EXPECT_THROW(minkowski_sum(segment, segment, context), Cancelled);
  EXPECT_THROW(minkowski_sum(std::vector<Polytope>{segment, segment}, context), Cancelled);
  EXPECT_THROW(Polytope::hull_of(std::vector<RationalPoint3>{{0, 0, Rational(1) / Rational(3)}, {0, 1, 0}}, context),
               Cancelled);
}

TEST(MinkowskiSum, OfFlatOperands) {
  const Points segment{{0, 0, 0}, {0, 0, 1}};
  const Points square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Points upright{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  const Points slanted{{0, 0, 0}, {1, 2, 3}, {2, 1, 5}};
  EXPECT_EQ(check_sum(segment, segment), (Counts{2, 1, 0}));
  EXPECT_EQ(check_sum(segment, scaled(segment, -3)), (Counts{2, 1, 0}));
  EXPECT_EQ(check_sum(segment, Points{{0, 0, 0}, {1, 1, 0}}), (Counts{4, 4, 1}));
  EXPECT_EQ(check_sum(square, segment), (Counts{8, 12, 6}));
  EXPECT_EQ(check_sum(square, square), (Counts{4, 4, 1}));
  EXPECT_EQ(check_sum(square, Points{{0, 0, 0}, {1, 1, 0}}), (Counts{6, 6, 1}));
  EXPECT_EQ(check_sum(square, upright), (Counts{8, 12, 6}));
  EXPECT_EQ(check_sum(square, slanted), (Counts{11, 19, 10}));
  EXPECT_EQ(check_sum(cube, segment), (Counts{8, 12, 6}));
  EXPECT_EQ(check_sum(cube, Points{{0, 0, 0}, {1, 2, 3}}), (Counts{14, 24, 12}));
  EXPECT_EQ(check_sum(Points{{3, 4, 5}}, Points{{1, 1, 1}}), (Counts{1, 0, 0}));
  EXPECT_EQ(check_sum(cube, Points{{3, 4, 5}}), (Counts{8, 12, 6}));
  EXPECT_THROW(Polytope::hull_of(Points{}, one_thread), InputError);
}

}  // namespace
}  // namespace quoin
