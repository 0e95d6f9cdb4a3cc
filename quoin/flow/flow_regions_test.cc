// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_orbit.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/test_flow_names.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::FlowNames;
using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// How often the walls of a region wind around a point: once inside, not at all outside.
double winding_number(const FlowMesh& mesh, const Point3& at) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    std::array<Point3, 3> v;
    std::array<double, 3> length{};
    for (unsigned i = 0; i < 3; ++i) {
      const Point3& p = mesh.points[t[i]];
      v[i] = {p.x - at.x, p.y - at.y, p.z - at.z};
      length[i] = std::hypot(v[i].x, v[i].y, v[i].z);
    }
    const auto product = [&](unsigned i, unsigned j) { return v[i].x * v[j].x + v[i].y * v[j].y + v[i].z * v[j].z; };
    const double volume = v[0].x * (v[1].y * v[2].z - v[1].z * v[2].y) + v[0].y * (v[1].z * v[2].x - v[1].x * v[2].z) +
                          v[0].z * (v[1].x * v[2].y - v[1].y * v[2].x);
    sum += 2 * std::atan2(volume, length[0] * length[1] * length[2] + product(0, 1) * length[2] +
                                      product(1, 2) * length[0] + product(2, 0) * length[1]);
  }
  return sum / (4 * std::acos(-1.0));
}

// A grid of cubes: each is the region of its centre.
TEST(FlowRegions, OfLattices) {
  const Delaunay3 triangulation(testing::lattice(3, 4, 5), context());
  const FlowCells cells(triangulation, context());
  const FlowGraph graph(cells, context());
  const FlowRegions found = flow_regions(graph, context());
  ASSERT_EQ(found.regions.size(), 24U);
  EXPECT_EQ(found.vertices_to_infinity + found.vertices_to_saddles, 0U);
  for (const FlowRegion& region : found.regions) {
    EXPECT_EQ(region.vertices, 1U);
    EXPECT_EQ(region.walls.size(), 6U);
    EXPECT_EQ(region.inner_saddles, 0U);
    EXPECT_TRUE(region.is_beside_infinity);
    EXPECT_NEAR(
        winding_number(flow_mesh(cells, region.walls, context()),
                       to_nearest_doubles(CriticalValues(triangulation).centre(graph.maxima()[region.maximum].cell))),
        1, 1e-9);
  }
  const RegionSurvey survey = survey_regions(graph, found, context());
  EXPECT_EQ(survey.walls.mean(), 6);
  EXPECT_EQ(survey.vertices.count(), 24U);
  EXPECT_EQ(survey.triangles, 8U * 98);
  EXPECT_TRUE(survey.not_ordinary.empty());
}

/// The orbit of a point ends in the maximum whose walls it is inside of, by exact steps from the point alone.
void check_membership(const std::vector<Point3>& points, Random& random, std::size_t& inside) {
  const Delaunay3 triangulation(points, context());
  const FlowComplex flow(triangulation, context());
  const FlowCells cells(triangulation, context());
  const FlowGraph graph(cells, context());
  const FlowRegions found = flow_regions(graph, context());
  std::size_t vertices = found.vertices_to_infinity + found.vertices_to_saddles;
  std::vector<FlowMesh> meshes;
  for (const FlowRegion& region : found.regions) {
    vertices += region.vertices;
    meshes.push_back(flow_mesh(cells, region.walls, context()));
  }
  ASSERT_EQ(vertices, flow.faces().count(3));
  ASSERT_TRUE(survey_regions(graph, found, context()).not_ordinary.empty());
  const FlowNames names(triangulation, flow);
  for (int i = 0; i < 12; ++i) {
    const Point3 p = testing::random_points(random, 1, testing::unit)[0];
    const FlowOrbit orbit = flow_orbit(flow, exact_point(p), context());
    for (const FlowRegion& region : found.regions) {
      const bool ends_here = !orbit.is_infinite && orbit.end == names.of_cell(graph.maxima()[region.maximum].cell);
      inside += ends_here ? 1 : 0;
      ASSERT_NEAR(winding_number(meshes[region.maximum], p), ends_here ? 1 : 0, 1e-6);
    }
  }
}

TEST(FlowRegions, ArePointsThatFlowToTheirMaxima) {
  Random random(151);
  std::size_t inside = 0;
  for (int round = 0; round < test_rounds(10); ++round) {
    ASSERT_NO_FATAL_FAILURE(
        check_membership(testing::random_points(random, 15 + random() % 30, testing::unit), random, inside));
  }
  EXPECT_GE(inside, test_cases(6U));
}

TEST(FlowRegions, OfDegeneratePoints) {
  Random random(152);
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 20)) {
    SCOPED_TRACE(cloud.name);
    const Delaunay3 triangulation(cloud.points, context());
    if (triangulation.dimension() < 3) continue;
    const FlowCells cells(triangulation, context());
    const FlowGraph graph(cells, context());
    const FlowRegions found = flow_regions(graph, context());
    const RegionSurvey survey = survey_regions(graph, found, context());
    ASSERT_EQ(survey.vertices.count(), cells.counts()[3]);
    std::size_t walls = 0;
    for (const FlowRegion& region : found.regions) walls += region.walls.size() + 2 * region.inner_saddles;
    std::size_t ends = 0;
    for (const FlowGraph::Saddle& saddle : graph.saddles()) {
      for (const std::uint32_t end : saddle.ends) ends += end != graph.infinity() ? 1 : 0;
    }
    ASSERT_EQ(walls, ends);
  }
  const Delaunay3 triangulation(testing::random_points(random, 500, testing::unit), context());
  const FlowCells cells(triangulation, context());
  const FlowGraph graph(cells, context());
  const Context none({.threads = 1, .most_polls = 0});
  EXPECT_THROW(flow_regions(graph, none), Cancelled);
  EXPECT_THROW(survey_sheets(cells, none), Cancelled);
}

}  // namespace
}  // namespace quoin
