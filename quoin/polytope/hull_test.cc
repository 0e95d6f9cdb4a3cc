// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

/// Empty outside: facets turn left and no point is beyond them; closed: each edge once in both directions; Euler;
/// corners are the vertices; canonical order.
void check_solid_hull(const Points& points, const ConvexHull& hull) {
  ASSERT_EQ(hull.dimension, 3);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::set<std::uint32_t> corners;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    ASSERT_GE(facet.size(), 3U);
    ASSERT_EQ(facet[0], *std::min_element(facet.begin(), facet.end()));
    ASSERT_TRUE(f == 0 || std::ranges::lexicographical_compare(hull.facet(f - 1), facet));
    for (std::size_t i = 0; i < facet.size(); ++i) {
      ASSERT_TRUE(edges.emplace(facet[i], facet[(i + 1) % facet.size()]).second);
      corners.insert(facet[i]);
    }
    for (const Point3& p : points) {
      ASSERT_NE(orientation(points[facet[0]], points[facet[1]], points[facet[2]], p), Sign::positive);
    }
  }
  for (const auto& [a, b] : edges) ASSERT_TRUE(edges.contains({b, a}));
  ASSERT_EQ(corners.size() + hull.facet_count(), edges.size() / 2 + 2);
  ASSERT_TRUE(std::ranges::equal(corners, hull.vertices));
  // Maximal facets: the next facet across each edge is in another plane.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> facet_at;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    for (std::size_t i = 0; i < facet.size(); ++i) facet_at[{facet[i], facet[(i + 1) % facet.size()]}] = f;
  }
  for (const auto& [edge, f] : facet_at) {
    const auto facet = hull.facet(f);
    const auto other = hull.facet(facet_at[{edge.second, edge.first}]);
    const bool is_coplanar = std::ranges::all_of(other, [&](std::uint32_t v) {
      return orientation(points[facet[0]], points[facet[1]], points[facet[2]], points[v]) == Sign::zero;
    });
    ASSERT_FALSE(is_coplanar);
  }
  // The first of equal points, and strict corners.
  for (const std::uint32_t v : hull.vertices) {
    ASSERT_EQ(std::find(points.begin(), points.end(), points[v]) - points.begin(), v);
  }
}

/// Facets by definition: planes through three points with all others on one side; each with the points on it that are
/// vertices, as a set.
std::set<std::set<std::uint32_t>> facets_by_definition(const Points& points) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::set<std::set<std::uint32_t>> flats;
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = b + 1; c < n; ++c) {
        std::set<std::uint32_t> on;
        bool has_positive = false;
        bool has_negative = false;
        for (std::uint32_t d = 0; d < n; ++d) {
          const Sign side = orientation(points[a], points[b], points[c], points[d]);
          has_positive = has_positive || side == Sign::positive;
          has_negative = has_negative || side == Sign::negative;
          if (side == Sign::zero) on.insert(d);
        }
        if (has_positive != has_negative) flats.insert(on);
      }
    }
  }
  return flats;
}

void check_against_definition(const Points& points, const ConvexHull& hull) {
  std::set<std::set<std::uint32_t>> expected;
  for (const std::set<std::uint32_t>& flat : facets_by_definition(points)) {
    std::set<std::uint32_t> corners;
    std::ranges::set_intersection(flat, hull.vertices, std::inserter(corners, corners.end()));
    expected.insert(corners);
  }
  std::set<std::set<std::uint32_t>> found;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    found.emplace(facet.begin(), facet.end());
  }
  ASSERT_EQ(found, expected);
}

void check(const Points& points) {
  const ConvexHull hull = convex_hull(points, one_thread);
  if (hull.dimension == 3) {
    ASSERT_NO_FATAL_FAILURE(check_solid_hull(points, hull));
    if (points.size() < 14) check_against_definition(points, hull);
    return;
  }
  for (std::size_t i = 0; i + 3 < points.size() && points.size() < 40; ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        ASSERT_EQ(orientation(points[0], points[i], points[j], points[k]), Sign::zero);
      }
    }
  }
}

struct Counts {
  std::size_t vertices;
  std::size_t edges;
  std::size_t facets;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts(const Points& points) {
  const ConvexHull hull = convex_hull(points, one_thread);
  check_solid_hull(points, hull);
  return {hull.vertices.size(), hull.corners.size() / 2, hull.facet_count()};
}

Points grid(int size) {
  Points points;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) points.push_back({double(x), double(y), double(z)});
    }
  }
  return points;
}

// Minkowski thesis, table of basic solids: octahedron 6/12/8; icosahedron (0, +-a, +-b) 12/30/20.
TEST(ConvexHull, BasicSolids) {
  EXPECT_EQ(counts({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}), (Counts{6, 12, 8}));
  EXPECT_EQ(counts(grid(2)), (Counts{8, 12, 6}));
  EXPECT_EQ(counts(grid(5)), (Counts{8, 12, 6}));
  EXPECT_EQ(counts(icosahedron()), (Counts{12, 30, 20}));
  Points cuboctahedron;
  for (const Point3& p : grid(3)) {
    const double x = p.x - 1;
    const double y = p.y - 1;
    const double z = p.z - 1;
    if (std::fabs(x) + std::fabs(y) + std::fabs(z) == 2) cuboctahedron.push_back({x, y, z});
  }
  EXPECT_EQ(counts(cuboctahedron), (Counts{12, 24, 14}));
}

TEST(ConvexHull, EveryDimension) {
  EXPECT_EQ(convex_hull(Points{}, one_thread).dimension, -1);
  const ConvexHull point = convex_hull(Points{{1, 2, 3}, {1, 2, 3}}, one_thread);
  EXPECT_EQ(point.dimension, 0);
  EXPECT_EQ(point.vertices, (std::vector<std::uint32_t>{0}));
  const ConvexHull segment = convex_hull(Points{{1, 1, 1}, {3, 3, 3}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}}, one_thread);
  EXPECT_EQ(segment.dimension, 1);
  EXPECT_EQ(segment.vertices, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(segment.facet_count(), 0U);
  // In the plane x = 5; seen from larger x, y and z turn left.
  const ConvexHull square =
      convex_hull(Points{{5, 0, 0}, {5, 1, 1}, {5, 1, 0}, {5, 0, 1}, {5, 0.5, 0.5}, {5, 0.5, 0}}, one_thread);
  EXPECT_EQ(square.dimension, 2);
  ASSERT_EQ(square.facet_count(), 1U);
  EXPECT_TRUE(std::ranges::equal(square.facet(0), std::array{0U, 2U, 1U, 3U}));
  EXPECT_EQ(square.vertices, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(ConvexHull, OfSmallSubsetsOfALattice) {
  const Points lattice = grid(3);
  for (std::uint64_t seed = 0; seed < test_rounds(6000U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Points points;
    const int count = 1 + below(random, 11);
    for (int i = 0; i < count; ++i) points.push_back(lattice[random() % lattice.size()]);
    ASSERT_NO_FATAL_FAILURE(check(points));
  }
}

TEST(ConvexHull, OfManyPointsInManyPositions) {
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::normal_distribution<double> normal;
    Points points;
    const int count = 50 + below(random, 3000);
    for (int i = 0; i < count; ++i) {
      Point3 p{normal(random), normal(random), normal(random)};
      const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
      switch (seed % 6) {
        case 0:  // on a sphere
          p = {p.x / length, p.y / length, p.z / length};
          break;
        case 1:  // on a sphere and an integer grid: cospherical and coplanar
          p = {std::round(9 * p.x / length), std::round(9 * p.y / length), std::round(9 * p.z / length)};
          break;
        case 2:  // nearly in a plane
          p.z = std::ldexp(std::round(p.z), -50);
          break;
        case 3:  // far from the origin, where doubles are few
          p = {std::round(4 * p.x) + 0x1p52, std::round(4 * p.y) + 0x1p52, std::round(4 * p.z) - 0x1p52};
          break;
        case 4:  // a cone of many sizes
          p = {std::ldexp(p.x, -i % 60), std::ldexp(p.y, -i % 60), std::ldexp(1.0, -i % 60)};
          break;
        default:
          break;
      }
      points.push_back(p);
    }
    ASSERT_NO_FATAL_FAILURE(check(points));
  }
}

// No double lies between the two layers: no point inside can be one.
TEST(ConvexHull, OfTwoLayersWithNothingBetween) {
  Random random(3);
  std::normal_distribution<double> normal;
  const double low = 1;
  const double high = std::nextafter(low, 2.0);
  Points points;
  for (int i = 0; i < 400; ++i) {
    const double angle = normal(random) * 7;
    points.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? low : high});
  }
  ASSERT_NO_FATAL_FAILURE(check(points));
}

TEST(ConvexHull, AtTheEndsOfTheRangeOfDoubles) {
  for (const double size : {0x1p-1074, 0x1p-1060, 0x1p-600, 0x1p-200, 0x1p300, 0x1p600, 0x1p1022}) {
    Points points;
    for (const Point3& p : grid(3)) points.push_back({(p.x - 1) * size, (p.y - 1) * size, (p.z - 1) * size});
    SCOPED_TRACE(size);
    EXPECT_EQ(counts(points), (Counts{8, 12, 6}));
  }
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(counts({{most, 0, 0}, {-most, 0, 0}, {0, most, 0}, {0, -most, 0}, {0, 0, most}, {0, 0, -most}, {0, 0, 0}}),
            (Counts{6, 12, 8}));
  EXPECT_EQ(counts({{1e300, 0, 0}, {0, 1, 0}, {0, 0, 1e-300}, {0, 0, 0}}), (Counts{4, 6, 4}));
}

// Of a tiny triangle, what its normal loses below the range of doubles is large at points far away.
TEST(ConvexHull, TinyTrianglesSeeHugePointsRightly) {
  for (std::uint64_t seed = 0; seed < test_rounds(100U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto draw = [&] {
      const double x = below(random, 1 << 20) - (1 << 19);
      const double y = below(random, 1 << 20) - (1 << 19);
      return Point3{x, y, double(below(random, 1 << 20) - (1 << 19))};
    };
    const auto scaled = [](const Point3& p, int exponent) {
      return Point3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    };
    const Point3 v = draw();
    const Point3 w = draw();
    Points points{{0, 0, 0}, scaled(v, -545), scaled(w, -545), scaled(draw(), -545)};
    if (orientation(points[0], points[1], points[2], points[3]) == Sign::zero) continue;
    // In the plane of the first three, or a little off it.
    for (int i = 0; i < 8; ++i) {
      const int a = below(random, 99) - 49;
      const int b = below(random, 99) - 49;
      points.push_back(scaled({a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z + i % 3 - 1}, 960));
    }
    const HullBuilder builder(points, one_thread);
    for (std::uint32_t t = 0; t < builder.triangles().size(); ++t) {
      const auto& [a, b, c] = builder.triangles()[t].corners;
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        ASSERT_EQ(builder.side(t, p), orientation(points[a], points[b], points[c], points[p]));
      }
    }
    ASSERT_NO_FATAL_FAILURE(check(points));
  }
}

// The hull is a set: the order of the points, and how they are scaled, say nothing.
TEST(ConvexHull, PermutationsAndScalesGiveTheSame) {
  for (std::uint64_t seed = 0; seed < test_rounds(200U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Points points;
    const int count = 4 + below(random, 60);
    const int size = 2 + below(random, 9);
    for (int i = 0; i < count; ++i) {
      points.push_back({double(below(random, size)), double(below(random, size)), double(below(random, size))});
    }
    const ConvexHull hull = convex_hull(points, one_thread);
    const auto as_points = [](const Points& list, const ConvexHull& h) {
      std::set<std::vector<std::array<double, 3>>> facets;
      for (std::size_t f = 0; f < h.facet_count(); ++f) {
        std::vector<std::array<double, 3>> facet;
        for (const std::uint32_t v : h.facet(f)) facet.push_back({list[v].x, list[v].y, list[v].z});
        std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
        facets.insert(facet);
      }
      return facets;
    };
    Points shuffled(points);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    ASSERT_EQ(as_points(points, hull), as_points(shuffled, convex_hull(shuffled, one_thread)));
    Points scaled(points);
    for (Point3& p : scaled) p = {std::ldexp(p.x, 100), std::ldexp(p.y, 100), std::ldexp(p.z, 100)};
    const ConvexHull same = convex_hull(scaled, Context({.threads = 2}));
    ASSERT_EQ(hull.corners, same.corners);
    ASSERT_EQ(hull.facet_begin, same.facet_begin);
    ASSERT_EQ(hull.vertices, same.vertices);
  }
}

TEST(ConvexHull, InThePlane) {
  const ConvexHull square =
      convex_hull(std::vector<Point2>{{1, 1}, {0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}, {0.5, 0}, {0, 0}}, one_thread);
  EXPECT_EQ(square.dimension, 2);
  EXPECT_EQ(square.corners, (std::vector<std::uint32_t>{1, 2, 2, 0, 0, 3, 3, 1}));
  EXPECT_EQ(convex_hull(std::vector<Point2>{}, one_thread).dimension, -1);
  EXPECT_EQ(convex_hull(std::vector<Point2>{{2, 2}, {2, 2}}, one_thread).dimension, 0);
  EXPECT_EQ(convex_hull(std::vector<Point2>{{2, 2}, {3, 3}, {1, 1}}, one_thread).vertices,
            (std::vector<std::uint32_t>{1, 2}));
  for (std::uint64_t seed = 0; seed < test_rounds(500U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Point2> points;
    const int count = 3 + below(random, 40);
    const int size = 2 + below(random, 30);
    for (int i = 0; i < count; ++i) points.push_back({double(below(random, size)), double(below(random, size))});
    const ConvexHull hull = convex_hull(points, one_thread);
    if (hull.dimension < 2) continue;
    for (std::size_t f = 0; f < hull.facet_count(); ++f) {
      const auto edge = hull.facet(f);
      ASSERT_EQ(edge[1], hull.facet((f + 1) % hull.facet_count())[0]);
      const std::uint32_t next = hull.facet((f + 1) % hull.facet_count())[1];
      ASSERT_EQ(orientation(points[edge[0]], points[edge[1]], points[next]), Sign::positive);
      for (const Point2& p : points) ASSERT_NE(orientation(points[edge[0]], points[edge[1]], p), Sign::negative);
    }
  }
}

TEST(ConvexHull, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  try {
    convex_hull(Points{{0, 0, 0}, {1, nan, 0}}, one_thread);
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "point 1 has a coordinate that is not finite");
  }
  EXPECT_THROW(convex_hull(std::vector<Point2>{{0, std::numeric_limits<double>::infinity()}}, one_thread), InputError);
}

TEST(ConvexHull, MayBeCancelled) {
  Points points;
  Random random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100000; ++i) points.push_back({normal(random), normal(random), normal(random)});
  Context context({.threads = 1});
  context.cancel();
  EXPECT_THROW(convex_hull(points, context), Cancelled);
}

}  // namespace
}  // namespace quoin
