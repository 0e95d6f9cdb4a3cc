// SPDX-License-Identifier: Apache-2.0
//
// Known answers about motions, integrity and configurations that rounding breaks: C. M. Hoffmann, Geometric and Solid
// Modeling, 1989, sections 1.1 and 4.3 to 4.4.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "quoin/base/error.h"
#include "quoin/io/mesh_file.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/transformation.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/query/section.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

// The block of a mesh after a motion whose coordinates are rounded to doubles.
Mesh moved(Mesh mesh, const Transformation& motion) {
  for (Point3& p : mesh.vertices) p = motion.rounded_image(p);
  return shapes::triangulated(mesh);
}

// Of the triangles of a box, in pairs per side, against the four corners of the opposite side: how many are not
// strictly below.
int violated_conditions(const Mesh& block) {
  int violated = 0;
  for (std::size_t t = 0; t < block.face_count(); ++t) {
    const auto side = block.face(t);
    std::set<std::uint32_t> here(side.begin(), side.end());
    const auto twin = block.face(t ^ 1U);
    here.insert(twin.begin(), twin.end());
    for (std::uint32_t v = 0; v < 8; ++v) {
      if (here.contains(v)) continue;
      const Sign s =
          orientation(block.vertices[side[0]], block.vertices[side[1]], block.vertices[side[2]], block.vertices[v]);
      violated += s == Sign::negative ? 0 : 1;  // seen counterclockwise from outside, and the corner is on the far side
    }
  }
  return violated;
}

Transformation turn_about_all_axes(int i) {
  const auto part = [&](int k) { return Rational(1 + (i * 7 + k * 5) % 97) / Rational(101 + k); };
  return Transformation::rotation(0, part(0)) * Transformation::rotation(1, part(1)) *
         Transformation::rotation(2, part(2));
}

// Section 4.3.5: after a motion each corner of a block is strictly below the plane of the opposite side, two triangles
// per side here: 48 conditions. Then the block is a solid.
TEST(KnownAnswersRobustness, IntegrityOfAMovedBlock) {
  EXPECT_EQ(violated_conditions(shapes::triangulated(shapes::box({0, 0, 0}, {3, 4, 5}))), 0);
  for (int i = 0; i < 50; ++i) {
    const Mesh block = moved(shapes::box({0, 0, 0}, {3, 4, 0x1p-20}), turn_about_all_axes(i));
    EXPECT_EQ(violated_conditions(block), 0);
    const LeafResult result = make_leaf(block, {}, one_thread);
    ASSERT_NE(result.leaf, nullptr);
    EXPECT_FALSE(result.leaf->crosses_itself);
    const Solid s = Solid::from_leaf(result.leaf, one_thread);
    expect_valid(s);
    EXPECT_GT(volume_of(s), Rational(0));
  }
}

// Section 4.3.5: a block as thin as the spacing of the numbers may lose its integrity when it is turned. Then the
// findings say so where faces cross, and what is made of it is a valid solid or nothing.
TEST(KnownAnswersRobustness, ABlockTooThinToBeTurned) {
  int broken = 0;
  int reported = 0;
  for (int i = 0; i < 50; ++i) {
    for (const int exponent : {-49, -51, -53, -60}) {
      const Point3 low{8, 8, 8};
      Mesh plate = shapes::box({0, 0, 0}, {3, 4, std::ldexp(1.0, exponent)});
      const Mesh block = moved(plate, Transformation::translation(low.x, low.y, low.z) * turn_about_all_axes(i));
      const int violated = violated_conditions(block);
      const LeafResult result = make_leaf(block, {}, one_thread);
      ASSERT_NE(result.leaf, nullptr);
      const Solid s = Solid::from_leaf(result.leaf, one_thread);
      expect_valid(s);
      SCOPED_TRACE(::testing::Message() << "motion " << i << " thickness 2^" << exponent);
      if (violated == 0) {
        EXPECT_FALSE(result.leaf->crosses_itself);
        EXPECT_GT(volume_of(s), Rational(0));
      }
      reported += result.leaf->crosses_itself || result.diagnosis.degenerate_faces.count > 0 ? 1 : 0;
      broken += violated > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(broken, 50);
  EXPECT_GT(reported, 50);
}

// Figures 4.8 to 4.10: triangles with one corner on a circle of radius 1e-4 and two on the unit circle.
// The border of their union has cracks that show at 500 times the size only.
std::vector<Mesh> narrow_triangles(int count) {
  std::mt19937_64 random(150);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  std::vector<Mesh> prisms;
  for (int i = 0; i < count; ++i) {
    const double a = angle(random);
    std::array<double, 3> angles{a, angle(random), angle(random)};
    const std::array<double, 3> radii{1e-4, 1, 1};
    Mesh prism = shapes::prism(3, 1, 1);
    for (Point3& p : prism.vertices) {
      // The corners of the prism are at angles 0, 120 and 240 degrees.
      const std::size_t k = p.y == 0 || std::fabs(p.y) < 0.5 ? 0 : p.y > 0 ? 1 : 2;
      p.x = radii[k] * std::cos(angles[k]);
      p.y = radii[k] * std::sin(angles[k]);
    }
    prisms.push_back(shapes::approximate_volume(prism) > 0 ? prism : shapes::reversed(prism));
  }
  return prisms;
}

TEST(KnownAnswersRobustness, UnionOfManyNarrowTriangles) {
  const std::vector<Mesh> prisms = narrow_triangles(150);
  std::vector<Solid> upright;
  for (const Mesh& prism : prisms) upright.push_back(solid(prism));
  const Solid all = unite(upright, one_thread);
  expect_valid(all);
  EXPECT_EQ(all.boundary().component_count, 1U);
  const Section cut = section(all.boundary(), {{0, 0, 1}, Rational(1) / Rational(2)}, one_thread);
  EXPECT_EQ(area_vector(cut).z, volume_of(all));
  EXPECT_EQ(triangulate_boundary(all.boundary(), {}, one_thread).rounding, Rounding::certified);
}

// The same after a rigid motion, by making the solid anew from moved parts; its topology may be another one.
TEST(KnownAnswersRobustness, UnionOfMovedNarrowTriangles) {
  const Transformation motion = turn_about_all_axes(3);
  std::vector<Solid> upright;
  std::vector<Solid> turned;
  for (const Mesh& prism : narrow_triangles(30)) {
    upright.push_back(solid(prism));
    turned.push_back(solid(moved(prism, motion)));
  }
  const Solid all = unite(turned, one_thread);
  expect_valid(all);
  EXPECT_NEAR(rounded_volume(all.boundary(), one_thread),
              rounded_volume(unite(upright, one_thread).boundary(), one_thread), 1e-12);
}

// Section 4.4.1, Pappus: with the first eight of the lines 135, 246, 127, 239, 348, 457, 569, 168, 789 the ninth holds;
// no number near its place makes it fail.
TEST(KnownAnswersRobustness, NinePointsOnNineLines) {
  const auto third = [](std::vector<Point3> points) {
    for (int i = 0; i < 6; ++i) points[static_cast<std::size_t>(i)].z = 0;
    Constructions table(std::move(points));
    table.resize_points(9);
    const auto at = [](std::uint32_t number) { return PointId{number - 1}; };
    table.set_crossing(at(7), at(1), at(2), at(4), at(5), 2);
    table.set_crossing(at(8), at(3), at(4), at(1), at(6), 2);
    table.set_crossing(at(9), at(2), at(3), at(5), at(6), 2);
    EXPECT_EQ(table.turn_any(at(7), at(8), at(9), 2), Sign::zero);
    return std::array{table.exact(at(7)), table.exact(at(8)), table.exact(at(9))};
  };
  const auto known = third({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 1, 0}});
  EXPECT_EQ(known[0], (RationalPoint3{Rational(2) / Rational(3), Rational(2) / Rational(3), 0}));
  EXPECT_EQ(known[1], (RationalPoint3{Rational(3) / Rational(4), Rational(1) / Rational(4), 0}));
  EXPECT_EQ(known[2], (RationalPoint3{1, -1, 0}));
  EXPECT_EQ(Rational(5) * known[2].x + known[2].y, Rational(4));
  std::mt19937_64 random(51);
  int decided = 0;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    // 1, 3, 5 and 2, 4, 6 on two lines through lattice points.
    const auto small = [&]() { return static_cast<double>(random() % 1000) - 500; };
    const Point3 a{small(), small(), 0};
    const Point3 b{small(), small(), 0};
    const Point3 d{small(), small(), 0};
    const Point3 e{small(), small(), 0};
    if (a.x * b.y == a.y * b.x || d.x * e.y == d.y * e.x || a.x * d.y == a.y * d.x) continue;
    const auto on = [](const Point3& p, const Point3& v, double t) { return Point3{p.x + t * v.x, p.y + t * v.y, 0}; };
    const std::vector<Point3> points{a, d, on(a, b, 3), on(d, e, 7), on(a, b, -5), on(d, e, 11)};
    try {
      third(points);
      ++decided;
    } catch (const InternalError&) {  // two of the lines are parallel
    }
  }
  EXPECT_GT(decided, 900);
}

// The faces of a block with a bevelled square hole along an axis: outer sides, bevels, inner sides.
Mesh block_with_bevelled_hole(shapes::Axis axis) {
  Mesh mesh;
  const auto corner = [](int inner, int x, int y, int z) {
    return static_cast<std::uint32_t>(8 * inner + 4 * z + 2 * y + x);
  };
  for (const double size : {3.0, 1.0}) {
    for (int v = 0; v < 8; ++v)
      mesh.vertices.push_back({(v & 1) != 0 ? size : -size, (v & 2) != 0 ? size : -size, (v & 4) != 0 ? size : -size});
  }
  constexpr std::array<std::array<int, 2>, 4> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [x, y] = around[i];
    const auto [u, v] = around[(i + 1) % 4];
    mesh.add_face(std::array{corner(0, x, y, 0), corner(0, u, v, 0), corner(0, u, v, 1), corner(0, x, y, 1)});
    mesh.add_face(std::array{corner(1, u, v, 0), corner(1, x, y, 0), corner(1, x, y, 1), corner(1, u, v, 1)});
    mesh.add_face(std::array{corner(0, x, y, 1), corner(0, u, v, 1), corner(1, u, v, 1), corner(1, x, y, 1)});
    mesh.add_face(std::array{corner(0, u, v, 0), corner(0, x, y, 0), corner(1, x, y, 0), corner(1, u, v, 0)});
  }
  return shapes::pointing_along(mesh, axis);
}

std::set<std::array<double, 6>> edges_of(const Solid& s) {
  std::set<std::array<double, 6>> edges;
  const Brep& b = s.boundary();
  for (std::size_t l = 0; l < b.loop_count(); ++l) {
    for (std::size_t i = 0; i < b.loop(l).size(); ++i) {
      Point3 p = b.points.rounded(b.loop(l)[i]);
      Point3 q = b.points.rounded(b.loop(l)[(i + 1) % b.loop(l).size()]);
      if (lexicographically_less(q, p)) std::swap(p, q);
      edges.insert({p.x, p.y, p.z, q.x, q.y, q.z});
    }
  }
  return edges;
}

// Section 1.1: a block with a bevelled hole along x, y or z has one wireframe and is three solids. A file of edges
// alone stands for none of them: it is read as the empty solid, and both are said.
TEST(KnownAnswersRobustness, OneWireframeOfThreeSolids) {
  std::vector<Solid> solids;
  for (const shapes::Axis axis : {shapes::Axis::x, shapes::Axis::y, shapes::Axis::z}) {
    solids.push_back(solid(block_with_bevelled_hole(axis)));
    EXPECT_EQ(counts_of(solids.back()), (Counts{16, 32, 16, 16, 1, 1}));
    expect_valid(solids.back());
  }
  const auto wireframe = edges_of(solids[0]);
  EXPECT_EQ(wireframe.size(), 32U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(edges_of(solids[i]), wireframe);
    EXPECT_EQ(volume_of(solids[i]), volume_of(solids[0]));
    EXPECT_FALSE((solids[i] ^ solids[i - 1]).is_empty());
  }
  std::ostringstream obj;
  for (const auto& e : wireframe) {
    obj << "v " << e[0] << " " << e[1] << " " << e[2] << "\nv " << e[3] << " " << e[4] << " " << e[5] << "\nl -2 -1\n";
  }
  const MeshFile file = read_mesh(obj.str(), "wireframe.obj", {}, one_thread);
  EXPECT_EQ(file.mesh.face_count(), 0U);
  EXPECT_EQ(file.report.warnings,
            (std::vector<std::string>{"'l' statements are not kept: 32", "no faces; vertices in the file: 64"}));
}

// Section 4.4: planes that are meant to meet in one point do so exactly, or not at all; nothing in between is made up.
// Four faces meet in the corner of an octahedron; moved by 2^-40 one of them leaves two corners.
TEST(KnownAnswersRobustness, FourPlanesThroughOnePoint) {
  const Solid octahedron = solid(shapes::octahedron(1));
  const auto half_space = [](double offset) {  // x + y + z <= offset within a large cube
    Mesh mesh;
    mesh.vertices = {{offset + 8, -4, -4}, {-4, offset + 8, -4}, {-4, -4, offset + 8}, {-4, -4, -4}};
    for (const Tile& t : {Tile{0, 1, 2}, Tile{1, 0, 3}, Tile{2, 1, 3}, Tile{0, 2, 3}}) mesh.add_face(t);
    return solid(mesh);
  };
  const Solid exact = octahedron & half_space(1);
  EXPECT_EQ(counts_of(exact), (Counts{6, 12, 8, 8, 1, 0}));
  expect_same_set(exact, octahedron);
  const Solid cut = octahedron & half_space(1 - 0x1p-40);
  EXPECT_EQ(counts_of(cut), (Counts{9, 15, 8, 8, 1, 0}));
  for (const Solid& s : {exact, cut}) expect_valid(s);
}

}  // namespace
}  // namespace quoin::testing
