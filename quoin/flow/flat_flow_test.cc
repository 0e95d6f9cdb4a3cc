// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flat_flow.h"

#include <gtest/gtest.h>

#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_chains.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_slow_flow.h"
#include "quoin/flow/unstable_sheet.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::LazyVector;
using testing::Random;
using testing::SlowFlow;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

// The edge between the outer two corners of a kite is no critical one: ways from the upper sides cross it.
TEST(FlatFlow, Kite) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, -10, 0}});
  FlatFlow flat(flow);
  const FlatSurvey unstable = survey_flat_unstable(flat, context());
  EXPECT_EQ(unstable.segments.counts(), (std::vector<std::size_t>{0, 6, 2}));
  EXPECT_EQ(unstable.to_infinity, 4U);
  const StableSurvey stable = survey_flat_stable(flow, context());
  EXPECT_EQ(stable.triangles, 10U);
  EXPECT_EQ(stable.depths.counts(), (std::vector<std::size_t>{0, 2, 2}));
}

TEST(FlatFlow, FewPoints) {
  for (const auto& [points, ways] : {std::pair{std::vector<Point3>{{1, 2, 3}}, 0U},
                                     {{{0, 0, 0}, {2, 0, 0}}, 2U},
                                     {{{0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {1, 2, 3}}, 4U}}) {
    const FlowComplex flow = flow_complex(points);
    FlatFlow flat(flow);
    const FlatSurvey unstable = survey_flat_unstable(flat, context());
    EXPECT_EQ(unstable.segments.count(), ways);
    EXPECT_EQ(unstable.to_infinity, ways);
    EXPECT_EQ(survey_flat_stable(flow, context()).triangles, 0U);
    EXPECT_EQ(flat_shape(flow, Rational(1000), context()).betti_numbers, (std::array<std::size_t, 3>{1, 0, 0}));
  }
  // The way from a leg of a right triangle passes the middle of its longest side.
  const FlowComplex right = flow_complex({{0, 0, 5}, {3, 0, 5}, {0, 4, 5}});
  FlatFlow flat(right);
  const FlatSurvey unstable = survey_flat_unstable(flat, context());
  EXPECT_EQ(unstable.passed_regular, (ManifoldList{0, 1}));
  EXPECT_EQ(unstable.segments.counts(), (std::vector<std::size_t>{0, 2, 2}));
  EXPECT_THROW(FlatFlow(flow_complex(testing::lattice(2, 2, 2))), InputError);
}

/// Ways are orbits by the definition, up to stationary points; the saddles of sheets in space are their ends.
void check_ways(const FlowComplex& flow, const SlowFlow& slow) {
  FlatFlow flat(flow);
  for (const std::uint32_t edge : critical_faces(flow, 1)) {
    std::set<std::uint32_t> ends;
    bool passes = false;
    for (const FlatWay& way : flat.ways(edge, context())) {
      passes |= way.has_passed_regular;
      if (way.end != FlatWay::infinity) ends.insert(way.end);
      if (way.first == FlatWay::infinity) {
        ASSERT_EQ(way.segments, 1U);
        continue;
      }
      LazyVector at = testing::lazy(flow.centre({2, way.first}));
      std::uint32_t segments = 1;
      SlowFlow::Step step = slow.step(at);
      for (; !step.stops && !step.is_infinite; step = slow.step(at), ++segments) at = step.reached;
      segments += step.is_infinite ? 1 : 0;
      if (way.has_passed_regular) {
        ASSERT_LT(segments, way.segments);
        continue;
      }
      ASSERT_EQ(segments, way.segments);
      ASSERT_EQ(step.is_infinite, way.end == FlatWay::infinity);
      if (step.stops) {
        ASSERT_EQ(testing::exact(at), flow.centre({2, way.end}));
      }
    }
    const UnstableSheet sheet = unstable_sheet(flow, edge, context());
    if (!passes) {
      ASSERT_EQ(std::set<std::uint32_t>(sheet.saddles.begin(), sheet.saddles.end()), ends);
    }
    ASSERT_TRUE(sheet.is_infinite);
  }
}

void check(const std::vector<Point3>& points) {
  const FlowComplex flow = flow_complex(points);
  std::vector<Point3> distinct;
  for (std::uint32_t v = 0; v < flow.faces().count(0); ++v) distinct.push_back(flow.point(v));
  ASSERT_NO_FATAL_FAILURE(check_ways(flow, SlowFlow(distinct)));
  const StableSurvey stable = survey_flat_stable(flow, context());
  const FlowChains chains = flow_chains(flow, context());
  ASSERT_EQ(stable.with_regular_point.size(), chains.surfaces_not_ordinary.size());
  if (!chains.is_ordinary()) return;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    const Rational square = flow.square_radius(face);
    const std::array<std::size_t, 4> expected = flow_betti_numbers(flow, chains, &square);
    ASSERT_EQ(flat_shape(flow, square, context()).betti_numbers,
              (std::array<std::size_t, 3>{expected[0], expected[1], expected[2]}));
  }
}

TEST(FlatFlow, IsThatOfTheDefinition) {
  Random random(141);
  for (int round = 0; round < test_rounds(12); ++round) {
    for (double (*coordinate)(Random&) :
         {+[](Random& r) { return testing::unit(r); }, +[](Random& r) { return testing::small_integer(r, 3); }}) {
      std::vector<Point3> points = testing::random_points(random, 4 + random() % 12, coordinate);
      for (Point3& p : points) p.z = round % 2 == 0 ? 0 : 2 * p.x;
      ASSERT_NO_FATAL_FAILURE(check(points));
    }
  }
}

TEST(FlatFlow, IsCancelled) {
  Random random(142);
  std::vector<Point3> points = testing::random_points(random, 800, testing::unit);
  for (Point3& p : points) p.z = 0;
  const FlowComplex flow = flow_complex(points);
  const Context none({.threads = 1, .most_polls = 0});
  FlatFlow flat(flow);
  EXPECT_THROW(survey_flat_unstable(flat, none), Cancelled);
  EXPECT_THROW(survey_flat_stable(flow, none), Cancelled);
  EXPECT_THROW(flat_shape(flow, Rational(1), none), Cancelled);
}

}  // namespace
}  // namespace quoin
