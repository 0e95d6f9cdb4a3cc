// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// All that is known of points of space.
struct Flow {
  Delaunay3 triangulation;
  FlowCells cells;
  FlowGraph graph;

  explicit Flow(const std::vector<Point3>& points)
      : triangulation(points, context()), cells(triangulation, context()), graph(cells, context()) {}
};

/// Each directed edge as often as its reverse.
void check_closed(const FlowMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (unsigned i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
      --edges[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const auto& [edge, count] : edges) ASSERT_EQ(count, 0);
}

long euler_characteristic(const FlowMesh& mesh) {
  std::set<std::uint32_t> corners;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (unsigned i = 0; i < 3; ++i) {
      corners.insert(t[i]);
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  return static_cast<long>(corners.size()) - static_cast<long>(edges.size()) + static_cast<long>(mesh.triangles.size());
}

double volume(const FlowMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    six += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six / 6;
}

std::vector<Point3> torus(Random& random, int around, int along) {
  std::vector<Point3> points;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < along; ++j) {
      const double a = turn * (i + 0.3 * testing::unit(random)) / around;
      const double b = turn * (j + 0.3 * testing::unit(random)) / along;
      const double r = 3 + std::cos(b);
      points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  }
  return points;
}

TEST(FlowGraph, EachMaximumHasASaddleBelow) {
  Random random(111);
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 25)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 triangulation(cloud.points, context());
    if (triangulation.dimension() < 3) continue;
    const Flow flow(cloud.points);
    EXPECT_EQ(flow.graph.maxima().size(), flow.cells.counts()[3]);
    EXPECT_EQ(flow.graph.saddles().size(), flow.cells.counts()[2]);
    const std::vector<FlowGraph::Pair> pairs = flow.graph.pairs(context());
    ASSERT_EQ(pairs.size(), flow.graph.maxima().size());
    std::set<std::uint32_t> seen;
    std::optional<Rational> before;
    for (const FlowGraph::Pair& pair : pairs) {
      seen.insert(pair.maximum);
      const Rational low = flow.graph.exact_square_of_saddle(pair.saddle);
      const Rational high = flow.graph.exact_square_of_maximum(pair.maximum);
      ASSERT_LT(low, high);
      ASSERT_TRUE(!before || low <= *before);
      before = low;
      ASSERT_TRUE(pair.behind == flow.graph.infinity() || flow.graph.exact_square_of_maximum(pair.behind) >= high);
      ASSERT_TRUE(flow.graph.saddles()[pair.saddle].square.contains(low));
      ASSERT_TRUE(flow.graph.maxima()[pair.maximum].square.contains(high));
    }
    EXPECT_EQ(seen.size(), pairs.size());
  }
}

TEST(FlowGraph, DifferencesOfSquareRootsAreCompared) {
  EXPECT_TRUE(differ_by_at_most(Rational(4), Rational(9), Rational(1)));
  EXPECT_FALSE(differ_by_at_most(Rational(4), Rational(9), Rational(1) - Rational(1) / Rational(1000000)));
  EXPECT_TRUE(differ_by_at_most(Rational(2), Rational(2), Rational(0)));
  EXPECT_FALSE(differ_by_at_most(Rational(2), Rational(2.0000000000000004), Rational(0)));
  EXPECT_FALSE(differ_by_at_most(Rational(0), Rational(4), Rational(1)));
  EXPECT_TRUE(differ_by_at_most(Rational(0), Rational(4), Rational(2)));
}

TEST(FlowGraph, CancellationLeavesFewerAndHigherMaxima) {
  Random random(112);
  for (int round = 0; round < test_rounds(4); ++round) {
    const Flow flow(testing::random_points(random, 150, testing::unit));
    const auto kept = [&](double most) {
      const std::vector<std::uint32_t> becomes = flow.graph.simplified(most, context());
      std::size_t count = 0;
      for (std::uint32_t i = 0; i < becomes.size(); ++i) {
        count += becomes[i] == i ? 1 : 0;
        EXPECT_TRUE(becomes[i] == flow.graph.infinity() || becomes[becomes[i]] == becomes[i]);
      }
      return count;
    };
    EXPECT_EQ(kept(0), flow.graph.maxima().size());
    EXPECT_EQ(kept(1e9), 0U);
    std::size_t before = flow.graph.maxima().size();
    for (const double most : {0.001, 0.003, 0.01, 0.03, 0.1}) {
      std::size_t shallow = 0;
      for (const FlowGraph::Pair& pair : flow.graph.pairs(context()))
        shallow += flow.graph.is_shallow(pair, most) ? 1 : 0;
      EXPECT_EQ(kept(most), flow.graph.maxima().size() - shallow);
      EXPECT_LE(kept(most), before);
      before = kept(most);
    }
    EXPECT_LT(before, flow.graph.maxima().size());
    EXPECT_THROW(flow.graph.simplified(-1, context()), InputError);
  }
}

TEST(FlowGraph, ClosedSurfacesAreFoundAgain) {
  Random random(113);
  for (int round = 0; round < test_rounds(2); ++round) {
    const Flow sphere(testing::near_sphere(random, 250));
    const FlowMesh ball = flow_mesh(sphere.cells, flow_solid(sphere.graph, {}, context()).wall, context());
    ASSERT_NO_FATAL_FAILURE(check_closed(ball));
    EXPECT_EQ(euler_characteristic(ball), 2);
    EXPECT_NEAR(volume(ball), 4.19, 0.25);
    const Flow ring(torus(random, 44, 15));
    const FlowMesh tube = flow_mesh(ring.cells, flow_solid(ring.graph, {}, context()).wall, context());
    ASSERT_NO_FATAL_FAILURE(check_closed(tube));
    EXPECT_EQ(euler_characteristic(tube), 0);
    EXPECT_NEAR(volume(tube), 59.2, 4);
  }
  // Nothing is entered, so all that is bounded stays; or everything is.
  const Flow some(testing::random_points(random, 60, testing::unit));
  const FlowSolid all = flow_solid(some.graph, {.ratio = 1}, context());
  EXPECT_EQ(std::count(all.is_inside.begin(), all.is_inside.end(), true),
            static_cast<std::ptrdiff_t>(some.graph.maxima().size()));
  EXPECT_TRUE(flow_solid(some.graph, {.ratio = 0}, context()).wall.empty());
  EXPECT_THROW(flow_solid(some.graph, {.ratio = 2}, context()), InputError);
}

// The boundary of any set of maxima is closed where surfaces are ordinary.
TEST(FlowGraph, WallsAreClosed) {
  Random random(114);
  for (int round = 0; round < test_rounds(6); ++round) {
    const Flow flow(testing::random_points(random, 60, testing::unit));
    std::vector<bool> is_inside;
    for (std::size_t i = 0; i < flow.graph.maxima().size(); ++i) is_inside.push_back(random() % 2 == 0);
    const FlowMesh mesh = flow_mesh(flow.cells, wall_of(flow.graph, is_inside), context());
    EXPECT_EQ(mesh.not_ordinary, 0U);
    ASSERT_NO_FATAL_FAILURE(check_closed(mesh));
    EXPECT_GE(volume(mesh), 0);
  }
}

// A cube: six squares of eight triangles, each way one segment.
TEST(FlowSurvey, OfACube) {
  const Delaunay3 triangulation(testing::lattice(2, 2, 2), context());
  const FlowCells cells(triangulation, context());
  const StableSurvey stable = survey_stable(cells, context());
  EXPECT_EQ(stable.triangles, 48U);
  EXPECT_EQ(stable.depths.count(), 24U);
  EXPECT_EQ(stable.depths.most(), 1U);
  const UnstableSurvey unstable = survey_unstable(cells, context());
  EXPECT_EQ(unstable.segments.count(), 12U);
  EXPECT_EQ(unstable.segments.mean(), 1);
  EXPECT_EQ(unstable.to_infinity, 6U);
  const FlowGraph graph(cells, context());
  EXPECT_EQ(graph.pairs(context()).size(), 1U);
  EXPECT_EQ(graph.betti_numbers(Rational(1) / Rational(2), context()), (std::array<std::size_t, 3>{1, 0, 1}));
  EXPECT_EQ(graph.betti_numbers(Rational(3) / Rational(4), context()), (std::array<std::size_t, 3>{1, 0, 0}));
  EXPECT_EQ(graph.betti_numbers(Rational(1) / Rational(4), context()), (std::array<std::size_t, 3>{1, 5, 0}));
}

TEST(Histogram, MeanDeviationModeMedian) {
  Histogram histogram;
  EXPECT_EQ(histogram.mean(), 0);
  for (const std::size_t value : {2, 4, 4, 4, 5, 5, 7, 9}) histogram.add(value);
  EXPECT_EQ(histogram.mean(), 5);
  EXPECT_EQ(histogram.deviation(), 2);
  EXPECT_EQ(histogram.mode(), 4U);
  EXPECT_EQ(histogram.median(), 4U);
  EXPECT_EQ(histogram.most(), 9U);
}

TEST(FlowSurvey, IsCancelled) {
  Random random(115);
  const std::vector<Point3> points = testing::random_points(random, 2000, testing::unit);
  const Delaunay3 triangulation(points, context());
  const Context none({.threads = 1, .most_polls = 0});
  EXPECT_THROW(FlowCells(triangulation, none), Cancelled);
  const FlowCells cells(triangulation, context());
  EXPECT_THROW(survey_stable(cells, none), Cancelled);
  EXPECT_THROW(survey_unstable(cells, none), Cancelled);
  EXPECT_THROW(FlowGraph(cells, none), Cancelled);
}

}  // namespace
}  // namespace quoin
