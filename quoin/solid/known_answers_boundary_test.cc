// SPDX-License-Identifier: Apache-2.0
//
// Known answers about faces, edges and the combination of boundaries: C. M. Hoffmann, Geometric and Solid Modeling,
// 1989, chapter 3.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "quoin/io/exact_text.h"
#include "quoin/solid/query/line_classification.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

std::uint32_t face_at(const Brep& b, std::size_t axis, double coordinate) {
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    const auto loop = b.loop(b.face_first_loop[f]);
    if (std::ranges::all_of(loop, [&](PointId p) { return b.points.rounded(p)[axis] == coordinate; })) return f;
  }
  ADD_FAILURE() << "no face at " << coordinate;
  return 0;
}

// A tetrahedron below, touched from above by a second one along the segment from its point 3 to its point 4.
struct Touched {
  const Point3 p1{0, 0, 0};
  const Point3 p2{8, 0, 0};
  const Point3 p3{6, 2, 0};  // between 2 and 5
  const Point3 p4{4, 2, 0};  // inside
  const Point3 p5{0, 8, 0};

  static Solid tetrahedron(const std::array<Point3, 4>& corners) {
    Mesh mesh;
    mesh.vertices.assign(corners.begin(), corners.end());
    for (const Tile& t : {Tile{0, 1, 2}, Tile{1, 0, 3}, Tile{2, 1, 3}, Tile{0, 2, 3}}) mesh.add_face(t);
    return solid(mesh);
  }
  const Solid below = tetrahedron({p1, p2, p5, {0, 0, -8}});
  const Solid both = below | tetrahedron({p3, p4, {4, 4, 3}, {4, 0, 3}});
};

// Section 3.2.1: (1, 2, 3, 4, 3, 5) is a legal cycle: 4 lies within the face and the edge 3-4 has area on both sides.
TEST(KnownAnswersBoundary, ACycleThatPassesAVertexTwice) {
  const Touched t;
  const Brep& b = t.both.boundary();
  expect_valid(b);
  EXPECT_EQ(volume_of(t.both), volume_of(t.below) + Rational(4));
  const std::uint32_t face = face_at(b, 2, 0);
  ASSERT_EQ(b.face_first_loop[face + 1] - b.face_first_loop[face], 1U);
  const auto loop = b.loop(b.face_first_loop[face]);
  std::vector<Point3> points;
  for (const PointId p : loop) points.push_back(b.points.rounded(p));
  std::rotate(points.begin(), std::ranges::find(points, t.p1), points.end());
  EXPECT_EQ(points, (std::vector<Point3>{t.p1, t.p2, t.p3, t.p4, t.p3, t.p5}));
}

// Section 3.2.1: at vertex 3 the area-enclosing pairs are {(3,5), (4,3)} and {(3,4), (2,3)}: the loop passes it from 4
// to 5 and from 2 to 4.
TEST(KnownAnswersBoundary, AreaPairsAtAVertexPassedTwice) {
  const Touched t;
  const Brep& b = t.both.boundary();
  const auto loop = b.loop(b.face_first_loop[face_at(b, 2, 0)]);
  std::vector<std::array<Point3, 2>> pairs;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (b.points.rounded(loop[i]) != t.p3) continue;
    pairs.push_back(
        {b.points.rounded(loop[(i + loop.size() - 1) % loop.size()]), b.points.rounded(loop[(i + 1) % loop.size()])});
  }
  if (pairs.size() == 2 && pairs[0][0] == t.p4) std::swap(pairs[0], pairs[1]);
  EXPECT_EQ(pairs, (std::vector<std::array<Point3, 2>>{{t.p2, t.p4}, {t.p4, t.p5}}));
}

// Section 3.2.1: holes that touch the outline, one another, and themselves in vertices are legal cycles, as in
// (10, 11, 12, 10, 13, 14).
TEST(KnownAnswersBoundary, CyclesThatTouchInVertices) {
  const Solid block = box({0, 0, 0}, {8, 8, 1});
  const Solid bow = box({2, 2, 0}, {4, 4, 1}) | box({4, 4, 0}, {6, 6, 1});  // drilled through one common edge
  const Solid drilled = block - bow;
  expect_valid(drilled);
  EXPECT_EQ(volume_of(drilled), Rational(56));
  EXPECT_EQ(count_topology(drilled.boundary()).nonmanifold_edges, 1U);
  const Solid kept = block & bow;  // the face is one set of two squares with one corner, or two faces
  expect_valid(kept);
  expect_same_set(kept, bow);
}

// Section 3.2.1, illegal: (1, 2, 3, 4, 3) with 4 outside of the triangle, an edge that has no area beside it.
TEST(KnownAnswersBoundary, DanglingEdgesOfACycleAreRefused) {
  Mesh mesh = shapes::tetrahedron(1);
  const Brep right = boundary_of_faces(mesh);
  expect_valid(right);
  const auto face = std::vector<std::uint32_t>(mesh.face(0).begin(), mesh.face(0).end());
  const Point3 a = mesh.vertices[face[0]];
  const Point3 b = mesh.vertices[face[1]];
  const Point3 c = mesh.vertices[face[2]];
  const auto with_cycles = [&](const Point3& extra, const std::vector<std::vector<std::uint32_t>>& cycles) {
    Mesh changed = mesh;
    changed.vertices.push_back(extra);
    Brep brep = boundary_of_faces(changed);
    Brep result;
    result.points = Constructions(changed.vertices);
    result.face_planes = brep.face_planes;
    result.face_first_origin = brep.face_first_origin;
    result.origins = brep.origins;
    result.face_shells = brep.face_shells;
    result.shells = brep.shells;
    result.component_count = 1;
    const auto add_loop = [&](const auto& corners) {
      for (const auto v : corners) result.loop_vertices.push_back(PointId{v});
      result.loop_begin.push_back(static_cast<std::uint32_t>(result.loop_vertices.size()));
    };
    for (const auto& cycle : cycles) add_loop(cycle);
    result.face_first_loop.push_back(static_cast<std::uint32_t>(cycles.size()));
    for (std::size_t f = 1; f < changed.face_count(); ++f) {
      add_loop(changed.face(f));
      result.face_first_loop.push_back(static_cast<std::uint32_t>(result.loop_begin.size() - 1));
    }
    return result;
  };
  const auto beyond = [](const Point3& p, const Point3& q, const Point3& r) {
    return Point3{2 * p.x - (q.x + r.x) / 2, 2 * p.y - (q.y + r.y) / 2, 2 * p.z - (q.z + r.z) / 2};
  };
  const Point3 outside = beyond(a, b, c);
  for (std::size_t k = 0; k < 3; ++k) {  // at every corner: at one of them the loose end is the outermost vertex
    const std::array<std::uint32_t, 3> v{face[k], face[(k + 1) % 3], face[(k + 2) % 3]};
    const Point3 loose = beyond(mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]);
    const Brep dangling = with_cycles(loose, {{v[1], v[2], v[0], 4, v[0]}});
    const std::string edge = "edge " + std::to_string(v[0]) + "-4 dangles from face 0";
    EXPECT_EQ(check_boundary(dangling, 5, one_thread), std::vector<std::string>{edge});
    EXPECT_EQ(make_leaf(dangling, "a", {}, one_thread).leaf, nullptr);
  }
  // (5): a vertex by itself outside of the area.
  EXPECT_FALSE(check_boundary(with_cycles(outside, {{face[0], face[1], face[2]}, {4}}), 5, one_thread).empty());
  // An edge by itself outside of the area, as the bridge of (6, 7, 8, 9, 10, 11, 9, 8).
  EXPECT_FALSE(
      check_boundary(with_cycles(outside, {{face[0], face[1], face[2]}, {4, face[0]}}), 5, one_thread).empty());
}

// Section 3.3.3 (as figure 3.5): of three points on a line the second is passed twice and the third by itself; it pairs
// with nothing, and is kept.
TEST(KnownAnswersBoundary, PointsThatALineMeetsByThemselvesAreKept) {
  // A saw over [0, 6]: teeth with points at x = 1, 3 and 5; the line y = 2 runs through the last two, in the first.
  Mesh mesh;
  const std::vector<Point2> outline{{0, 0}, {6, 0}, {5, 2}, {4, 1}, {3, 2}, {2, 1}, {0, 3}};
  const auto n = static_cast<std::uint32_t>(outline.size());
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
  for (const double z : {0.0, 1.0}) {
    for (const Point2& p : outline) mesh.vertices.push_back({p.x, p.y, z});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
    mesh.add_face(std::array{i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  const Solid saw = solid(mesh);
  const SolidLocator locator(saw.boundary(), one_thread);
  const LineClassification line = classify_line(locator, {{0, 2, Rational(1) / Rational(2)}, {1, 0, 0}}, one_thread);
  ASSERT_EQ(line.events.size(), 4U);
  const Place places[] = {Place::out, Place::in, Place::out, Place::out, Place::out};
  const int parameters[] = {0, 1, 3, 5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(line.events[i].parameter, Rational(parameters[i]));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(line.pieces[i].place, places[i]) << i;
  EXPECT_EQ(line.events[2].location.place, Place::on_edge);
}

// Section 3.3.4, table 3.1: boundaries that do not cross. Each of the two is kept or dropped.
TEST(KnownAnswersBoundary, ContainmentOfBoundariesThatDoNotCross) {
  const Solid outer = box({0, 0, 0}, {9, 9, 9});
  const Solid inner = box({3, 3, 3}, {5, 5, 5});
  const Solid apart = box({20, 0, 0}, {21, 1, 1});
  expect_same_set(outer & inner, inner);  // out and in: one is kept
  expect_same_set(inner & outer, inner);
  EXPECT_TRUE((inner & apart).is_empty());  // out and out: none
  const Solid neither = ~inner & ~apart;    // in and in: both
  EXPECT_EQ(neither.boundary().shells.size(), 2U);
  EXPECT_TRUE(neither.boundary().is_unbounded);
  EXPECT_EQ((outer & ~inner).boundary().shells.size(), 2U);
  for (const Solid& s : {outer & inner, neither, outer & ~inner, ~outer | inner}) expect_valid(s);
  // Boxes that overlap though the boundaries do not meet: containment still has to be found out.
  const Solid frame = box({0, 0, 0}, {9, 9, 1}) - box({2, 2, 0}, {7, 7, 1});
  const Solid plug = box({4, 4, -4}, {5, 5, 4});
  EXPECT_TRUE((frame & plug).is_empty());
  EXPECT_EQ((frame | plug).boundary().component_count, 2U);
}

// Section 3.4: of the six faces of the common part of two boxes, five lie on the box that sticks in and one on the
// other; the face between them that no face of the other solid cuts is found as well.
TEST(KnownAnswersBoundary, FacesOfTheCommonPartOfTwoBoxes) {
  const Solid common = box({0, 0, 0}, {4, 4, 4}) & box({1, 1, 3}, {2, 2, 6});
  EXPECT_EQ(counts_of(common), (Counts{8, 12, 6, 6, 1, 0}));
  EXPECT_EQ(volume_of(common), Rational(1));
  std::array<int, 2> faces{};
  for (const Origin& origin : common.boundary().origins) ++faces.at(origin.leaf);
  EXPECT_EQ(faces, (std::array<int, 2>{1, 5}));
}

// Section 3.4.4, face/face: coplanar faces with opposite normals contribute no area, with equal normals theirs once.
TEST(KnownAnswersBoundary, CoplanarFaces) {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  const Solid opposite = box({1, 1, 4}, {6, 6, 8});
  EXPECT_TRUE((a & opposite).is_empty());
  const Solid equal = box({1, 1, 2}, {6, 6, 4});
  const Solid common = a & equal;
  expect_same_set(common, box({1, 1, 2}, {4, 4, 4}));
  const std::uint32_t top = face_at(common.boundary(), 2, 4);
  EXPECT_EQ(area_vector(common.boundary(), top).z, Rational(9));
  EXPECT_EQ(common.boundary().face_first_origin[top + 1] - common.boundary().face_first_origin[top], 2U);
  const Solid joined = a | equal;
  EXPECT_EQ(area_vector(joined.boundary(), face_at(joined.boundary(), 2, 4)).z, Rational(16 + 25 - 9));
  for (const Solid& s : {common, joined, a | opposite, a - equal, equal - a}) expect_valid(s);
  // One plane and one normal, but areas apart or with a corner in common, of one piece or of two: never one face across
  // shells.
  const Solid beside = a | box({6, 0, 0}, {8, 4, 4});
  EXPECT_EQ(counts_of(beside), (Counts{16, 24, 12, 12, 2, 0}));
  const Solid bridged = beside | box({4, 0, 0}, {6, 4, 2});
  EXPECT_EQ(counts_of(bridged).shells, 1);
  expect_valid(bridged);
}

// The faces about an edge, by shell: what pairs of faces enclose material.
std::multiset<std::set<double>> pairs_by_shell(const Solid& s, const Point3& p, const Point3& q) {
  const Brep& b = s.boundary();
  std::vector<std::set<double>> of_shell(b.shells.size());
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    for (std::uint32_t l = b.face_first_loop[f]; l < b.face_first_loop[f + 1]; ++l) {
      const auto loop = b.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point3 from = b.points.rounded(loop[i]);
        const Point3 to = b.points.rounded(loop[(i + 1) % loop.size()]);
        if (!(from == p && to == q) && !(from == q && to == p)) continue;
        const RationalPoint3 n = area_vector(b, f);  // along x or y; which of the four half-planes it is
        const bool forward = from == p;
        const double direction = n.x.sign() == Sign::zero ? (forward == (n.y.sign() == Sign::positive) ? 180 : 0)
                                                          : (forward == (n.x.sign() == Sign::positive) ? 90 : 270);
        of_shell[b.face_shells[f]].insert(direction);
      }
    }
  }
  return {of_shell.begin(), of_shell.end()};
}

// Section 3.6: the complement turns the pairs ((a,b),(c,d)) about an edge into ((a,d),(c,b)). Two cubes fill opposite
// quadrants; a tunnel with walls in the other quadrants tells the pairs of the complement apart.
TEST(KnownAnswersBoundary, TheComplementPairsFacesTheOtherWay) {
  const Solid cubes = box({0, 0, 0}, {1, 1, 1}) | box({-1, -1, 0}, {0, 0, 1});
  using Pairs = std::multiset<std::set<double>>;
  EXPECT_EQ(pairs_by_shell(cubes, {0, 0, 0}, {0, 0, 1}), (Pairs{{0, 90}, {180, 270}}));
  EXPECT_EQ(pairs_by_shell(~cubes, {0, 0, 0}, {0, 0, 1}), (Pairs{{0, 90, 180, 270}}));
  const Solid block = box({-1, -1, 0}, {1, 1, 1});
  EXPECT_EQ(pairs_by_shell(block - cubes, {0, 0, 0}, {0, 0, 1}), (Pairs{{90, 180}, {0, 270}}));
  EXPECT_EQ(pairs_by_shell(~(block - cubes), {0, 0, 0}, {0, 0, 1}), (Pairs{{0, 90, 180, 270}}));
  EXPECT_EQ(pairs_by_shell(~~cubes, {0, 0, 0}, {0, 0, 1}), (Pairs{{0, 90}, {180, 270}}));
}

// Section 3.4.6: faces that touch nothing of the other solid come along: whole faces in the other solid, holes that no
// crossing reaches, faces whose vertices all lie on the other surface.
TEST(KnownAnswersBoundary, FacesThatNoCrossingReaches) {
  const Solid block = box({0, 0, 0}, {8, 8, 2}) - box({3, 3, 0}, {5, 5, 2});
  const Solid cut = block - box({7, 7, 0}, {9, 9, 2});  // the hole's loops are not touched
  EXPECT_EQ(counts_of(cut), (Counts{20, 30, 12, 14, 1, 1}));
  EXPECT_EQ(volume_of(cut), Rational(128 - 8 - 2));
  const Solid cube = box({0, 0, 0}, {2, 2, 2});
  const Solid inscribed = solid(shapes::translated(shapes::tetrahedron(1), {1, 1, 1}));  // faces inside, corners on it
  expect_same_set(cube & inscribed, inscribed);
  EXPECT_EQ(counts_of(cube & inscribed), (Counts{4, 6, 4, 4, 1, 0}));
  for (const Solid& s : {cut, cube - inscribed, block | inscribed}) expect_valid(s);
}

// Section 3.4.4, edge/edge and vertex/edge: whole edges in common, parts of edges, crossing edges.
TEST(KnownAnswersBoundary, EdgesOnEdges) {
  const Solid a = box({0, 0, 0}, {2, 2, 2});
  const Solid tent = solid(shapes::scaled(shapes::pyramid(4, 1, 1), {2, 2, 2}));
  const Solid others[] = {box({2, 2, 0}, {4, 4, 2}),   box({2, 2, 1}, {4, 4, 3}),    box({1, 1, 0}, {2, 2, 2}),
                          box({0, 0, 0}, {2, 1, 2}),   box({1, -1, 1}, {3, 1, 2}),   tent,
                          box({-1, -1, 2}, {3, 3, 4}), box({0.5, 0.5, 2}, {1, 3, 3})};
  for (const Solid& b : others) {
    for (const Solid& s : {a | b, a & b, a - b, b - a, a ^ b}) expect_valid(s);
    EXPECT_EQ(volume_of(a) + volume_of(b), volume_of(a | b) + volume_of(a & b));
    expect_same_set(a - b, a & ~b);
  }
}

// Section 3.7: pairs of boxes, also flat, touching and identical ones, against all pairs; each once.
TEST(KnownAnswersBoundary, PairsOfBoxesAgainstAllPairs) {
  std::mt19937 random(11);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::array<std::vector<FloatBox>, 2> sets;
    for (auto& boxes : sets) {
      for (int i = 0; i < 100; ++i) {
        FloatBox b;
        for (std::size_t k = 0; k < 3; ++k) {
          b.lo[k] = static_cast<float>(random() % 8);
          b.hi[k] = b.lo[k] + static_cast<float>(random() % 3);
        }
        boxes.push_back(b);
        if (i % 10 == 0) boxes.push_back(b);
      }
    }
    const auto pairs = BoxTree::pairs(BoxTree(sets[0], one_thread), BoxTree(sets[1], one_thread), one_thread);
    const std::set<TilePair> found(pairs.begin(), pairs.end());
    EXPECT_EQ(found.size(), pairs.size());
    for (std::uint32_t i = 0; i < sets[0].size(); ++i) {
      for (std::uint32_t j = 0; j < sets[1].size(); ++j) {
        const FloatBox& a = sets[0][i];
        const FloatBox& b = sets[1][j];
        bool meet = true;
        for (std::size_t k = 0; k < 3; ++k) meet = meet && a.lo[k] <= b.hi[k] && b.lo[k] <= a.hi[k];
        EXPECT_TRUE(!meet || found.contains({i, j}));
      }
    }
  }
}

}  // namespace
}  // namespace quoin::testing
