// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_orbit.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/test_slow_flow.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::LazyNumber;
using testing::LazyVector;
using testing::Random;
using testing::SlowFlow;

/// The library's orbit is that of the definition, point for point.
void check_orbit(const FlowComplex& flow, const SlowFlow& slow, const RationalPoint3& start) {
  const Context context({.threads = 1});
  FlowOrbit orbit = flow_orbit(flow, start, context);
  LazyVector at = testing::lazy(start);
  Rational least;
  for (std::uint32_t i = 0; i <= orbit.segments.size(); ++i) {
    const DeloneFace face = i < orbit.points.size() ? orbit.points.face(i) : DeloneFace{};
    if (i == orbit.points.size()) {
      ASSERT_TRUE(orbit.is_infinite);
      return;
    }
    ASSERT_EQ(testing::exact(at), orbit.points.exact(i));
    ASSERT_EQ(slow.contacts(at).size(), flow.faces().vertices(face).size());
    const RationalPoint3 radius = orbit.points.exact(i) - exact_point(flow.point(flow.faces().vertices(face)[0]));
    ASSERT_TRUE(i == 0 || dot(radius, radius) > least);
    least = dot(radius, radius);
    const SlowFlow::Step step = slow.step(at);
    ASSERT_EQ(step.stops, i == orbit.segments.size());
    if (step.stops) return;
    ASSERT_EQ(step.is_infinite, !orbit.segments[i].reached.has_value());
    ASSERT_EQ(step.crossed, flow.faces().vertices(orbit.segments[i].crossed).size());
    at = step.reached;
  }
}

double small_grid(Random& random) {
  return testing::small_integer(random, 2);
}
double large_grid(Random& random) {
  return testing::small_integer(random, 8);
}

/// From centres of faces, and from some points.
void check_orbits(const std::vector<Point3>& points, const std::vector<Point3>& starts) {
  const FlowComplex flow = flow_complex(points);
  const SlowFlow slow(points);
  for (unsigned d = 1; d < 4; ++d) {
    for (std::uint32_t i = 0; i < flow.faces().count(d); i += 3) check_orbit(flow, slow, flow.centre({d, i}));
  }
  for (const Point3& p : starts) check_orbit(flow, slow, exact_point(p));
}

void check_family(Random& random, double (*coordinate)(Random&), int rounds) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<Point3> points = testing::random_points(random, 5 + random() % 8, coordinate);
    if (round % 4 == 0) {
      for (Point3& p : points) p.z = p.x + p.y;
    }
    std::sort(points.begin(), points.end(),
              [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    check_orbits(points, testing::random_points(random, 5, coordinate));
  }
}

TEST(SlowFlow, OrbitsAreThoseOfTheDefinition) {
  Random random(91);
  check_family(random, testing::unit, test_rounds(20));
  check_family(random, large_grid, test_rounds(20));
  const std::size_t decided_exactly = LazyNumber::exact_signs;
  check_family(random, small_grid, test_rounds(40));
  EXPECT_GT(LazyNumber::exact_signs, decided_exactly);
  for (const testing::Cloud& scan : testing::rounded_scans(random, 16)) {
    SCOPED_TRACE(scan.name);
    check_orbits(scan.points, testing::random_points(random, 5, small_grid));
  }
}

}  // namespace
}  // namespace quoin
