// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "quoin/kernel/predicates3.h"
#include "quoin/solid/exit_sides.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"
#include "quoin/solid/test_solids.h"

namespace quoin {
namespace {

using quoin::testing::one_thread;
using quoin::testing::solid;

Triangulated singles(const Solid& s) {
  ExitOptions options;
  options.precision = Precision::binary32;
  return triangulate_boundary(s.boundary(), options, one_thread);
}

Mesh mesh_of(const Triangulated& t) {
  Mesh mesh;
  mesh.vertices = t.vertices;
  for (const Tile& tile : t.triangles) mesh.add_face(tile);
  return mesh;
}

Mesh tetrahedron(const std::array<Point3, 4>& corners) {
  Mesh mesh;
  mesh.vertices.assign(corners.begin(), corners.end());
  for (const Tile& t : {Tile{0, 2, 1}, Tile{0, 1, 3}, Tile{1, 2, 3}, Tile{2, 0, 3}}) mesh.add_face(t);
  return mesh;
}

TEST(Exit, WhatVanishesIsNotCertified) {
  for (const Mesh& mesh :
       {shapes::box({1e9, 1e9, 1e9}, {1e9 + 1, 1e9 + 1, 1e9 + 1}), shapes::box({0, 0, 1}, {1, 1, 1 + 1e-9})}) {
    const Triangulated t = singles(solid(mesh));
    EXPECT_EQ(t.rounding, Rounding::changed);
    EXPECT_TRUE(t.triangles.empty());
    EXPECT_EQ(t.topology_before.components, 1U);
    EXPECT_EQ(t.topology_after.components, 0U);
    ASSERT_NE(t.resolved, nullptr);
    EXPECT_EQ(t.resolved->face_count(), 0U);
    EXPECT_EQ(triangulate_boundary(solid(mesh).boundary(), {}, one_thread).rounding, Rounding::exact);
  }
}

TEST(Exit, WhatFusesIsNotCertified) {
  const Solid near = solid(shapes::joined({shapes::cube(), shapes::box({1 + 1e-9, 0, 0}, {2, 1, 1})}));
  const Triangulated fused = singles(near);
  EXPECT_EQ(fused.rounding, Rounding::changed);
  EXPECT_EQ(fused.topology_before.components, 2U);
  EXPECT_EQ(fused.topology_after.components, 1U);
  const Solid hollow =
      solid(shapes::joined({shapes::cube(), shapes::reversed(shapes::box({0.5, 0.5, 0.5}, {0.5 + 1e-9, 0.75, 0.75}))}));
  const Triangulated filled = singles(hollow);
  EXPECT_EQ(filled.rounding, Rounding::changed);
  EXPECT_EQ(filled.topology_before.voids, 1U);
  EXPECT_EQ(filled.topology_after.voids, 0U);
}

TEST(Exit, TunnelsThatCloseAreNotCertified) {
  const Solid block = solid(shapes::cube());
  const Solid slit = solid(shapes::box({0.25, 0.5, -1}, {0.75, 0.5 + 1e-9, 2}));
  const Triangulated t = singles(subtract(block, {&slit, 1}, one_thread));
  EXPECT_EQ(t.rounding, Rounding::changed);
  EXPECT_EQ(t.topology_before.handles, 1U);
  EXPECT_EQ(t.topology_after.handles, 0U);
}

// Thinner than the spacing of singles, tetrahedra keep their volume's sign, turn inside out or go flat. None crosses
// itself in the first two cases.
TEST(Exit, ShellsThatTurnInsideOutAreNotCertified) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t changed = 0;
  std::size_t kept = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    std::array<Point3, 4> p{Point3{0.1, 0.1, unit(random)}, {1.1, 0.1, unit(random)}, {0.1, 1.1, unit(random)}, {}};
    for (std::size_t k = 0; k < 3; ++k) p[3][k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
    p[3].z += 1e-8;
    const Triangulated t = singles(solid(tetrahedron(p)));
    SCOPED_TRACE(::testing::Message() << "repeat " << repeat);
    ASSERT_TRUE(t.rounding == Rounding::certified || t.rounding == Rounding::changed);
    const Mesh mesh = mesh_of(t);
    const double volume = mesh.face_count() == 0 ? 0 : rounded_volume(solid(mesh).boundary(), one_thread);
    EXPECT_EQ(t.rounding == Rounding::certified, volume > 0);
    (volume > 0 ? kept : changed) += 1;
  }
  EXPECT_GT(kept, 5U);
  EXPECT_GT(changed, 5U);
}

// Of a pyramid over a star of a few of the smallest doubles in area, its apex 2^1000 away, products of two coordinates
// of the base underflow: what is inside out must not seem right.
TEST(Exit, SidesAreNotEvidentFromProductsThatUnderflow) {
  constexpr std::uint32_t n = 60;
  const Solid outward = solid(shapes::cube());  // one shell, its material inside
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int repeat = 0; repeat < 300; ++repeat) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.8 * unit(random)) / n;
      const double radius = 0x1p-535 * (i % 2 == 0 ? 1.0 : 0.02) * (0.8 + 0.4 * unit(random));
      mesh.vertices.push_back({0, radius * std::cos(angle), radius * std::sin(angle)});
    }
    mesh.vertices.push_back({0, 0, 0});
    mesh.vertices.push_back({0x1p1000, 0, 0});
    for (std::uint32_t i = 0; i < n; ++i) mesh.add_face(Tile{n, (i + 1) % n, i});
    for (std::uint32_t i = 0; i < n; ++i) mesh.add_face(Tile{n + 1, i, (i + 1) % n});
    std::vector<Tile> inside_out;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      inside_out.push_back({face[0], face[2], face[1]});
    }
    std::rotate(inside_out[0].begin(), inside_out[0].begin() + 1, inside_out[0].end());  // seen from the rim
    const std::vector<std::uint32_t> faces(inside_out.size(), 0);
    EXPECT_FALSE(are_sides_evident(outward.boundary(), mesh.vertices, inside_out, faces, one_thread)) << repeat;
  }
}

// A small body in front of a large slanting face ends up behind it, without crossing it.
TEST(Exit, BodiesThatComeToLieInOthersAreNotCertified) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t swallowed = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    const double scale = 1 << 20;
    const double left_z = unit(random);
    const double right_z = unit(random);
    const std::array<Point3, 4> large{
        Point3{-scale, -scale, left_z}, {scale, -scale, right_z}, {0, scale, -(left_z + right_z) / 2}, {0, 0, -scale}};
    const double z = 1e-10;
    const double e = 0x1p-34;
    const std::array<Point3, 4> small{Point3{0, 0, z}, {e, 0, z}, {0, e, z}, {0, 0, z + e}};
    const Solid both = solid(shapes::joined({shapes::reversed(tetrahedron(large)), tetrahedron(small)}));
    ASSERT_EQ(both.boundary().component_count, 2U);
    const Triangulated t = singles(both);
    const Mesh mesh = mesh_of(t);
    const std::size_t left = solid(mesh).boundary().component_count;
    EXPECT_EQ(t.rounding == Rounding::certified, left == 2U) << "repeat " << repeat;
    swallowed += left == 1 ? 1 : 0;
  }
  EXPECT_GT(swallowed, 0U);
}

std::vector<std::size_t> polygon_sizes(const Solid& s, Precision precision) {
  ExitOptions options;
  options.precision = precision;
  options.keep_polygons = true;
  const FacePolygons polygons = triangulate_boundary(s.boundary(), options, one_thread).polygons;
  std::vector<std::size_t> sizes;
  for (std::size_t i = 1; i < polygons.begin.size(); ++i) sizes.push_back(polygons.begin[i] - polygons.begin[i - 1]);
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

// Corners of a small grid, so that vertices, edges and faces often touch and vertices often lie on one line. What
// leaves is read again as an operand that does not cross itself, with the same volume but for the rounding.
TEST(Exit, TetrahedraOnSmallGridsLeaveWithoutSnapping) {
  std::mt19937_64 random(41);
  std::size_t snapped = 0;
  std::size_t made = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    const int grid = 3 + repeat % 3;
    const auto draw = [&] {
      for (;;) {
        std::array<Point3, 4> p;
        for (Point3& q : p) {
          for (std::size_t k = 0; k < 3; ++k) q[k] = static_cast<double>(random() % static_cast<unsigned>(grid));
        }
        const Sign sign = orientation(p[0], p[1], p[2], p[3]);
        if (sign == Sign::zero) continue;
        if (sign == Sign::positive) std::swap(p[0], p[1]);
        const LeafResult leaf = make_leaf(tetrahedron(p), {}, one_thread);
        if (leaf.leaf && leaf.diagnosis.inverted_components.count == 0) return Solid::from_leaf(leaf.leaf, one_thread);
        std::swap(p[0], p[1]);
        return solid(tetrahedron(p));
      }
    };
    const Solid a = draw();
    const Solid b = draw();
    for (const Solid& result : {unite(std::array{a, b}, one_thread), intersect(std::array{a, b}, one_thread),
                                subtract(a, {&b, 1}, one_thread), symmetric_difference(std::array{a, b}, one_thread)}) {
      const Triangulated t = triangulate_boundary(result.boundary(), {}, one_thread);
      SCOPED_TRACE(::testing::Message() << "repeat " << repeat << " result " << made % 4);
      ++made;
      EXPECT_LE(t.rounding, Rounding::certified);
      snapped += t.rounds > 0 ? 1 : 0;
      const LeafResult again = make_leaf(mesh_of(t), {}, one_thread);
      ASSERT_NE(again.leaf, nullptr);
      EXPECT_EQ(again.diagnosis.crossing_faces.count, 0U);
      EXPECT_NEAR(rounded_volume(Solid::from_leaf(again.leaf, one_thread).boundary(), one_thread),
                  rounded_volume(result.boundary(), one_thread), 1e-9);
    }
  }
  EXPECT_EQ(snapped, 0U) << "of " << made;
}

TEST(Exit, PlanarFacesWithoutHolesStayPolygons) {
  using Sizes = std::vector<std::size_t>;
  const Solid cube = solid(shapes::cube());
  EXPECT_EQ(polygon_sizes(cube, Precision::binary64), Sizes(6, 4));
  const Solid corner = solid(shapes::box({0.5, 0.5, -1}, {2, 2, 2}));
  EXPECT_EQ(polygon_sizes(subtract(cube, {&corner, 1}, one_thread), Precision::binary64),
            (Sizes{4, 4, 4, 4, 4, 4, 6, 6}));
  const Solid drill = solid(shapes::box({0.25, 0.25, 0.5}, {0.75, 0.75, 2}));
  EXPECT_EQ(polygon_sizes(subtract(cube, {&drill, 1}, one_thread), Precision::binary64), Sizes(10, 4));
}

// Rounding leaves the faces of a box planar, not those of a turned one.
TEST(Exit, FacesThatRoundingBendsAreTriangulated) {
  EXPECT_EQ(polygon_sizes(solid(shapes::box({0.1, 0.1, 0.1}, {0.7, 0.7, 0.7})), Precision::binary32).size(), 6U);
  const Mesh turned = shapes::rotated(shapes::rotated(shapes::cube(), shapes::Axis::x, 0.3), shapes::Axis::y, 0.7);
  EXPECT_LT(polygon_sizes(solid(turned), Precision::binary32).size(), 6U);
}

}  // namespace
}  // namespace quoin
