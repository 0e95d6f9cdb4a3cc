// SPDX-License-Identifier: Apache-2.0
// Known answers of arrangements of circles and of great circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "quoin/arrangement/circle_scenes.h"
#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/geodesic/geodesic_arrangement.h"

namespace quoin {
namespace {

using Scene = testing::CircleScene;

CircularArrangement circles(const Scene& scene) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  for (const auto& [x, y, r] : scene)
    family.add_circle(list, Point2{static_cast<double>(x), static_cast<double>(y)}, r);
  return arrange(std::move(family), list, Context());
}

TEST(CurvedArrangement, FourteenCircles) {
  std::mt19937 random(1);
  for (Scene scene : testing::scenes_of_14_circles()) {
    for (int order = 0; order < 20; ++order) {
      const CircularArrangement arrangement = circles(scene);
      dcel::check_links(arrangement.cells());
      const dcel::Counts counts = arrangement.counts();
      EXPECT_EQ(counts.vertices, 59U);
      EXPECT_EQ(counts.edges, 106U);
      EXPECT_EQ(counts.faces, 53U);
      EXPECT_EQ(counts.components, 5U);
      std::shuffle(scene.begin(), scene.end(), random);
    }
  }
}

TEST(CurvedArrangement, CirclesThatAllCross) {
  for (const int n : {1, 2, 5, 20}) {
    Scene scene;
    for (int i = 0; i < n; ++i) scene.push_back({i * i, 7 * i, 10000 + i});
    const dcel::Counts counts = circles(scene).counts();
    const auto m = static_cast<std::size_t>(n);
    EXPECT_EQ(counts.vertices, m * (m - 1) + 2 * m);  // two extremes each
    EXPECT_EQ(counts.edges, 2 * m * (m - 1) + 2 * m);
    EXPECT_EQ(counts.faces, m * (m - 1) + 2);
  }
}

TEST(CurvedArrangement, CirclesOnTinyGrids) {
  std::mt19937 random(9);
  for (int round = 0; round < 1500; ++round) {
    CircularFamily family;
    PieceList<CircularFamily> list;
    const auto pick = [&](unsigned n) { return static_cast<double>(random() % n); };
    for (int i = 0; i < 2 + round % 9; ++i) {
      const Point2 p{pick(5), pick(5)};
      const Point2 q{pick(5), pick(5)};
      if (i % 3 == 2 && p != q) {
        family.add_segment(list, p, q);
      } else {
        family.add_circle(list, p, 1 + pick(3));
      }
    }
    const CircularArrangement arrangement = arrange(std::move(family), list, Context());
    ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << round;
  }
}

GeodesicArrangement great_circles(const std::vector<std::array<int, 3>>& normals) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (const auto& [x, y, z] : normals) {
    family.add_great_circle(list, Vector3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  }
  return arrange(std::move(family), list, Context());
}

/// Counts without the vertices of degree two that cutting at the identification leaves.
dcel::Counts without_cuts(const GeodesicArrangement& arrangement) {
  dcel::Counts counts = arrangement.counts();
  for (std::size_t v = 0; v < arrangement.vertex_count(); ++v) {
    if (arrangement.cells().degree(dcel::VertexId(v)) == 2) {
      --counts.vertices;
      --counts.edges;
    }
  }
  return counts;
}

TEST(CurvedArrangement, GreatCirclesInGeneralPosition) {
  std::mt19937 random(6);
  for (const std::size_t n : {1U, 2U, 3U, 4U, 7U, 15U}) {
    std::vector<std::array<int, 3>> normals;
    for (std::size_t i = 0; i < n; ++i) {
      const auto pick = [&] { return static_cast<int>(random() % 20001) - 10000; };
      normals.push_back({pick(), pick(), pick()});
    }
    const GeodesicArrangement arrangement = great_circles(normals);
    dcel::check_links(arrangement.cells());
    EXPECT_EQ(arrangement.counts().faces, n * (n - 1) + 2);
    if (n > 1) {
      EXPECT_EQ(without_cuts(arrangement).vertices, n * (n - 1));
      EXPECT_EQ(without_cuts(arrangement).edges, 2 * n * (n - 1));
    }
  }
}

TEST(CurvedArrangement, Octants) {
  const GeodesicArrangement arrangement = great_circles({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  dcel::check_links(arrangement.cells());
  EXPECT_EQ(arrangement.counts().vertices, 6U);
  EXPECT_EQ(arrangement.counts().edges, 12U);
  EXPECT_EQ(arrangement.counts().faces, 8U);
}

/// Counts do not depend on where the poles and the identification fall.
TEST(CurvedArrangement, ArcsOnTheSphereTurnedByAxes) {
  std::mt19937 random(8);
  for (int round = 0; round < 600; ++round) {
    std::vector<std::array<Vector3, 2>> arcs;
    while (arcs.size() < 1 + static_cast<std::size_t>(round % 8)) {
      const auto pick = [&] { return static_cast<double>(random() % 3) - 1; };
      const Vector3 a{pick(), pick(), pick()};
      const Vector3 b{pick(), pick(), pick()};
      const Vector3 n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
      if (n != Vector3{}) arcs.push_back({a, b});
    }
    std::vector<std::size_t> faces;
    std::vector<std::size_t> components;
    for (int turn = 0; turn < 4; ++turn) {
      GeodesicFamily family;
      PieceList<GeodesicFamily> list;
      const auto turned = [&](const Vector3& v) {
        return turn == 0   ? v
               : turn == 1 ? Vector3{v.y, v.z, v.x}
               : turn == 2 ? Vector3{-v.z, v.y, v.x}
                           : Vector3{-v.x, -v.y, v.z};
      };
      for (const auto& arc : arcs) family.add_arc(list, turned(arc[0]), turned(arc[1]));
      const GeodesicArrangement arrangement = arrange(std::move(family), list, Context());
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << round << ' ' << turn;
      faces.push_back(arrangement.counts().faces);
      components.push_back(arrangement.counts().components);
    }
    for (int turn = 1; turn < 4; ++turn) {
      ASSERT_EQ(faces[turn], faces[0]) << round;
      ASSERT_EQ(components[turn], components[0]) << round;
    }
  }
}

}  // namespace
}  // namespace quoin
