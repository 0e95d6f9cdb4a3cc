// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"

namespace quoin {
namespace {

using Betti = std::vector<std::size_t>;

Mesh mesh_of(std::size_t vertices, const std::vector<std::vector<std::uint32_t>>& faces) {
  Mesh mesh;
  mesh.vertices.resize(vertices);
  for (const auto& face : faces) mesh.add_face(face);
  return mesh;
}

Betti betti_of(const Mesh& mesh) {
  const MeshComplex made = complex_of_mesh(mesh, Context());
  return integer_homology(SimplicialComplex::closure_of(made.simplices, Context()), Context()).betti;
}

const std::vector<std::vector<std::uint32_t>> cube{{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                                   {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};

TEST(MeshComplex, PolygonsAreDisks) {
  EXPECT_EQ(betti_of(mesh_of(8, cube)), (Betti{1, 0, 1}));
  auto open = cube;
  open.pop_back();
  EXPECT_EQ(betti_of(mesh_of(8, open)), (Betti{1, 0, 0}));
  // Two squares over the same corners in other orders: the diagonals of one are sides of the other.
  EXPECT_EQ(betti_of(mesh_of(4, {{0, 1, 2, 3}, {0, 2, 1, 3}})), (Betti{1, 1, 0}));
  // Eight edges less seven: of the annulus between two squares, as one polygon that goes back and forth along a bridge.
  EXPECT_EQ(betti_of(mesh_of(8, {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}})), (Betti{1, 1, 0}));
}

TEST(MeshComplex, FacesThatComeTwiceCountOnce) {
  auto doubled = cube;
  doubled.push_back({1, 3, 2, 0});
  doubled.push_back({2, 3, 1, 0});
  const MeshComplex made = complex_of_mesh(mesh_of(8, doubled), Context());
  EXPECT_EQ(made.repeated_faces, 2U);
  EXPECT_EQ(betti_of(mesh_of(8, doubled)), (Betti{1, 0, 1}));
}

using Face = std::vector<std::uint32_t>;

// By definition: the least of all rotations both ways around.
Face least_turn(Face face) {
  Face least = face;
  for (int way = 0; way < 2; ++way) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
      least = std::min(least, face);
    }
    std::reverse(face.begin(), face.end());
  }
  return least;
}

TEST(MeshComplex, FacesOfFewCornersInAnyTurnAreTold) {
  std::mt19937 random(1);
  for (int round = 0; round < test_rounds(300); ++round) {
    std::vector<Face> faces;
    std::set<Face> distinct;
    for (int f = 0; f < 60; ++f) {
      // Neighbours differ, and so do the ends.
      Face face{0};
      const std::size_t size = 3 + random() % 6;
      while (face.size() < size || face.back() == face.front()) {
        face.push_back((face.back() + 1 + static_cast<std::uint32_t>(random() % 2)) % 3);
      }
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()), face.end());
      faces.push_back(face);
      distinct.insert(least_turn(face));
    }
    ASSERT_EQ(complex_of_mesh(mesh_of(3, faces), Context()).repeated_faces, faces.size() - distinct.size());
  }
}

// Every second corner is the smallest.
TEST(MeshComplex, ALongFaceTakesNoLongerThanManyShortOnes) {
  constexpr std::uint32_t spokes = test_rounds(100000U);
  Face face;
  for (std::uint32_t i = 1; i <= spokes; ++i) face.insert(face.end(), {0, i});
  Face other(face.rbegin(), face.rend());
  std::rotate(other.begin(), other.begin() + spokes, other.end());
  const MeshComplex made = complex_of_mesh(mesh_of(spokes + 1, {face, other}), Context());
  EXPECT_EQ(made.repeated_faces, 1U);
  EXPECT_EQ(made.simplices.size(), 3 * face.size());
}

TEST(MeshComplex, ThinFacesAndLonelyVertices) {
  const Mesh mesh = mesh_of(6, {{0, 1, 1}, {2, 2, 2}, {0, 1, 0}});
  const MeshComplex made = complex_of_mesh(mesh, Context());
  EXPECT_EQ(made.thin_faces, 3U);
  EXPECT_EQ(made.lonely_vertices, 3U);
  EXPECT_EQ(betti_of(mesh), (Betti{2, 0}));
  EXPECT_EQ(betti_of(mesh_of(2, {})), (Betti{2}));
}

TEST(MeshComplex, ABoundaryThatGoesRoundTwiceIsAProjectivePlane) {
  const MeshComplex made = complex_of_mesh(mesh_of(3, {{0, 1, 2, 0, 1, 2}}), Context());
  const SimplicialComplex complex = SimplicialComplex::closure_of(made.simplices, Context());
  EXPECT_EQ(integer_homology(complex, Context()).torsion[1], (std::vector<Integer>{2}));
}

}  // namespace
}  // namespace quoin
