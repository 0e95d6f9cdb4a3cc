// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/stable_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_chains.h"
#include "quoin/flow/flow_orbit.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/unstable_arcs.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;
using Counts = std::array<std::size_t, 4>;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

std::vector<std::uint32_t> critical_polygons(const FlowComplex& flow) {
  std::vector<std::uint32_t> found;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    if (face.dimension == 2) found.push_back(face.index);
  }
  return found;
}

std::string text(const RationalPoint3& p) {
  return p.x.to_string() + " " + p.y.to_string() + " " + p.z.to_string();
}

std::set<std::string> texts(StableSurface& surface) {
  std::set<std::string> all;
  for (std::uint32_t i = 0; i < surface.points.size(); ++i) all.insert(text(surface.points.exact(i)));
  return all;
}

std::multiset<unsigned> depths(const StableSurface& surface) {
  std::multiset<unsigned> all;
  for (const StableSide& side : surface.sides) all.insert(side.depth);
  return all;
}

/// Twice the sum of the areas of triangles in the plane z = 0.
Rational twice_flat_area(const FlowComplex& flow, StableSurface& surface) {
  Rational sum;
  for (const StableTriangle& t : surface.triangles) {
    const RationalPoint3 apex = exact_point(flow.point(t.vertex));
    sum += abs(cross(surface.points.exact(t.towards) - apex, surface.points.exact(t.from) - apex).z);
  }
  return sum;
}

TEST(StableSurface, Kite) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, -10, 0}});
  EXPECT_EQ(flow.counts(), (Counts{4, 4, 1, 0}));
  StableSurface surface = stable_surface(flow, critical_polygons(flow).front(), context());
  EXPECT_TRUE(surface.is_ordinary());
  EXPECT_EQ(surface.triangles.size(), 10U);
  EXPECT_EQ(twice_flat_area(flow, surface), Rational(96));
  EXPECT_EQ(depths(surface), (std::multiset<unsigned>{1, 1, 2, 2}));
  EXPECT_EQ(texts(surface), (std::set<std::string>{"0 -21/5 0", "0 -3 0", "2 1 0", "-2 1 0", "2 -5 0", "-2 -5 0"}));
}

TEST(StableSurface, BentKite) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 1}, {0, -10, 0}});
  EXPECT_EQ(flow.counts(), (Counts{4, 4, 1, 0}));
  StableSurface surface = stable_surface(flow, critical_polygons(flow).front(), context());
  EXPECT_EQ(surface.triangles.size(), 10U);
  EXPECT_EQ(texts(surface),
            (std::set<std::string>{"0 -21/5 0", "0 -11/4 0", "2 1 1/2", "-2 1 1/2", "2 -5 0", "-2 -5 0"}));
}

/// Sum of triangles over all surfaces, where each side is reached in one segment.
std::size_t triangles_of_depth_1(const FlowComplex& flow) {
  std::size_t sum = 0;
  for (const std::uint32_t f : critical_polygons(flow)) {
    const StableSurface surface = stable_surface(flow, f, context());
    EXPECT_TRUE(surface.is_ordinary());
    for (const StableSide& side : surface.sides) EXPECT_EQ(side.depth, 1U);
    sum += surface.triangles.size();
  }
  return sum;
}

TEST(StableSurface, CubesAndOctahedra) {
  std::vector<Point3> cube = testing::lattice(2, 2, 2);
  for (Point3& p : cube) p = {2 * p.x, 2 * p.y, 2 * p.z};
  const FlowComplex flow = flow_complex(cube);
  EXPECT_EQ(triangles_of_depth_1(flow), 48U);
  ArcTracer tracer(flow);
  for (const std::uint32_t f : critical_polygons(flow)) {
    const UnstableArcs both = tracer.trace(f, context());
    EXPECT_EQ(both.arcs[0].is_infinite + both.arcs[1].is_infinite, 1);
    for (const UnstableArc& arc : both.arcs) {
      EXPECT_EQ(arc.segments, 1U);
      if (!arc.is_infinite) {
        EXPECT_TRUE(flow.is_critical(arc.end));
        EXPECT_EQ(text(flow.centre(arc.end)), "1 1 1");
      }
    }
  }
  EXPECT_EQ(triangles_of_depth_1(flow_complex({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})),
            48U);
  EXPECT_EQ(triangles_of_depth_1(flow_complex(testing::lattice(3, 3, 3))), 288U);
  std::vector<Point3> centred = cube;
  centred.push_back({1, 1, 1});
  EXPECT_EQ(triangles_of_depth_1(flow_complex(centred)), 72U);
  for (const Point3& p : {Point3{1, 1, 0}, {1, 1, 2}, {1, 0, 1}, {1, 2, 1}, {0, 1, 1}, {2, 1, 1}}) cube.push_back(p);
  EXPECT_EQ(triangles_of_depth_1(flow_complex(cube)), 192U);
}

// A way from a Voronoi vertex ends in the saddle, so the surface goes through the vertex and is said to.
TEST(StableSurface, ThroughVoronoiVertex) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 1}, {0, 2, -1}, {0, -10, 0}});
  const std::vector<std::uint32_t> polygons = critical_polygons(flow);
  std::size_t flagged = 0;
  for (const std::uint32_t f : polygons) {
    const StableSurface surface = stable_surface(flow, f, context());
    if (surface.is_ordinary()) continue;
    ++flagged;
    EXPECT_EQ(text(flow.centre({2, f})), "0 -21/5 0");
    EXPECT_TRUE(surface.has_voronoi_vertex);
    EXPECT_TRUE(surface.has_solid_part);
  }
  EXPECT_EQ(flagged, 1U);
  const FlowChains chains = flow_chains(flow, context());
  EXPECT_EQ(chains.surfaces_not_ordinary.size(), 1U);
  EXPECT_EQ(chains.arcs_not_ordinary.size(), 2U);
}

TEST(StableSurface, RefusesWhatIsNotCritical) {
  const FlowComplex flow = flow_complex({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}});
  EXPECT_THROW(stable_surface(flow, 0, context()), InputError);
  EXPECT_THROW(stable_surface(flow, 7, context()), InputError);
  ArcTracer tracer(flow);
  EXPECT_THROW(tracer.trace(0, context()), InputError);
}

/// Edges of triangles that are there an odd number of times: pairs of an input point and a point, or of two points.
using Ends = std::pair<long, long>;
std::set<Ends> boundary(const StableSurface& surface) {
  std::set<Ends> odd;
  const auto flip = [&](long a, long b) {
    const Ends ends{std::min(a, b), std::max(a, b)};
    if (!odd.erase(ends)) odd.insert(ends);
  };
  for (const StableTriangle& t : surface.triangles) {
    const long vertex = -1 - static_cast<long>(t.vertex);
    flip(vertex, t.towards);
    flip(vertex, t.from);
    flip(t.towards, t.from);
  }
  return odd;
}

/// The halves of the critical edges that are its sides.
std::set<Ends> halves_of_sides(const FlowComplex& flow, const StableSurface& surface) {
  std::set<Ends> halves;
  for (const StableSide& side : surface.sides) {
    EXPECT_TRUE(flow.is_critical({1, side.edge}));
    for (const std::uint32_t v : flow.faces().edge(side.edge)) {
      const Ends half{-1 - static_cast<long>(v), static_cast<long>(side.point)};
      if (!halves.erase(half)) halves.insert(half);
    }
  }
  return halves;
}

// Points of the triangles flow to the saddle, first to the point that the triangle says; behind a stationary point that
// is not critical, only as far as that.
void check_points(const FlowComplex& flow, StableSurface& surface, std::size_t samples) {
  const Rational third = Rational(1) / Rational(3);
  const auto check_end = [&](DeloneFace end) {
    const bool is_stopped = surface.has_regular_point && flow.kind(end) == FlowKind::regular;
    ASSERT_TRUE(is_stopped || end == (DeloneFace{2, surface.polygon}));
  };
  for (std::size_t i = 0; i < std::min(samples, surface.triangles.size()); ++i) {
    const StableTriangle& t = surface.triangles[i * surface.triangles.size() / samples % surface.triangles.size()];
    const RationalPoint3 towards = surface.points.exact(t.towards);
    const RationalPoint3 from = surface.points.exact(t.from);
    FlowOrbit middle = flow_orbit(flow, (towards + from) * (Rational(1) / Rational(2)), context());
    ASSERT_GE(middle.points.size(), 2U);
    ASSERT_EQ(middle.points.exact(1), towards);
    ASSERT_NO_FATAL_FAILURE(check_end(middle.end));
    const RationalPoint3 inside = (towards + from + exact_point(flow.point(t.vertex))) * third;
    ASSERT_NO_FATAL_FAILURE(check_end(flow_orbit(flow, inside, context()).end));
  }
}

TEST(StableSurface, PointsFlowToTheSaddle) {
  Random random(81);
  std::size_t deep = 0;
  for (int round = 0; round < test_rounds(12); ++round) {
    const std::size_t count = 14 + random() % 11;
    const std::vector<Point3> points = testing::random_points(
        random, count, [](Random& r) { return std::uniform_real_distribution<double>(0, 1000)(r); });
    const FlowComplex flow = flow_complex(points);
    for (const std::uint32_t f : critical_polygons(flow)) {
      StableSurface surface = stable_surface(flow, f, context());
      ASSERT_TRUE(surface.is_ordinary());
      ASSERT_EQ(boundary(surface), halves_of_sides(flow, surface));
      ASSERT_NO_FATAL_FAILURE(check_points(flow, surface, 5));
      deep += surface.triangles.size() > 6 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, test_cases(20U));
}

struct Seen {
  std::size_t ordinary = 0;
  std::size_t deep = 0;  // of these, with sides that are not the polygon's
  // Of the others:
  std::size_t through_vertices = 0;
  std::size_t behind_regular_points = 0;
  std::size_t open = 0;  // with a boundary that is not that of their sides
};

// Of all surfaces of some points: one that is not bounded by critical edges is flagged.
void check_surfaces(const std::vector<Point3>& points, std::size_t samples, Seen& seen) {
  const FlowComplex flow = flow_complex(points);
  for (const std::uint32_t f : critical_polygons(flow)) {
    StableSurface surface = stable_surface(flow, f, context());
    ASSERT_NO_FATAL_FAILURE(check_points(flow, surface, samples));
    const bool is_bounded = boundary(surface) == halves_of_sides(flow, surface);
    ASSERT_TRUE(is_bounded || !surface.is_ordinary());
    const bool is_deep =
        std::any_of(surface.sides.begin(), surface.sides.end(), [](const StableSide& side) { return side.depth > 1; });
    seen.ordinary += surface.is_ordinary() ? 1 : 0;
    seen.deep += surface.is_ordinary() && is_deep ? 1 : 0;
    seen.through_vertices += surface.has_voronoi_vertex ? 1 : 0;
    seen.behind_regular_points += surface.has_regular_point ? 1 : 0;
    seen.open += is_bounded ? 0 : 1;
  }
}

TEST(StableSurface, OfDegeneratePointsIsBoundedByCriticalEdgesOrFlagged) {
  Random random(84);
  Seen seen;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 8)) {
    SCOPED_TRACE(cloud.name);
    ASSERT_NO_FATAL_FAILURE(check_surfaces(cloud.points, 2, seen));
  }
  for (int round = 0; round < test_rounds(20); ++round) {
    SCOPED_TRACE(round);
    for (const int side : {1, 2, 4}) {
      std::vector<Point3> points(12);
      for (Point3& p : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = testing::small_integer(random, side);
      }
      ASSERT_NO_FATAL_FAILURE(check_surfaces(points, 2, seen));
    }
  }
  EXPECT_GT(seen.ordinary, test_cases(200U));
  EXPECT_GT(seen.deep, test_cases(30U));
  EXPECT_GT(seen.through_vertices, test_cases(5U));
  EXPECT_GT(seen.behind_regular_points, test_cases(50U));
  EXPECT_GT(seen.open, test_cases(3U));
}

TEST(StableSurface, OfRoundedScansIsBoundedByCriticalEdgesOrFlagged) {
  Random random(86);
  Seen seen;
  for (int round = 0; round < test_rounds(2); ++round) {
    for (const testing::Cloud& scan : testing::rounded_scans(random, 50)) {
      SCOPED_TRACE(scan.name);
      ASSERT_NO_FATAL_FAILURE(check_surfaces(scan.points, 2, seen));
    }
  }
  EXPECT_GT(seen.ordinary, test_cases(150U));
  EXPECT_GT(seen.deep, test_cases(50U));
  EXPECT_GT(seen.behind_regular_points, test_cases(30U));
}

TEST(StableSurface, ChainsOfRandomPointsAreContractible) {
  Random random(82);
  for (int round = 0; round < test_rounds(12); ++round) {
    const std::vector<Point3> points = testing::random_points(random, 14 + random() % 80, testing::unit);
    const FlowComplex flow = flow_complex(points);
    const FlowChains chains = flow_chains(flow, context());
    ASSERT_TRUE(chains.is_ordinary());
    ASSERT_TRUE(is_chain_complex(chains));
    ASSERT_EQ(flow_betti_numbers(flow, chains), (Counts{1, 0, 0, 0}));
  }
}

TEST(StableSurface, ChainsOfGridsAreComplexesOrSaidNotToBe) {
  Random random(83);
  std::size_t flagged = 0;
  std::size_t ordinary = 0;
  for (int round = 0; round < test_rounds(150); ++round) {
    const int side = round % 2 == 0 ? 2 : 9;
    std::vector<Point3> points(8 + random() % 7);
    for (Point3& p : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = testing::small_integer(random, side);
    }
    const FlowComplex flow = flow_complex(points);
    const FlowChains chains = flow_chains(flow, context());
    if (!chains.is_ordinary()) {
      ++flagged;
      continue;
    }
    ++ordinary;
    ASSERT_TRUE(is_chain_complex(chains));
    ASSERT_EQ(flow_betti_numbers(flow, chains), (Counts{1, 0, 0, 0}));
  }
  EXPECT_GT(flagged, test_cases(10U));
  EXPECT_GT(ordinary, test_cases(10U));
}

}  // namespace
}  // namespace quoin
