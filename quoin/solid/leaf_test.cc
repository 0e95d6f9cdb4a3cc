// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "quoin/base/error.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/repair.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"
#include "quoin/solid/star_certificate.h"

namespace quoin {
namespace {

const Context context;

LeafResult leaf_of(const Mesh& mesh) {
  return make_leaf(mesh, {}, context);
}

TEST(Leaf, ShapesAreSoundAndOutward) {
  for (const Mesh& mesh : {shapes::cube(), shapes::prism(7, 1, 2), shapes::cylinder(9, 1, 1), shapes::pyramid(5, 1, 1),
                           shapes::tetrahedron(), shapes::octahedron(), shapes::icosahedron(),
                           shapes::geodesic_sphere(4), shapes::uv_sphere(8, 5), shapes::torus(8, 6, 2, 0.5)}) {
    const LeafResult result = leaf_of(mesh);
    ASSERT_NE(result.leaf, nullptr);
    EXPECT_FALSE(result.leaf->crosses_itself);
    EXPECT_EQ(result.diagnosis.inverted_components.count, 0U);
    EXPECT_EQ(result.diagnosis.degenerate_faces.count + result.diagnosis.not_planar_faces.count, 0U);
  }
}

TEST(Leaf, PolygonsAreCutAtAnyScale) {
  // A U, so that fans would fail, turned to every axis.
  const std::vector<Point2> outline{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  for (const shapes::Axis axis : {shapes::Axis::x, shapes::Axis::y, shapes::Axis::z}) {
    for (const int exponent : {-1070, -600, 0, 600, 1020}) {
      const double scale = std::ldexp(1.0, exponent);
      Mesh mesh;
      std::vector<std::uint32_t> bottom;
      std::vector<std::uint32_t> top;
      for (std::uint32_t i = 0; i < 8; ++i) {
        mesh.vertices.push_back({outline[i].x, outline[i].y, 0});
        bottom.insert(bottom.begin(), i);
        top.push_back(8 + i);
      }
      for (std::uint32_t i = 0; i < 8; ++i) mesh.vertices.push_back({outline[i].x, outline[i].y, 1});
      mesh.add_face(bottom);
      mesh.add_face(top);
      for (std::uint32_t i = 0; i < 8; ++i) mesh.add_face(std::array{i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
      const LeafResult result = leaf_of(shapes::scaled(shapes::pointing_along(mesh, axis), {scale, scale, scale}));
      SCOPED_TRACE(::testing::Message() << "axis " << static_cast<int>(axis) << " exponent " << exponent);
      ASSERT_NE(result.leaf, nullptr);
      EXPECT_EQ(result.diagnosis.not_simple_faces.count + result.diagnosis.not_planar_faces.count, 0U);
      EXPECT_FALSE(result.leaf->crosses_itself);
      EXPECT_EQ(result.diagnosis.inverted_components.count, 0U);
      Rational cubic(7);
      for (int i = 0; i < 3; ++i) cubic *= Rational(scale);
      EXPECT_EQ(volume(Solid::from_leaf(result.leaf, context).boundary(), context), cubic);
    }
  }
}

TEST(Leaf, FindingsNameTheirElements) {
  Mesh mesh = shapes::triangulated(shapes::cube());
  std::swap(mesh.corners[0], mesh.corners[1]);
  const LeafResult turned = leaf_of(mesh);
  EXPECT_EQ(turned.leaf, nullptr);
  EXPECT_EQ(turned.diagnosis.misoriented_edges.count, 3U);
  Mesh wild = shapes::cube();
  wild.vertices[3].y = std::nan("");
  const LeafResult refused = leaf_of(wild);
  EXPECT_EQ(refused.leaf, nullptr);
  EXPECT_EQ(refused.diagnosis.not_finite.elements, std::vector<std::uint32_t>{3});
  Mesh missing = shapes::cube();
  missing.corners[5] = 99;
  EXPECT_THROW(leaf_of(missing), InputError);
  const LeafResult inverted = leaf_of(shapes::reversed(shapes::cube()));
  EXPECT_EQ(inverted.diagnosis.inverted_components.count, 1U);
  const Mesh hollow =
      shapes::joined({shapes::box({0, 0, 0}, {3, 3, 3}), shapes::reversed(shapes::box({1, 1, 1}, {2, 2, 2}))});
  EXPECT_EQ(leaf_of(hollow).diagnosis.inverted_components.count, 0U);
  const Mesh edge = shapes::joined({shapes::box({0, 0, 0}, {1, 1, 1}), shapes::box({1, 1, 0}, {2, 2, 1})});
  EXPECT_GT(leaf_of(edge).diagnosis.crossing_faces.count, 0U) << "two edges on one spot that were not welded";
}

// Vertices of any degree, and edges that only sorting tells apart, give the same twins.
TEST(Leaf, TwinsAtLongFansAndAtEdgesOfManyTiles) {
  for (const std::size_t sides : {5U, 33U, 2000U}) {
    const LeafResult fan = leaf_of(shapes::pyramid(sides, 1, 1));
    ASSERT_NE(fan.leaf, nullptr);
    const Leaf& leaf = *fan.leaf;
    for (std::uint32_t h = 0; h < leaf.twins.size(); ++h) {
      const std::uint32_t twin = leaf.twins[h];
      ASSERT_LT(twin, leaf.twins.size());
      ASSERT_EQ(leaf.twins[twin], h);
      ASSERT_EQ(leaf.tiles[h / 3][h % 3], leaf.tiles[twin / 3][(twin % 3 + 1) % 3]);
      ASSERT_EQ(leaf.tiles[h / 3][(h % 3 + 1) % 3], leaf.tiles[twin / 3][twin % 3]);
    }
  }
  // Four tiles at one edge: two tetrahedra over shared vertices 0 and 1.
  Mesh pair;
  pair.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  for (const std::uint32_t first : {2U, 4U}) {
    const std::uint32_t second = first + 1;
    for (const Tile& t : {Tile{0, 1, first}, Tile{1, 0, second}, Tile{0, first, second}, Tile{1, second, first}}) {
      pair.add_face(t);
    }
  }
  const LeafResult shared = leaf_of(pair);
  ASSERT_NE(shared.leaf, nullptr);
  EXPECT_EQ(shared.diagnosis.nonmanifold_edges.count, 1U);
  EXPECT_EQ(std::count(shared.leaf->twins.begin(), shared.leaf->twins.end(), Leaf::no_twin), 4);
}

TEST(Leaf, SliversOfNoAreaAreHealed) {
  // A cube whose top is split at the middle of an edge on one side only, and closed by a collinear triangle.
  Mesh mesh = shapes::triangulated(shapes::cube());
  std::uint32_t a = mesh.corners[0];
  std::uint32_t b = mesh.corners[1];
  const std::uint32_t c = mesh.corners[2];
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  const Point3& p = mesh.vertices[a];
  const Point3& q = mesh.vertices[b];
  mesh.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  mesh.corners[1] = middle;
  mesh.add_face(Tile{middle, b, c});
  mesh.add_face(Tile{a, b, middle});  // no area
  const LeafResult result = leaf_of(mesh);
  ASSERT_NE(result.leaf, nullptr);
  EXPECT_EQ(result.diagnosis.degenerate_faces.count, 1U);
  EXPECT_FALSE(result.leaf->crosses_itself);
  EXPECT_EQ(volume(Solid::from_leaf(result.leaf, context).boundary(), context), Rational(1));
}

// A tetrahedron with an edge that one side walks along to and fro, and faces without an area that close it.
TEST(Leaf, SliversThatLeanOnSliversAreHealed) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    const auto n = static_cast<std::uint32_t>(3 + random() % 12);
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) mesh.vertices.push_back({static_cast<double>(i), 0, 0});
    const std::uint32_t left = n;
    const std::uint32_t right = n + 1;
    mesh.vertices.push_back({0, 1, 0});
    mesh.vertices.push_back({0, 0, 1});
    std::vector<std::uint32_t> walk(n);
    std::iota(walk.begin(), walk.end(), 0U);
    std::shuffle(walk.begin() + 1, walk.end() - 1, random);
    for (std::uint32_t i = 0; i + 1 < n; ++i) mesh.add_face(Tile{left, walk[i + 1], walk[i]});
    mesh.add_face(Tile{right, 0, n - 1});
    mesh.add_face(Tile{left, 0, right});
    mesh.add_face(Tile{left, right, n - 1});
    while (walk.size() > 2) {
      const std::size_t ear = 1 + random() % (walk.size() - 2);
      mesh.add_face(Tile{walk[ear - 1], walk[ear], walk[ear + 1]});
      walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    const LeafResult result = leaf_of(mesh);
    ASSERT_NE(result.leaf, nullptr);
    EXPECT_EQ(result.diagnosis.degenerate_faces.count, n - 2);
    EXPECT_EQ(volume(Solid::from_leaf(result.leaf, context).boundary(), context) * Rational(6),
              Rational(static_cast<double>(n - 1)));
  }
}

// A cone over a closed walk around the apex: it may turn once, several times, or fold back.
Mesh cone(const std::vector<double>& angles) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 1}, {0, 0, -1}};
  const auto n = static_cast<std::uint32_t>(angles.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.vertices.push_back({std::cos(angles[i]), std::sin(angles[i]), 0.01 * std::sin(3.0 * i)});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.add_face(Tile{0, 2 + i, 2 + (i + 1) % n});
    mesh.add_face(Tile{1, 2 + (i + 1) % n, 2 + i});
  }
  return mesh;
}

// A certificate at a vertex means that no two tiles of its star meet outside what they share; crossings are found in
// any case.
TEST(StarCertificate, NeverHidesACrossing) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> jump(-1.5, 2.5);
  std::size_t crossing = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    std::vector<double> angles;
    const int turns = 1 + repeat % 3;
    const int n = 6 + repeat % 9;
    for (int i = 0; i < n; ++i) {
      const double even = 2 * std::numbers::pi * turns * i / n;
      angles.push_back(repeat % 2 == 0 ? even : even + 0.4 * jump(random));
    }
    // Down to where products of two and of three lengths leave the range in which the certificate trusts itself.
    const double scale = std::ldexp(1.0, -140 * (repeat % 4));
    const Mesh mesh = shapes::scaled(cone(angles), {scale, scale, scale});
    const LeafResult with = leaf_of(mesh);
    if (!with.leaf) continue;
    // Every pair of tiles without the certificate, by the overlay's own contacts of a soup with the same ids: a leaf
    // that takes crossings for granted and is made into a solid must then have the same volume as the certified one.
    const LeafResult without = make_leaf(mesh, {.max_listed = 0, .find_crossings = false}, context);
    const Rational expected = volume(Solid::from_leaf(without.leaf, context).boundary(), context);
    ASSERT_EQ(volume(Solid::from_leaf(with.leaf, context).boundary(), context), expected) << "repeat " << repeat;
    EXPECT_TRUE(turns == 1 || with.leaf->crosses_itself) << "repeat " << repeat;
    crossing += with.leaf->crosses_itself ? 1 : 0;
  }
  EXPECT_GT(crossing, 200U);
}

std::vector<std::uint8_t> all_of(const Leaf& leaf) {
  return std::vector<std::uint8_t>(leaf.vertices.size(), 1);
}

// Edges of regular cones lie in the plane of the half-line itself.
TEST(StarCertificate, CertifiesTheApexOfRegularCones) {
  for (const std::uint32_t sides : {3U, 4U, 8U, 1000U}) {
    const LeafResult cone = leaf_of(shapes::pyramid(sides, 1, 1));
    const std::vector<std::uint8_t> certified = certify_stars(*cone.leaf, all_of(*cone.leaf), context);
    for (std::size_t v = 0; v < certified.size(); ++v) {
      if (cone.leaf->vertices[v].z != 1) continue;
      EXPECT_EQ(certified[v], 1) << sides << " sides";
    }
  }
}

TEST(StarCertificate, CertifiesSmoothSurfaces) {
  const LeafResult sphere = leaf_of(shapes::geodesic_sphere(30));
  const std::vector<std::uint8_t> certified = certify_stars(*sphere.leaf, all_of(*sphere.leaf), context);
  EXPECT_GT(std::count(certified.begin(), certified.end(), 1), 9 * static_cast<std::ptrdiff_t>(certified.size()) / 10);
}

Rational repaired_volume(const Mesh& mesh) {
  const LeafResult leaf = leaf_of(repair_mesh(mesh, context).mesh);
  if (!leaf.leaf) return Rational(-1);
  return volume(Solid::from_leaf(leaf.leaf, context).boundary(), context);
}

Point3 midpoint_of(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Point3& p = mesh.vertices[a];
  const Point3& q = mesh.vertices[b];
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
}

TEST(Repair, TurnsFacesAndDropsWhatIsTooMuch) {
  EXPECT_TRUE(repair_mesh(shapes::cube(), context).changes.empty());
  std::mt19937_64 random(29);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Mesh source = shapes::joined({shapes::box({0, 0, 0}, {4, 4, 4}), shapes::box({1, 1, 1}, {3, 3, 3}),
                                        shapes::box({1.5, 1.5, 1.5}, {2, 2, 2}), shapes::box({5, 0, 0}, {6, 1, 1})});
    Mesh mesh;
    mesh.vertices = source.vertices;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      std::vector<std::uint32_t> corners(source.face(f).begin(), source.face(f).end());
      if (random() % 2 == 0) std::reverse(corners.begin(), corners.end());
      mesh.add_face(corners);
      if (random() % 8 == 0) mesh.add_face(corners);
    }
    mesh.add_face(std::array<std::uint32_t, 3>{0, 0, 1});
    EXPECT_EQ(repaired_volume(mesh), Rational(64 - 8 + 1) + Rational(1) / Rational(8)) << "repeat " << repeat;
  }
}

// The long edge of a sliver on a closed surface is one edge too many; one that joins an edge with its halves is not.
TEST(Repair, DropsFacesOnALineWhereTheSurfaceClosesWithoutThem) {
  Mesh loose = shapes::cube();
  loose.vertices.push_back(midpoint_of(loose, 0, 1));
  const auto added = static_cast<std::uint32_t>(loose.vertices.size() - 1);
  const auto face = static_cast<std::uint32_t>(loose.face_count());
  loose.add_face(std::array<std::uint32_t, 3>{0, 1, added});
  EXPECT_EQ(leaf_of(loose).leaf, nullptr);
  const RepairResult repaired = repair_mesh(loose, context);
  ASSERT_EQ(repaired.changes.size(), 1U);
  EXPECT_EQ(repaired.changes[0].faces, std::vector<std::uint32_t>{face});
  EXPECT_EQ(repaired_volume(loose), Rational(1));
  Mesh strip = loose;  // two more that hang on the first
  strip.vertices.push_back(midpoint_of(strip, 0, added));
  strip.add_face(std::array<std::uint32_t, 3>{0, added + 1, added});
  strip.add_face(std::array<std::uint32_t, 3>{added, added + 1, 1});
  EXPECT_EQ(repair_mesh(strip, context).changes.at(0).faces.size(), 3U);
  EXPECT_EQ(repaired_volume(strip), Rational(1));
}

TEST(Repair, KeepsFacesOnALineThatJoinAnEdgeWithItsHalves) {
  const Mesh cube = shapes::cube();
  Mesh mesh;
  mesh.vertices = cube.vertices;
  mesh.vertices.push_back(midpoint_of(cube, cube.face(0)[0], cube.face(0)[1]));
  std::vector<std::uint32_t> corners(cube.face(0).begin(), cube.face(0).end());
  corners.insert(corners.begin() + 1, 8);
  mesh.add_face(corners);
  for (std::size_t f = 1; f < cube.face_count(); ++f) mesh.add_face(cube.face(f));
  mesh.add_face(std::array<std::uint32_t, 3>{corners[2], 8, corners[0]});
  EXPECT_NE(leaf_of(mesh).leaf, nullptr);
  EXPECT_TRUE(repair_mesh(mesh, context).changes.empty());
  EXPECT_EQ(repaired_volume(mesh), Rational(1));
}

// A grid whose last row is joined to its first, turned over or not (Hoffmann 1989: sphere and torus are orientable, the
// Klein bottle is not).
Mesh ring(bool turns_over) {
  constexpr std::uint32_t rows = 5;
  constexpr std::uint32_t columns = 4;
  Mesh mesh;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j)
      mesh.vertices.push_back({i * 1.0, j * 1.25, (i * i + 3 * j * j) % 7 * 1.0});
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    if (i == rows && turns_over) j = columns - j;
    return i % rows * columns + j % columns;
  };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      mesh.add_face(std::array{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.add_face(std::array{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

TEST(Repair, RefusesWhatNoOrientationFits) {
  EXPECT_EQ(leaf_of(ring(false)).diagnosis.misoriented_edges.count, 0U);
  const Mesh klein = ring(true);
  const LeafResult leaf = leaf_of(klein);
  EXPECT_EQ(leaf.leaf, nullptr);
  EXPECT_EQ(leaf.diagnosis.open_edges.count, 0U);
  ASSERT_EQ(leaf.diagnosis.one_sided_bands.count, 1U);
  EXPECT_GE(leaf.diagnosis.one_sided_bands.elements[0].size(), 3U);
  Mesh mesh = shapes::joined({shapes::reversed(shapes::cube()), klein});
  const RepairResult repaired = repair_mesh(mesh, context);
  const auto first = static_cast<std::uint32_t>(shapes::cube().face_count());
  ASSERT_EQ(repaired.refusals.size(), 1U);
  for (const std::uint32_t f : repaired.refusals[0].faces) EXPECT_GE(f, first);
  ASSERT_EQ(repaired.changes.size(), 1U);
  EXPECT_EQ(repaired.changes[0].faces.size(), first);  // the cube alone is turned
  Mesh one_face_turned = shapes::cube();
  std::reverse(one_face_turned.corners.begin(), one_face_turned.corners.begin() + 3);
  EXPECT_EQ(leaf_of(one_face_turned).diagnosis.one_sided_bands.count, 0U);
  EXPECT_TRUE(repair_mesh(one_face_turned, context).refusals.empty());
}

TEST(Leaf, VerticesOfNoFaceAreNamed) {
  Mesh mesh = shapes::cube();
  EXPECT_EQ(leaf_of(mesh).diagnosis.isolated_vertices.count, 0U);
  const auto added = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({7, 7, 7});
  mesh.vertices.push_back({8, 7, 7});
  const LeafResult result = leaf_of(mesh);
  EXPECT_NE(result.leaf, nullptr);
  EXPECT_EQ(result.diagnosis.isolated_vertices.elements, (std::vector<std::uint32_t>{added, added + 1}));
}

}  // namespace
}  // namespace quoin
