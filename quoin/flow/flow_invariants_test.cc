// SPDX-License-Identifier: Apache-2.0
// What holds of any points, beyond what the tests of each file say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_chains.h"
#include "quoin/flow/flow_orbit.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

// Table 1 of Cazals, Parameswaran and Pion: which segments there are, by dimensions of Voronoi faces: where they start,
// what they cross, where they end (3 stands for infinity behind the last dimension). Steps within a Voronoi vertex are
// none, since Delone cells have one vertex each.
TEST(FlowInvariants, SegmentsAreOfTheCatalogue) {
  Random random(161);
  std::set<std::array<int, 3>> seen;
  for (int round = 0; round < test_rounds(30); ++round) {
    const auto coordinate = round % 3 == 0 ? +[](Random& r) { return testing::unit(r); }
                                           : +[](Random& r) { return testing::small_integer(r, 3); };
    const FlowComplex flow = flow_complex(round % 5 == 4 ? testing::rounded_scan(random, 20, testing::scanned_torus)
                                                         : testing::random_points(random, 12, coordinate));
    std::vector<RationalPoint3> starts;
    for (unsigned d = 1; d < 4; ++d) {
      for (std::uint32_t i = 0; i < flow.faces().count(d); i += 3) starts.push_back(flow.centre({d, i}));
    }
    for (const Point3& p : testing::random_points(random, 4, coordinate)) starts.push_back(exact_point(p));
    for (const RationalPoint3& start : starts) {
      const FlowOrbit orbit = flow_orbit(flow, start, context());
      std::optional<DeloneFace> at;
      for (const FlowSegment& s : orbit.segments) {
        ASSERT_TRUE(!at || *at == s.start);
        at = s.reached;
        const auto dimension = [](DeloneFace face) { return 3 - static_cast<int>(face.dimension); };
        const int from = dimension(s.start);
        const int through = dimension(s.crossed);
        const int to = s.reached ? dimension(*s.reached) : -1;
        seen.insert({from, through, to});
        ASSERT_LT(to, through);  // it ends on the boundary of what it crosses, or nowhere
        ASSERT_TRUE(from == 3 ? through == 3 : from == 2 ? through == 2 : through == 1 || through == 2);
      }
    }
  }
  // From vertices, edges, facets and cells, to infinity and to boundaries.
  for (const std::array<int, 3>& kind : {std::array{0, 1, 0},
                                         {0, 1, -1},
                                         {0, 2, 1},
                                         {0, 2, -1},
                                         {1, 1, 0},
                                         {1, 1, -1},
                                         {1, 2, 1},
                                         {1, 2, -1},
                                         {3, 3, 2},
                                         {3, 3, -1}}) {
    EXPECT_TRUE(test_rounds(30) < 30 || seen.contains(kind)) << kind[0] << kind[1] << kind[2];
  }
}

// Orders, axes, moves and powers of two; how larger Delone cells are cut into simplices follows from the order alone.
TEST(FlowInvariants, SurveysDoNotDependOnThePlacement) {
  Random random(162);
  for (int round = 0; round < test_rounds(12); ++round) {
    std::vector<Point3> points =
        round % 3 == 2 ? testing::rounded_scan(random, 60, testing::scanned_bumps)
                       : testing::random_points(random, 30, [](Random& r) { return testing::small_integer(r, 3); });
    std::optional<std::vector<std::size_t>> expected;
    for (int placement = 0; placement < 4; ++placement) {
      const Delaunay3 triangulation(points, context(), {.is_canonical = placement % 2 == 0});
      if (triangulation.dimension() < 3) break;
      const FlowCells cells(triangulation, context());
      const StableSurvey stable = survey_stable(cells, context());
      const UnstableSurvey unstable = survey_unstable(cells, context());
      const SheetSurvey sheets = survey_sheets(cells, context());
      std::vector<std::size_t> told(cells.counts().begin(), cells.counts().end());
      for (const Histogram* h : {&stable.depths, &sheets.parts, &sheets.saddles, &sheets.vertices}) {
        told.insert(told.end(), h->counts().begin(), h->counts().end());
      }
      for (const std::size_t number :
           {stable.triangles, stable.with_voronoi_vertex.size(), stable.with_solid_part.size(),
            stable.with_regular_point.size(), unstable.segments.count(), unstable.in_saddles.size(), sheets.to_infinity,
            sheets.with_regular_point.size(), sheets.with_stationary_end.size(),
            cells.regular_polygons(context()).size(), cells.regular_cells(context()).size()}) {
        told.push_back(number);
      }
      if (!expected) expected = told;
      ASSERT_EQ(told, *expected);
      std::shuffle(points.begin(), points.end(), random);
      for (Point3& p : points) p = {4 * p.y + 40, -4 * p.z - 12, 4 * p.x};
    }
  }
}

/// Forward from each point of a surface, the flow comes to the point that it was constructed from.
void check_back_and_forth(const FlowComplex& flow, std::uint32_t polygon, std::size_t& steps) {
  StableSurface surface = stable_surface(flow, polygon, context());
  if (!surface.is_ordinary()) return;
  for (const StableTriangle& t : surface.triangles) {
    if (surface.points.face(t.from).dimension != 2) continue;
    const FlowStep step = flow_step(surface.points, t.from);
    ASSERT_NE(step.point, FlowPoints::none);
    ASSERT_EQ(surface.points.exact(step.point), surface.points.exact(t.towards));
    ++steps;
  }
}

TEST(FlowInvariants, BackwardsThenForwardsIsNowhere) {
  Random random(163);
  std::size_t steps = 0;
  for (int round = 0; round < test_rounds(10); ++round) {
    const auto coordinate = round % 2 == 0 ? +[](Random& r) { return testing::unit(r); }
                                           : +[](Random& r) { return testing::small_integer(r, 9); };
    const FlowComplex flow = flow_complex(testing::random_points(random, 20, coordinate));
    for (std::uint32_t f = 0; f < flow.faces().count(2); ++f) {
      if (!flow.is_critical({2, f})) continue;
      ASSERT_NO_FATAL_FAILURE(check_back_and_forth(flow, f, steps));
    }
  }
  EXPECT_GT(steps, test_cases(30U));
  const std::size_t of_random = steps;
  for (const testing::Cloud& scan : testing::rounded_scans(random, 80)) {
    SCOPED_TRACE(scan.name);
    const FlowComplex flow = flow_complex(scan.points);
    for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
      if (face.dimension != 2) continue;
      ASSERT_NO_FATAL_FAILURE(check_back_and_forth(flow, face.index, steps));
    }
  }
  EXPECT_GT(steps - of_random, 30U);
}

// Of random points doubles decide all but very few questions, of grids and rounded scans not.
TEST(FlowInvariants, FiltersFailOnDegeneratePointsAlone) {
  Random random(165);
  const auto undecided = [](const std::vector<Point3>& points) {
    const Delaunay3 triangulation(points, context());
    const FlowCells cells(triangulation, context());
    const SheetSurvey sheets = survey_sheets(cells, context());
    const StableSurvey stable = survey_stable(cells, context());
    EXPECT_LE(sheets.crossings.filters.comparisons.undecided, sheets.crossings.filters.comparisons.calls);
    EXPECT_LE(cells.undecided().centres, cells.undecided().centre_calls);
    EXPECT_GT(sheets.crossings.filters.landings.calls, 100U);
    EXPECT_EQ(sheets.crossings.exact_points, sheets.crossings.bytes.count());
    EXPECT_GE(8 * sheets.crossings.bytes.most(), sheets.crossings.most_bits);
    return std::array{cells.undecided().centres + cells.undecided().spheres,
                      sheets.crossings.undecided + stable.crossings.undecided};
  };
  EXPECT_EQ(undecided(testing::random_points(random, 300, testing::unit)), (std::array<std::size_t, 2>{0, 0}));
  for (const std::vector<Point3>& points :
       {testing::random_points(random, 300, [](Random& r) { return testing::small_integer(r, 9); }),
        testing::rounded_scan(random, 300, testing::scanned_torus)}) {
    const std::array<std::size_t, 2> of_grid = undecided(points);
    EXPECT_GT(of_grid[0], 0U);
    EXPECT_GT(of_grid[1], 0U);
  }
}

// A way that ends in another saddle: the chains are no complex, and nothing says they were.
TEST(FlowInvariants, WhatIsNoComplexIsSaidToBeNone) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 1}, {0, 2, -1}, {0, -10, 0}});
  const FlowChains chains = flow_chains(flow, context());
  EXPECT_FALSE(is_chain_complex(chains));
  EXPECT_FALSE(chains.is_ordinary());
}

// Pairs of saddles, found backwards and forwards, all among more points: as many leaves of surfaces as saddles of
// sheets.
TEST(FlowInvariants, SurfacesAndSheetsHaveAsManyPairs) {
  Random random(166);
  const Delaunay3 triangulation(testing::random_points(random, 400, testing::unit), context());
  const FlowCells cells(triangulation, context());
  const SheetSurvey sheets = survey_sheets(cells, context());
  EXPECT_TRUE(sheets.with_regular_point.empty() && sheets.with_stationary_end.empty());
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < sheets.saddles.counts().size(); ++i) pairs += i * sheets.saddles.counts()[i];
  EXPECT_EQ(pairs, survey_stable(cells, context()).depths.count());
  EXPECT_EQ(sheets.parts.count(), cells.counts()[1]);
}

}  // namespace
}  // namespace quoin
