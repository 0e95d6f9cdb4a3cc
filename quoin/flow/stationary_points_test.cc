// SPDX-License-Identifier: Apache-2.0
// Which points are stationary, and which of these are critical, by the definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/test_stationary_points.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;
using testing::StationaryPoint;
using Counts = std::array<std::size_t, 4>;

std::map<std::string, StationaryPoint> found_points(const FlowComplex& flow) {
  std::map<std::string, StationaryPoint> all;
  for (const FlowKind kind : {FlowKind::critical, FlowKind::regular}) {
    for (const DeloneFace& face : flow.faces_of_kind(kind)) {
      const StationaryPoint point{face.dimension, kind == FlowKind::critical};
      EXPECT_TRUE(all.emplace(testing::text(flow.centre(face)), point).second);
    }
  }
  return all;
}

/// Compares, and returns how many stationary points are not critical.
std::size_t check(const std::vector<Point3>& points) {
  const FlowComplex flow = flow_complex(points);
  const std::map<std::string, StationaryPoint> expected = testing::stationary_points(points);
  EXPECT_TRUE(found_points(flow) == expected) << expected.size();
  Counts counts{};
  std::size_t regular = 0;
  for (const auto& [place, point] : expected) {
    if (point.is_critical) ++counts[point.dimension];
    regular += point.is_critical ? 0 : 1;
  }
  EXPECT_EQ(flow.counts(), counts);
  EXPECT_EQ(counts[0] + counts[2], counts[1] + counts[3] + 1);
  return regular;
}

// Twenty sets of twelve points of a grid of four in each direction (D20). Of others 7 to 21 stationary points were not
// critical: so it is of most of these.
TEST(StationaryPoints, OfPartsOfAGrid) {
  Random random(171);
  std::size_t as_many = 0;
  for (int round = 0; round < test_rounds(20); ++round) {
    SCOPED_TRACE(round);
    std::vector<Point3> points = testing::lattice(4, 4, 4);
    std::shuffle(points.begin(), points.end(), random);
    points.resize(12);
    const std::size_t regular = check(points);
    as_many += regular >= 7 && regular <= 21 ? 1 : 0;
  }
  EXPECT_GE(as_many, test_cases(15U));
}

TEST(StationaryPoints, OfScansPlanesAndAnyPoints) {
  Random random(172);
  std::size_t regular = 0;
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const testing::Cloud& cloud : testing::rounded_scans(random, 12)) {
      SCOPED_TRACE(cloud.name);
      regular += check(cloud.points);
    }
    EXPECT_EQ(check(testing::random_points(random, 10, testing::unit)), 0U);
  }
  EXPECT_GT(regular, test_cases(5U));
  for (const std::vector<Point3>& points :
       {testing::lattice(3, 3, 1), testing::lattice(2, 2, 3), testing::lattice(1, 5, 1)})
    check(points);
}

}  // namespace
}  // namespace quoin
