// SPDX-License-Identifier: Apache-2.0
//
// Vertices and edges of a boundary that touch one of its faces inside, from one side: loops of one and of two vertices.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/io/exact_text.h"
#include "quoin/solid/check.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"
#include "quoin/solid/test_solids.h"
#include "quoin/solid/topology_counts.h"

namespace quoin {
namespace {

using quoin::testing::one_thread;
using quoin::testing::solid;

Mesh tetrahedron(const std::array<Point3, 4>& corners) {
  Mesh mesh;
  mesh.vertices.assign(corners.begin(), corners.end());
  for (const Tile& t : {Tile{0, 1, 2}, Tile{0, 2, 3}, Tile{0, 3, 1}, Tile{1, 3, 2}}) mesh.add_face(t);
  return shapes::approximate_volume(mesh) < 0 ? shapes::reversed(mesh) : mesh;
}

Solid unite_two(const Solid& a, const Solid& b) {
  return unite(std::array{a, b}, one_thread);
}
Solid minus(const Solid& a, const Solid& b) {
  return subtract(a, {&b, 1}, one_thread);
}

std::size_t loops_of(const Brep& b, std::size_t vertices) {
  std::size_t count = 0;
  for (std::size_t l = 0; l < b.loop_count(); ++l) count += b.loop(l).size() == vertices ? 1 : 0;
  return count;
}

void expect_valid(const Brep& b) {
  for (const std::string& violation : check_boundary(b, 10, one_thread)) ADD_FAILURE() << violation;
}

// To a check that starts from nothing, the triangles meet in shared vertices and edges only.
void expect_no_contacts(const Triangulated& t) {
  Mesh mesh;
  mesh.vertices = t.vertices;
  for (const Tile& tile : t.triangles) mesh.add_face(tile);
  const LeafResult leaf = make_leaf(mesh, {}, one_thread);
  ASSERT_NE(leaf.leaf, nullptr);
  EXPECT_EQ(leaf.diagnosis.crossing_faces.count, 0U);
  EXPECT_EQ(leaf.diagnosis.degenerate_faces.count, 0U);
}

// A checked boundary with so many touching vertices and edges, that leaves without a round of snapping.
void expect_touching(const Solid& s, std::size_t vertices, std::size_t edges) {
  const Brep& b = s.boundary();
  expect_valid(b);
  EXPECT_EQ(loops_of(b, 1), vertices);
  EXPECT_EQ(loops_of(b, 2), edges);
  EXPECT_GE(count_topology(b).nonmanifold_vertices, vertices + edges);
  const Triangulated t = triangulate_boundary(b, {}, one_thread);
  EXPECT_NE(t.rounding, Rounding::failed);
  EXPECT_EQ(t.rounds, 0U);
  EXPECT_LT(t.max_displacement, 1e-14);
  expect_no_contacts(t);
}

// The top of the box as one face, and as two whose edge runs from (0, 0, 4) to (4, 4, 4).
const Mesh boxes[] = {shapes::box({0, 0, 0}, {4, 4, 4}), shapes::triangulated(shapes::box({0, 0, 0}, {4, 4, 4}))};

TEST(Touching, ApexOnAFace) {
  for (const Mesh& mesh : boxes) {
    const Solid box = solid(mesh);
    for (const Point3& apex : {Point3{1, 2, 4}, Point3{2, 2, 4}, Point3{3, 1, 4}}) {
      const auto pyramid = [&](double z) { return solid(tetrahedron({apex, {0.5, 0.5, z}, {3, 1, z}, {1, 3, z}})); };
      const Solid cavity = minus(box, pyramid(1));
      const Solid crown = unite_two(box, pyramid(6));
      expect_touching(cavity, 1, 0);
      expect_touching(crown, 1, 0);
      expect_touching(minus(box, pyramid(-1)), 1, 0);  // a pit from below: its other vertices are constructed
      expect_touching(unite_two(cavity, pyramid(6)), 1, 0);
      EXPECT_EQ(cavity.boundary().component_count, 1U);
      EXPECT_EQ(crown.boundary().component_count, 2U);
      expect_touching(complement(cavity, one_thread), 1, 0);
    }
  }
}

// Where the touching vertex is a vertex of a flat part of the mesh.
TEST(Touching, ApexOnAVertexThatIsGone) {
  const Solid cylinder = solid(shapes::cylinder(7, 3, 2));
  const Solid pyramid = solid(tetrahedron({Point3{0, 0, 2}, {1, 0, 4}, {-1, 1, 4}, {-1, -1, 4}}));
  expect_touching(unite_two(cylinder, pyramid), 1, 0);
  expect_touching(unite_two(solid(shapes::cylinder(6, 3, 2)), pyramid), 1, 0);
}

// Apexes in one face with holes, some of them islands in holes of clusters: the tops of boxes that share area.
TEST(Touching, ManyApexesOnManyFaces) {
  std::vector<Solid> solids;
  std::size_t expected = 0;
  for (int i = 0; i < 3; ++i) {
    solids.push_back(solid(shapes::box({4.0 * i, 0, 0}, {4.0 * i + 5, 6, 2})));
    for (const double y : {1, 3, 5}) {
      const double x = 4.0 * i + 1 + y / 2;
      solids.push_back(solid(tetrahedron({Point3{x, y, 2}, {x - 0.25, y, 3}, {x + 0.25, y, 3}, {x, y + 0.25, 3}})));
      ++expected;
    }
  }
  expect_touching(unite(solids, one_thread), expected, 0);
}

// In a courtyard whose walls cut through the face, or stand on it; another apex outside, and walls within walls.
TEST(Touching, ApexesWithinWalls) {
  for (const double foot : {3.5, 4.0}) {
    std::vector<Solid> solids{solid(shapes::box({-4, -4, 0}, {4, 4, 4}))};
    const auto add_walls = [&](double r) {
      const double s = r + 0.25;
      for (const auto& [lo, hi] : {std::pair{Point3{-s, -s, foot}, Point3{s, -r, 6}},
                                   {{-s, r, foot}, {s, s, 6}},
                                   {{-s, -s, foot}, {-r, s, 6}},
                                   {{r, -s, foot}, {s, s, 6}}}) {
        solids.push_back(solid(shapes::box(lo, hi)));
      }
    };
    add_walls(1);
    add_walls(2);
    for (const double x : {0.25, 1.5, 3.0}) {
      solids.push_back(solid(tetrahedron({Point3{x, 0, 4}, {x - 0.1, 0, 5}, {x + 0.1, 0, 5}, {x, 0.1, 5}})));
    }
    expect_touching(unite(solids, one_thread), 3, 0);
  }
}

TEST(Touching, EdgeOnAFace) {
  for (const Mesh& mesh : boxes) {
    const Solid box = solid(mesh);
    const auto wedge = [](double y, double z) {
      return solid(tetrahedron({Point3{1, 1, 4}, {3, y, 4}, {1, 2, z}, {2.5, 0.5, z}}));
    };
    expect_touching(minus(box, wedge(1.5, 1)), 0, 1);
    expect_touching(unite_two(box, wedge(1.5, 6)), 0, 1);
    expect_touching(minus(box, wedge(1.5, -1)), 0, 1);
    expect_touching(minus(box, wedge(-1.5, 1)), 0, 0);  // reaches the rim: a slit of a longer loop
  }
  // A bar that lies on the box with one edge.
  const Mesh bar = shapes::translated(shapes::pointing_along(shapes::prism(4, 1, 2), shapes::Axis::x), {1, 2, 5});
  expect_touching(unite_two(solid(boxes[0]), solid(bar)), 0, 1);
}

// A tetrahedron with one face in the plane of `base` + u, v, large; the plane is where its neighbourhood of `base`
// ends.
Solid half_space(const Point3& base, const Vector3& u, const Vector3& v, const Vector3& inward) {
  const auto at = [&](double a, double b, double c) {
    return Point3{base.x + a * u.x + b * v.x + c * inward.x, base.y + a * u.y + b * v.y + c * inward.y,
                  base.z + a * u.z + b * v.z + c * inward.z};
  };
  return solid(tetrahedron({at(-60, -60, 0), at(60, -60, 0), at(0, 90, 0), at(0, 0, 60)}));
}

// The planes 2x + y = 5, 2x + z = 5 and y + z = 2x + 2 meet the plane x + y + z = 6 in (4/3, 7/3, 7/3) alone; of their
// half spaces the lower ones meet below it and the upper ones above.
std::vector<Solid> corner_of_half_spaces(double side) {
  return {half_space({2, 1, 0}, {1, -2, 0}, {0, 0, 1}, {2 * side, side, 0}),
          half_space({2, 0, 1}, {1, 0, -2}, {0, 1, 0}, {2 * side, 0, side}),
          half_space({0, 1, 1}, {1, 2, 0}, {0, 1, -1}, {-2 * side, side, side})};
}

TEST(Touching, ConstructedVertexOnATiltedFace) {
  const Solid below = solid(tetrahedron({Point3{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}}));
  std::vector<Solid> lower = corner_of_half_spaces(-1);
  lower.push_back(solid(shapes::box({0.5, 0.5, 0.5}, {3, 3, 3})));
  std::vector<Solid> upper = corner_of_half_spaces(1);
  upper.push_back(solid(shapes::box({0.5, 1, 1}, {5, 5, 5})));
  const Solid cavity = minus(below, intersect(lower, one_thread));
  const Solid crown = unite_two(below, intersect(upper, one_thread));
  const RationalPoint3 apex{Rational(4) / Rational(3), Rational(7) / Rational(3), Rational(7) / Rational(3)};
  for (const Solid& s : {cavity, crown, minus(crown, intersect(lower, one_thread))}) {
    expect_touching(s, 1, 0);
    const Brep& b = s.boundary();
    for (std::size_t l = 0; l < b.loop_count(); ++l) {
      if (b.loop(l).size() == 1) {
        EXPECT_EQ(b.points.exact(b.loop(l)[0]), apex);
      }
    }
  }
}

// On a small grid vertices and edges touch faces often. Whatever leaves as exact or certified has no contacts; for some
// of these solids snapping does not end.
TEST(Touching, RandomSolidsOnSmallGrids) {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t failed = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(300U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> coordinate(0, 2 + static_cast<int>(seed % 3));
    Solid s = solid(boxes[seed % 2]);
    for (std::uint64_t i = 0; i < 1 + seed % 4;) {
      std::array<Point3, 4> corners;
      for (Point3& p : corners) {
        for (std::size_t k = 0; k < 3; ++k) p[k] = coordinate(random);
      }
      const Mesh mesh = tetrahedron(corners);
      if (shapes::approximate_volume(mesh) < 0.01) continue;
      s = random() % 3 == 0 ? unite_two(s, solid(mesh)) : minus(s, solid(mesh));
      ++i;
    }
    expect_valid(s.boundary());
    vertices += loops_of(s.boundary(), 1);
    edges += loops_of(s.boundary(), 2);
    const LeafResult leaf = make_leaf(s.boundary(), "again", {}, one_thread);
    if (leaf.leaf) {  // not of nothing
      EXPECT_EQ(leaf.diagnosis.crossing_faces.count, 0U);
      expect_valid(minus(Solid::from_leaf(leaf.leaf, one_thread), solid(shapes::box({1, 1, 1}, {5, 5, 4}))).boundary());
    }
    const Triangulated t = triangulate_boundary(s.boundary(), {}, one_thread);
    failed += t.rounding == Rounding::failed ? 1 : 0;
    if (t.rounding != Rounding::failed) expect_no_contacts(t);
  }
  EXPECT_GT(vertices, test_cases(10U));
  EXPECT_GT(edges, test_cases(10U));
  EXPECT_LT(failed, 6U);
  RecordProperty("vertices", static_cast<int>(vertices));
  RecordProperty("edges", static_cast<int>(edges));
}

Brep read_back(const Brep& b) {
  std::ostringstream out;
  write_exact_text(out, b);
  return read_exact_text(out.str(), "a.qsolid");
}

TEST(Touching, ExactTextKeepsIt) {
  const Solid box = solid(boxes[0]);
  const Solid s = minus(minus(box, solid(tetrahedron({Point3{1, 2, 4}, {0.5, 1, 1}, {1, 1, 1}, {1, 3, 1}}))),
                        solid(tetrahedron({Point3{2, 1, 4}, {3, 3, 4}, {2, 2, 1}, {3, 1, 1}})));
  expect_touching(s, 1, 1);
  const Brep read = read_back(s.boundary());
  expect_valid(read);
  EXPECT_EQ(loops_of(read, 1), 1U);
  EXPECT_EQ(loops_of(read, 2), 1U);
  const LeafResult leaf = make_leaf(read, "a", {}, one_thread);
  ASSERT_NE(leaf.leaf, nullptr);
  EXPECT_EQ(leaf.diagnosis.crossing_faces.count, 0U);
  const Solid again = Solid::from_leaf(leaf.leaf, one_thread);
  expect_touching(again, 1, 1);
  EXPECT_EQ(volume(again.boundary(), one_thread), volume(s.boundary(), one_thread));
}

TEST(Touching, ReadBackAndCoveredInPart) {
  const Solid s = unite_two(solid(boxes[0]), solid(tetrahedron({Point3{1, 2, 4}, {1, 1, 6}, {3, 1, 6}, {1, 3, 6}})));
  const LeafResult leaf = make_leaf(read_back(s.boundary()), "a", {}, one_thread);
  ASSERT_NE(leaf.leaf, nullptr);
  const Solid again = Solid::from_leaf(leaf.leaf, one_thread);
  expect_touching(unite_two(again, solid(shapes::box({0.5, 0.5, 2}, {5, 5, 4}))), 1, 0);
  expect_touching(unite_two(again, solid(shapes::box({1, 2, 2}, {5, 5, 4}))), 1, 0);
  expect_touching(unite_two(again, solid(shapes::box({2, 2.5, 2}, {5, 5, 4}))), 1, 0);
  expect_touching(minus(again, solid(shapes::box({1, 2, 2}, {5, 5, 4}))), 0, 0);  // on the rim of what is left
  // All tiles about what touches share area with others, none of which reaches it.
  std::vector<Solid> around{again};
  for (const auto& [lo, hi] : {std::pair{Point3{0.5, 0.5, 2}, Point3{5, 1.5, 4}},
                               {{0.5, 2.5, 2}, {5, 5, 4}},
                               {{0.25, 1, 2}, {0.75, 3, 4}},
                               {{1.5, 1, 2}, {3, 3, 4}}}) {
    around.push_back(solid(shapes::box(lo, hi)));
  }
  expect_touching(unite(around, one_thread), 1, 0);
}

// The check of a boundary asks for the loop, and for what touches there.
TEST(Touching, LoopsThatAreMissingOrWrong) {
  const Solid s = minus(solid(boxes[0]), solid(tetrahedron({Point3{1, 2, 4}, {0.5, 1, 1}, {1, 1, 1}, {1, 3, 1}})));
  const auto violations = [](const Brep& b) { return check_boundary(b, 10, one_thread).size(); };
  Brep missing = read_back(s.boundary());
  ASSERT_EQ(loops_of(missing, 1), 1U);
  std::uint32_t l = 0;
  while (missing.loop(l).size() != 1) ++l;
  missing.loop_vertices.erase(missing.loop_vertices.begin() + missing.loop_begin[l]);
  missing.loop_begin.erase(missing.loop_begin.begin() + l);
  for (std::uint32_t i = l; i < missing.loop_begin.size(); ++i) missing.loop_begin[i] -= 1;
  for (std::uint32_t& first : missing.face_first_loop) first -= first > l ? 1 : 0;
  EXPECT_EQ(violations(missing), 1U);

  const Brep whole = read_back(s.boundary());
  std::size_t refused = 0;
  for (std::uint32_t p = 0; p < whole.points.point_count(); ++p) {
    Brep wrong = read_back(s.boundary());
    wrong.loop_vertices[wrong.loop_begin[l]] = PointId{p};
    refused += violations(wrong) > 0 ? 1 : 0;
  }
  EXPECT_EQ(refused, whole.points.point_count() - 1);
}

}  // namespace
}  // namespace quoin
