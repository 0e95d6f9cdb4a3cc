// SPDX-License-Identifier: Apache-2.0
//
// Known answers about the topology of boundaries: C. M. Hoffmann, Geometric and Solid Modeling, 1989, sections 2.3 and
// 2.4.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "quoin/solid/exit.h"
#include "quoin/solid/query/shell_components.h"
#include "quoin/solid/repair.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

// Section 2.3.3: the bracket of 2.2 with a square drill, V - E + F - (L - F) - 2 (S - G) = 0.
TEST(KnownAnswersTopology, TheBracketWithASquareHole) {
  const Solid bracket = (box({0, 0, 0}, {1, 4, 8}) | box({1, 0, 0}, {9, 4, 1})) - box({4, 1, 0}, {6, 3, 1});
  EXPECT_EQ(counts_of(bracket), (Counts{20, 30, 12, 14, 1, 1}));
  EXPECT_EQ(volume_of(bracket), Rational(60));
  expect_valid(bracket);
}

// Section 2.3.3: 8 - 12 + 6 = 2 of a cube, and V - E + F = 2 - 2 G with G handles where every face is a disc.
TEST(KnownAnswersTopology, HandlesOfASphere) {
  EXPECT_EQ(counts_of(solid(shapes::cube())), (Counts{8, 12, 6, 6, 1, 0}));
  EXPECT_EQ(counts_of(solid(shapes::geodesic_sphere(3))).genus, 0);
  EXPECT_EQ(counts_of(solid(shapes::torus(9, 7, 2, 0.7))).genus, 1);
  // Plates with holes, whose two large faces are no discs.
  for (int holes = 0; holes <= 5; ++holes) {
    Solid plate = box({0, 0, 0}, {4.0 * holes + 2, 6, 1});
    for (int i = 0; i < holes; ++i) plate = plate - box({4.0 * i + 2, 2, 0}, {4.0 * i + 4, 4, 1});
    const Counts c = counts_of(plate);
    EXPECT_EQ(c, (Counts{8 + 8 * holes, 12 + 12 * holes, 6 + 4 * holes, 6 + 6 * holes, 1, holes}));
    expect_valid(plate);
    // Triangles are discs.
    const Triangulated t = triangulate_boundary(plate.boundary(), {}, one_thread);
    const auto triangles = static_cast<long>(t.triangles.size());
    EXPECT_EQ(static_cast<long>(t.vertices.size()) - triangles / 2 * 3 + triangles, 2 - 2 * holes);
  }
}

// Section 2.3.3: an object with two handles.
TEST(KnownAnswersTopology, AnObjectWithTwoHandles) {
  const Mesh torus = shapes::torus(12, 8, 2, 0.75);
  const Solid both = solid(torus) | solid(shapes::translated(torus, {5, 0.125, 0.0625}));
  EXPECT_EQ(counts_of(both).genus, 2);
  EXPECT_EQ(both.boundary().shells.size(), 1U);
  expect_valid(both);
}

// Section 2.3.3, figure 2.35: (V, E, F, L, S, G) = (24, 36, 16, 18, 2, 1): a square hole through a box beside a void.
TEST(KnownAnswersTopology, ABoxWithAHoleAndAVoid) {
  const Solid s = (box({0, 0, 0}, {9, 5, 5}) - box({1, 1, 0}, {3, 3, 5})) - box({5, 1, 1}, {8, 4, 4});
  EXPECT_EQ(counts_of(s), (Counts{24, 36, 16, 18, 2, 1}));
  EXPECT_EQ(s.boundary().component_count, 1U);
  EXPECT_EQ(volume_of(s), Rational(225 - 20 - 27));
  expect_valid(s);
}

// Section 2.3.3: a triangular prism with a quadrilateral attached along one of its edges has V = 8, E = 12, F = 6; the
// formula holds, and it is no solid.
TEST(KnownAnswersTopology, ADanglingFaceIsRejectedThoughTheFormulaHolds) {
  Mesh mesh = shapes::prism(3, 1, 1);
  ASSERT_EQ(mesh.vertices.size(), 6U);
  const auto edge = std::array{mesh.face(0)[0], mesh.face(0)[1]};
  for (const std::uint32_t v : {edge[0], edge[1]}) {
    const Point3 p = mesh.vertices[v];
    mesh.vertices.push_back({p.x + 2, p.y + 3, p.z + 1});
  }
  const Mesh prism = mesh;
  mesh.add_face(std::array<std::uint32_t, 4>{edge[0], edge[1], 7, 6});
  const Brep boundary = boundary_of_faces(mesh);
  const TopologyCounts counts = count_topology(boundary);
  EXPECT_EQ(counts.vertices, 8U);
  EXPECT_EQ(counts.edges, 12U);
  EXPECT_EQ(counts.faces, 6U);
  EXPECT_EQ(counts.vertices - counts.edges + counts.faces, 2U);
  EXPECT_FALSE(check_boundary(boundary, 10, one_thread).empty());
  EXPECT_EQ(counts.unbalanced_edges, 4U);
  const LeafResult leaf = make_leaf(mesh, {}, one_thread);
  EXPECT_EQ(leaf.leaf, nullptr);
  EXPECT_EQ(leaf.diagnosis.open_edges.count, 4U);
  // With both its sides it bounds no volume: the solid is the prism alone.
  mesh.add_face(std::array<std::uint32_t, 4>{6, 7, edge[1], edge[0]});
  const Solid regular = solid(mesh);
  expect_same_set(regular, solid(prism));
  EXPECT_EQ(counts_of(regular), (Counts{6, 9, 5, 5, 1, 0}));
}

// Section 2.3.2: the winged edges of a tetrahedron, all 24 entries: per edge its ends, the faces on its left and right,
// and in the loop of each the other edge at the start and the other edge at the end.
TEST(KnownAnswersTopology, WingedEdgesOfATetrahedron) {
  struct Row {
    char edge;
    std::array<std::uint32_t, 2> ends;
    std::array<char, 2> faces;
    std::array<char, 2> left;
    std::array<char, 2> right;
  };
  constexpr Row rows[] = {
      {'a', {1, 2}, {'A', 'D'}, {'d', 'e'}, {'f', 'b'}}, {'b', {2, 3}, {'B', 'D'}, {'e', 'c'}, {'a', 'f'}},
      {'f', {3, 1}, {'C', 'D'}, {'c', 'd'}, {'b', 'a'}}, {'c', {3, 4}, {'B', 'C'}, {'b', 'e'}, {'f', 'd'}},
      {'d', {1, 4}, {'C', 'A'}, {'f', 'c'}, {'a', 'e'}}, {'e', {2, 4}, {'A', 'B'}, {'a', 'd'}, {'b', 'c'}}};
  Mesh mesh;
  mesh.vertices = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, -1}};  // 1, 2, 3 below which 4 lies
  for (const auto& face : {std::array<std::uint32_t, 3>{1, 2, 4}, {2, 3, 4}, {1, 4, 3}, {2, 1, 3}}) {
    std::array<std::uint32_t, 3> reversed{face[2], face[1], face[0]};
    mesh.add_face(reversed);
  }
  const auto leaf = make_leaf(shapes::reversed(mesh), {}, one_thread).leaf;
  ASSERT_NE(leaf, nullptr);
  const auto name_of_edge = [&](std::uint32_t p, std::uint32_t q) {
    for (const Row& row : rows) {
      if (std::minmax(row.ends[0], row.ends[1]) == std::minmax(p, q)) return row.edge;
    }
    return '?';
  };
  const auto corner = [&](std::uint32_t h, std::uint32_t step) { return leaf->tiles[h / 3][(h % 3 + step) % 3]; };
  int found = 0;
  for (std::uint32_t h = 0; h < 12; ++h) {
    for (const Row& row : rows) {
      if (corner(h, 0) != row.ends[0] || corner(h, 1) != row.ends[1]) continue;
      ++found;
      const std::uint32_t t = leaf->twins[h];
      EXPECT_EQ("ABCD"[leaf->tile_face[h / 3]], row.faces[0]) << row.edge;
      EXPECT_EQ("ABCD"[leaf->tile_face[t / 3]], row.faces[1]) << row.edge;
      EXPECT_EQ(name_of_edge(corner(h, 2), corner(h, 0)), row.left[0]) << row.edge;
      EXPECT_EQ(name_of_edge(corner(h, 1), corner(h, 2)), row.left[1]) << row.edge;
      EXPECT_EQ(name_of_edge(corner(t, 1), corner(t, 2)), row.right[0]) << row.edge;
      EXPECT_EQ(name_of_edge(corner(t, 2), corner(t, 0)), row.right[1]) << row.edge;
    }
  }
  EXPECT_EQ(found, 6);
}

// n x m quadrilaterals around a ring of n, each cut into triangles; at the seam the cross section is turned over or
// not. `is_closed`: the cross section is a circle, else a line.
Mesh band(std::uint32_t n, std::uint32_t m, bool is_closed, bool turned_over) {
  Mesh mesh;
  const std::uint32_t across = is_closed ? m : m + 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) mesh.vertices.push_back({double(i * i), double(j * j), double(i * j)});
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    j %= across;
    if (i < n) return i * across + j;
    return turned_over ? (across - 1 - j) : j;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.add_face(Tile{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.add_face(Tile{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

// Section 2.3.1: sphere and torus are orientable, Moebius strip and Klein bottle are not; and no repair makes them so.
TEST(KnownAnswersTopology, OrientableSurfaces) {
  std::mt19937 random(5);
  const auto with_random_turns = [&](const Mesh& source) {
    Mesh mesh;
    mesh.vertices = source.vertices;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      std::vector<std::uint32_t> face(source.face(f).begin(), source.face(f).end());
      if (random() % 2 == 0) std::reverse(face.begin(), face.end());
      mesh.add_face(face);
    }
    return mesh;
  };
  for (const Mesh& mesh : {shapes::geodesic_sphere(2), shapes::torus(7, 5, 2, 0.7)}) {
    const Mesh turned = with_random_turns(mesh);
    EXPECT_GT(make_leaf(turned, {}, one_thread).diagnosis.misoriented_edges.count, 0U);
    expect_same_set(solid(repair_mesh(turned, one_thread).mesh), solid(mesh));
  }
  EXPECT_TRUE(make_leaf(band(7, 5, true, false), {}, one_thread).diagnosis.is_closed()) << "the torus of the same grid";
  const Mesh klein = band(7, 5, true, true);
  const LeafResult bottle = make_leaf(klein, {}, one_thread);
  EXPECT_EQ(bottle.leaf, nullptr);
  EXPECT_EQ(bottle.diagnosis.open_edges.count, 0U);
  EXPECT_GT(bottle.diagnosis.misoriented_edges.count, 0U);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const Mesh repaired = repair_mesh(with_random_turns(klein), one_thread).mesh;
    EXPECT_EQ(make_leaf(repaired, {}, one_thread).leaf, nullptr);
  }
  const LeafResult strip = make_leaf(band(7, 3, false, true), {}, one_thread);
  EXPECT_EQ(strip.leaf, nullptr);
  EXPECT_GT(strip.diagnosis.misoriented_edges.count, 0U);
  EXPECT_EQ(strip.diagnosis.open_edges.count, 14U) << "its one border";
}

// Sections 2.3.1 and 2.4.3: two cubes with one edge in common, and two L-shaped pieces. Four faces meet in the edge, in
// two pairs that enclose material, so the solid falls into its pieces; the complement pairs the same faces differently.
TEST(KnownAnswersTopology, FourFacesAtAnEdge) {
  const auto piece = [](double sign) {  // an L whose inner corner faces away from the edge x = y = 0
    const auto part = [&](double x0, double y0, double x1, double y1) {
      return box({std::min(sign * x0, sign * x1), std::min(sign * y0, sign * y1), 0},
                 {std::max(sign * x0, sign * x1), std::max(sign * y0, sign * y1), 1});
    };
    return part(0, 0, 3, 1) | part(0, 0, 1, 3);
  };
  for (const auto& [a, b] : {std::array{box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}, {piece(1), piece(-1)}}) {
    const Solid both = a | b;
    const TopologyCounts counts = count_topology(both.boundary());
    EXPECT_TRUE(counts.is_closed());
    EXPECT_EQ(counts.nonmanifold_edges, 1U);
    EXPECT_EQ(both.boundary().shells.size(), 2U);
    EXPECT_EQ(both.boundary().component_count, 2U);
    const Solid outside = ~both;
    EXPECT_EQ(outside.boundary().shells.size(), 1U);
    EXPECT_EQ(outside.boundary().component_count, 1U);
    EXPECT_EQ(count_topology(outside.boundary()).nonmanifold_edges, 1U);
    for (const Solid& s : {both, outside}) expect_valid(s);
  }
}

// Section 2.3.1: closed surfaces in one vertex pass the test of edges; the vertex has two links. Also where the link of
// the vertex is two circles one within the other: a cone with a conical hole.
TEST(KnownAnswersTopology, AVertexWithSeveralLinks) {
  Mesh mesh = shapes::scaled(shapes::pyramid(4, 1, 1), {4, 4, 4});
  const Solid cone = solid(mesh);
  for (Point3& p : mesh.vertices) p.z = 8 - p.z;
  const Solid two = cone | solid(shapes::reversed(mesh));
  EXPECT_EQ(count_topology(two.boundary()).nonmanifold_edges, 0U);
  EXPECT_EQ(count_topology(two.boundary()).nonmanifold_vertices, 1U);
  EXPECT_EQ(two.boundary().component_count, 2U);
  expect_valid(two);
  const Solid pierced = cone - solid(shapes::scaled(shapes::pyramid(4, 1, 1), {1, 1, 4}));
  const TopologyCounts counts = count_topology(pierced.boundary());
  EXPECT_EQ(counts.nonmanifold_edges, 0U);
  EXPECT_EQ(counts.nonmanifold_vertices, 1U);
  EXPECT_FALSE(counts.is_manifold());
  EXPECT_EQ(place_of(pierced, {0, 0, 4}), Place::on_vertex);
  EXPECT_EQ(place_of(pierced, {0, 0, 3}), Place::out);
  expect_valid(pierced);
}

// Section 2.4.2: of two nested shells, both must face each other's inside or neither: in/out is no solid.
TEST(KnownAnswersTopology, NestedShellsMustAgree) {
  const Mesh outer = shapes::box({0, 0, 0}, {6, 6, 6});
  const Mesh inner = shapes::box({1, 1, 1}, {2, 2, 2});
  const auto of_two = [](const Mesh& first, const Mesh& second) {
    Brep b = boundary_of_faces(shapes::joined({first, second}));
    b.shells.push_back({true});
    for (std::size_t f = first.face_count(); f < b.face_shells.size(); ++f) b.face_shells[f] = 1;
    return b;
  };
  expect_valid(of_two(outer, shapes::reversed(inner)));
  EXPECT_FALSE(check_boundary(of_two(outer, inner), 5, one_thread).empty());
  EXPECT_FALSE(check_boundary(of_two(shapes::reversed(outer), inner), 5, one_thread).empty());
  // Every pair, also of shells in different trees: a void of one box inside another box, far from its own.
  Brep misplaced = of_two(shapes::joined({outer, shapes::translated(outer, {10, 0, 0})}), shapes::reversed(inner));
  misplaced.shells.push_back({false});
  for (std::size_t f = 6; f < 12; ++f) misplaced.face_shells[f] = 2;
  misplaced.component_count = 2;
  expect_valid(misplaced);
  Brep beside = of_two(outer, shapes::translated(shapes::reversed(inner), {7, 0, 0}));
  EXPECT_FALSE(check_boundary(beside, 5, one_thread).empty()) << "a void in nothing";
}

// Sections 2.4.2 and 3.2.4: a cube with two voids is one piece of three shells.
TEST(KnownAnswersTopology, ACubeWithTwoVoids) {
  const Solid s = (box({0, 0, 0}, {9, 9, 9}) - box({1, 1, 1}, {3, 3, 3})) - box({5, 5, 5}, {8, 8, 8});
  EXPECT_EQ(s.boundary().shells.size(), 3U);
  EXPECT_EQ(std::ranges::count(s.boundary().shells, true, &Shell::is_void), 2);
  EXPECT_EQ(components_of_shells(s.boundary(), one_thread), (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(counts_of(s).genus, 0);
  expect_valid(s);
  const Solid outside = ~s;  // three pieces: two cubes and what is around
  EXPECT_EQ(outside.boundary().component_count, 3U);
  EXPECT_EQ(std::ranges::count(outside.boundary().shells, true, &Shell::is_void), 1);
  expect_valid(outside);
}

// Section 2.1.2: a face of a pin extruded too far goes through the roof above it: the check refuses the boundary, and
// the mesh is said to cross itself.
TEST(KnownAnswersTopology, AFaceExtrudedThroughTheRoof) {
  const Solid tunnel = box({0, 0, 0}, {6, 6, 6}) - box({1, 0, 1}, {5, 6, 4});
  const Triangulated t = triangulate_boundary((tunnel | box({2, 2, 1}, {3, 3, 2})).boundary(), {}, one_thread);
  for (const double height : {3.5, 4.0, 4.5, 6.0, 7.5}) {
    Mesh mesh;
    for (Point3 p : t.vertices) {
      if (p.z == 2) p.z = height;
      mesh.vertices.push_back(p);
    }
    for (const Tile& tile : t.triangles) mesh.add_face(tile);
    const LeafResult result = make_leaf(mesh, {}, one_thread);
    ASSERT_NE(result.leaf, nullptr);
    EXPECT_EQ(result.leaf->crosses_itself, height >= 4) << height;
    EXPECT_EQ(result.diagnosis.crossing_faces.count > 0, height >= 4) << height;
    EXPECT_EQ(check_boundary(boundary_of_faces(mesh), 5, one_thread).empty(), height < 4) << height;
    expect_valid(Solid::from_leaf(result.leaf, one_thread));
  }
}

// Section 2.3.1: intermediate results that are no manifolds are legal; here the final one is a manifold again.
TEST(KnownAnswersTopology, NonmanifoldOnTheWay) {
  const Solid touching = box({0, 0, 0}, {1, 1, 1}) | box({1, 1, 0}, {2, 2, 1});
  EXPECT_FALSE(count_topology(touching.boundary()).is_manifold());
  const Solid mended = touching | box({0.5, 0.5, 0}, {1.5, 1.5, 1});
  EXPECT_TRUE(count_topology(mended.boundary()).is_manifold());
  EXPECT_EQ(counts_of(mended), (Counts{24, 36, 14, 14, 1, 0}));
  expect_valid(mended);
}

}  // namespace
}  // namespace quoin::testing
