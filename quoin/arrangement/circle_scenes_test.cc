// SPDX-License-Identifier: Apache-2.0
// The scenes of 14 circles: built in every way, turned, and searched in every way.
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "quoin/arrangement/circle_scenes.h"
#include "quoin/arrangement/circular/circular_editing.h"
#include "quoin/arrangement/circular/circular_location.h"
#include "quoin/arrangement/location/naive_locator.h"
#include "quoin/arrangement/location/walk_locator.h"

namespace quoin {
namespace {

using testing::CircleScene;
using testing::scenes_of_14_circles;

struct Input {
  CircularFamily family;
  PieceList<CircularFamily> list;
};

Input input_of(const CircleScene& scene) {
  Input input;
  for (const auto& [x, y, r] : scene) {
    input.family.add_circle(input.list, Point2{static_cast<double>(x), static_cast<double>(y)}, r);
  }
  return input;
}

/// Vertices where two halves of one circle meet and nothing else does.
std::size_t lone_extremes(const CircularArrangement& arrangement) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < arrangement.vertex_count(); ++v) {
    count += arrangement.cells().degree(dcel::VertexId(v)) == 2 ? 1 : 0;
  }
  return count;
}

void expect_same_cells(const CircularArrangement& a, const CircularArrangement& b) {
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.edge_count(), b.edge_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t h = 0; h < a.cells().halfedges.size(); ++h) {
    const dcel::HalfedgeId id(h);
    ASSERT_EQ(a.cells().next(id), b.cells().next(id)) << h;
    ASSERT_EQ(a.cells().origin(id), b.cells().origin(id)) << h;
    ASSERT_EQ(a.cells().face(id), b.cells().face(id)) << h;
  }
}

TEST(CircleScenes, SweepZoneAndMixturesGiveTheSameCells) {
  std::mt19937 random(4);
  for (const CircleScene& scene : scenes_of_14_circles()) {
    const Input all = input_of(scene);
    const CircularArrangement swept = arrange(all.family, all.list, Context());
    for (std::size_t by_sweep : {0U, 5U, 10U}) {
      CircleScene order = scene;
      std::shuffle(order.begin(), order.end(), random);
      const auto split = order.begin() + static_cast<std::ptrdiff_t>(by_sweep);
      const Input first = input_of(CircleScene(order.begin(), split));
      CircularArrangement built = arrange(first.family, first.list, Context());
      for (auto circle = split; circle != order.end(); ++circle) {
        const Input one = input_of({*circle});
        insert(built, one.family, one.list, Context());
        ASSERT_NO_THROW(dcel::check_links(built.cells()));
      }
      renumber(built, Context());
      expect_same_cells(built, swept);
    }
  }
}

// Turned by the angle of the triangle 3, 4, 5 only vertices at extremes change. Digest, 3.1: vertices without them.
TEST(CircleScenes, TurnedScenesDifferInExtremesOnly) {
  const std::vector<std::size_t> true_vertices{43, 45, 44};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const auto& [cosine, sine] : {std::pair{5, 0}, {3, 4}, {-4, 3}, {0, -5}}) {
      CircleScene turned;
      for (const auto& [x, y, r] : scenes_of_14_circles()[i]) {
        turned.push_back({cosine * x - sine * y, sine * x + cosine * y, 5 * r});
      }
      const Input input = input_of(turned);
      const CircularArrangement arrangement = arrange(input.family, input.list, Context());
      dcel::check_links(arrangement.cells());
      EXPECT_EQ(arrangement.counts().faces, 53U);
      EXPECT_EQ(arrangement.counts().components, 5U);
      EXPECT_EQ(arrangement.counts().vertices - lone_extremes(arrangement), true_vertices[i]);
    }
  }
}

TEST(CircleScenes, EveryLocatorFindsVerticesEdgesAndFaces) {
  for (const CircleScene& scene : scenes_of_14_circles()) {
    Input input = input_of(scene);
    std::vector<CircularPoint> queries;
    for (int x = -24; x <= 48; ++x) {
      for (int y = -24; y <= 48; ++y) queries.push_back(CircularFamily::query(Point2{x / 2.0, y / 2.0}));
    }
    const CircularArrangement arrangement = arrange(input.family, input.list, Context());
    for (std::size_t v = 0; v < arrangement.vertex_count(); ++v)
      queries.push_back(arrangement.point(dcel::VertexId(v)));
    const NaiveLocator<CircularFamily> naive(arrangement);
    const WalkLocator<CircularFamily> walk(arrangement);
    const TrapezoidLocator<CircularFamily> map(arrangement, Context());
    const GridLocator<CircularFamily> grid(arrangement);
    const std::vector<Location> batch = locate_batch(arrangement, std::span<const CircularPoint>(queries), Context());
    std::size_t vertices = 0;
    std::size_t edges = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Location found = naive.locate(queries[i]);
      ASSERT_EQ(walk.locate(queries[i]), found) << i;
      ASSERT_EQ(map.locate(queries[i]), found) << i;
      ASSERT_EQ(grid.locate(queries[i]), found) << i;
      ASSERT_EQ(batch[i], found) << i;
      vertices += found.is_vertex() ? 1 : 0;
      edges += found.is_edge() ? 1 : 0;
    }
    EXPECT_GE(vertices, 59U);
    EXPECT_GT(edges, 20U);
  }
}

}  // namespace
}  // namespace quoin
