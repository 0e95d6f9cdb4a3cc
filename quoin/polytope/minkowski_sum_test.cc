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
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;
using Corner = std::array<double, 3>;
using Facets = std::set<std::vector<Corner>>;

/// From the smallest corner on.
std::vector<Corner> rotated(std::vector<Corner> facet) {
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  return facet;
}

Facets facets_by_hull(const Points& a, const Points& b) {
  Points sums;
  for (const Point3& p : a) {
    for (const Point3& q : b) sums.push_back({p.x + q.x, p.y + q.y, p.z + q.z});
  }
  const ConvexHull hull = convex_hull(sums, one_thread);
  Facets facets;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    std::vector<Corner> facet;
    for (const std::uint32_t v : hull.facet(f)) facet.push_back({sums[v].x, sums[v].y, sums[v].z});
    facets.insert(rotated(facet));
  }
  return facets;
}

Facets facets_of(const PolytopeSum& sum, const Polytope& p, const Polytope& q) {
  Facets facets;
  for (std::size_t f = 0; f < sum.facet_count(); ++f) {
    std::vector<Corner> facet;
    for (const std::uint32_t v : sum.facet(f)) {
      const Point3& a = p.vertex(sum.vertices[v][0]);
      const Point3& b = q.vertex(sum.vertices[v][1]);
      facet.push_back({a.x + b.x, a.y + b.y, a.z + b.z});
    }
    facets.insert(rotated(facet));
  }
  return facets;
}

struct Counts {
  std::size_t vertices;
  std::size_t edges;
  std::size_t facets;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.vertices << "/" << c.edges << "/" << c.facets;
  }
};

/// Both orders of the arguments, compared with the hull.
Counts check_sum(const Points& a, const Points& b) {
  const Polytope p = Polytope::hull_of(a, one_thread);
  const Polytope q = Polytope::hull_of(b, one_thread);
  const PolytopeSum sum = minkowski_sum(p, q, one_thread);
  const Counts counts{sum.vertices.size(), sum.edge_count(), sum.facet_count()};
  EXPECT_EQ(counts.vertices + counts.facets, counts.edges + 2);
  const Facets expected = facets_by_hull(a, b);
  const Facets found = facets_of(sum, p, q);
  EXPECT_EQ(found.size(), sum.facet_count());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(facets_of(minkowski_sum(q, p, one_thread), q, p), expected);
  return counts;
}

Points scaled(Points points, double factor) {
  for (Point3& p : points) p = {p.x * factor, p.y * factor, p.z * factor};
  return points;
}

const Points cube{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
const Points octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const Points tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

// Minkowski thesis, sums with certain answers.
TEST(MinkowskiSum, KnownCounts) {
  EXPECT_EQ(check_sum(cube, cube), (Counts{8, 12, 6}));
  EXPECT_EQ(check_sum(octahedron, scaled(octahedron, 3)), (Counts{6, 12, 8}));
  EXPECT_EQ(check_sum(tetrahedron, scaled(tetrahedron, -1)), (Counts{12, 24, 14}));
  EXPECT_EQ(check_sum(cube, octahedron), (Counts{24, 48, 26}));
  EXPECT_EQ(check_sum(tetrahedron, cube), (Counts{16, 24, 10}));
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
    if (dimension_a < 2 || dimension_b < 2 || dimension_a + dimension_b < 5) continue;
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

TEST(MinkowskiSum, RefusesTwoFlatPolytopes) {
  const Polytope square = Polytope::hull_of(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, one_thread);
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_THROW(minkowski_sum(square, square, one_thread), InputError);
  EXPECT_THROW(Polytope::hull_of(Points{{0, 0, 0}, {1, 1, 1}}, one_thread), InputError);
}

}  // namespace
}  // namespace quoin
