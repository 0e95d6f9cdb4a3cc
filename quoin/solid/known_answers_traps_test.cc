// SPDX-License-Identifier: Apache-2.0
//
// Traps on the way to answers that are known: C. M. Hoffmann, Geometric and Solid Modeling, 1989, chapters 2 to 4.
// Those of naive classification, touching operands, nested shells, Euler's formula, links, slits, coplanar faces,
// untouched faces, complements and thresholds are tested with the examples, in the other files of this name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "quoin/io/mesh_file.h"
#include "quoin/kernel/transformation.h"
#include "quoin/solid/query/line_classification.h"
#include "quoin/solid/query/shell_components.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

// Section 2.4.1: none of four coplanar points in convex position is in the hull of the others, and yet they span no
// tetrahedron; it takes a determinant that is not zero.
TEST(KnownAnswersTraps, FourCoplanarPointsSpanNoTetrahedron) {
  for (const double height : {0.0, 0x1p-1000}) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, height}, {0, 1, 0}};
    for (const Tile& t : {Tile{0, 1, 2}, Tile{0, 2, 3}, Tile{0, 3, 1}, Tile{1, 3, 2}}) mesh.add_face(t);
    const Solid s = solid(mesh);
    EXPECT_EQ(s.is_empty(), height == 0);
    EXPECT_EQ(volume_of(s), Rational(height) / Rational(6));
    expect_valid(s);
  }
}

// Section 3.5: whether boundaries contain one another is asked of each component, and the answer for one is not that of
// the others; nor does an operand of one shell make a result of one shell.
TEST(KnownAnswersTraps, EveryComponentIsAskedForItself) {
  const Solid three = box({0, 0, 0}, {9, 9, 9}) | box({20, 0, 0}, {29, 9, 9}) | box({40, 0, 0}, {41, 1, 1});
  const Solid small = box({3, 3, 3}, {5, 5, 5}) | box({39, -1, -1}, {42, 2, 2}) | box({60, 0, 0}, {61, 1, 1});
  const Solid common = three & small;
  EXPECT_EQ(volume_of(common), Rational(8 + 1));
  EXPECT_EQ(common.boundary().shells.size(), 2U);
  const Solid rest = three - small;
  EXPECT_EQ(volume_of(rest), Rational(2 * 729 - 8));
  EXPECT_EQ(rest.boundary().shells.size(), 3U);
  EXPECT_EQ(rest.boundary().component_count, 2U);
  EXPECT_EQ((three | small).boundary().component_count, 4U);
  for (const Solid& s : {common, rest, three | small, three ^ small}) expect_valid(s);
}

// Section 3.5: two operands of one shell whose results have several, side by side and in one another.
TEST(KnownAnswersTraps, ResultsOfSeveralShells) {
  const Solid bar = box({0, 0, 0}, {9, 1, 1});
  const Solid cut = bar - box({4, -1, -1}, {5, 2, 2});
  EXPECT_EQ(cut.boundary().component_count, 2U);
  // A spool about a core: the groove leaves a core in a ring, joined by nothing.
  const Solid pot = box({0, 0, 0}, {7, 7, 7}) - (box({1, 1, 0}, {6, 6, 7}) - box({2, 2, 0}, {5, 5, 7}));
  EXPECT_EQ(pot.boundary().component_count, 2U);
  EXPECT_EQ(counts_of(pot), (Counts{24, 36, 16, 18, 2, 1}));
  const Solid lidded = (pot | box({0, 0, 7}, {7, 7, 8})) | box({0, 0, -1}, {7, 7, 0});
  EXPECT_EQ(counts_of(lidded), (Counts{24, 36, 16, 18, 2, 1})) << "a void that is a ring";
  EXPECT_EQ(lidded.boundary().component_count, 1U);
  EXPECT_EQ(components_of_shells(lidded.boundary(), one_thread), (std::vector<std::uint32_t>{0, 0}));
  for (const Solid& s : {cut, pot, lidded}) expect_valid(s);
}

// Section 3.4.1: which operand comes first must not decide anything.
TEST(KnownAnswersTraps, OperandsInAnyOrder) {
  std::vector<Solid> solids{box({0, 0, 0}, {4, 4, 4}), solid(shapes::octahedron(4)),
                            solid(shapes::translated(shapes::tetrahedron(2), {2, 2, 2})), box({2, 0, 2}, {6, 4, 4})};
  const Solid all = unite(solids, one_thread);
  const Solid common = intersect(solids, one_thread);
  const Solid odd = symmetric_difference(solids, one_thread);
  std::vector<std::size_t> order{0, 1, 2, 3};
  do {
    const std::vector<Solid> turned{solids[order[0]], solids[order[1]], solids[order[2]], solids[order[3]]};
    EXPECT_EQ(counts_of(unite(turned, one_thread)), counts_of(all));
    EXPECT_EQ(counts_of(intersect(turned, one_thread)), counts_of(common));
    EXPECT_EQ(counts_of(symmetric_difference(turned, one_thread)), counts_of(odd));
    expect_same_set(unite(turned, one_thread), all);
    expect_same_set(symmetric_difference(turned, one_thread), odd);
  } while (std::next_permutation(order.begin(), order.end()));
}

// Section 4.4.4: three prisms at once run into theorems about concurrent lines; all at once and one after the other are
// the same.
TEST(KnownAnswersTraps, ThreePrismsWithConcurrentSides) {
  std::vector<Solid> triangles;
  for (int i = 0; i < 3; ++i) {  // a side of each passes through the origin, exactly
    Mesh mesh = shapes::prism(3, 1, 1);
    const std::array<Point2, 3> corners[] = {
        {Point2{-3, -1}, {6, 2}, {0, 5}}, {Point2{-2, 4}, {1, -2}, {4, 4}}, {Point2{-4, -4}, {2, 2}, {-5, 3}}};
    for (Point3& p : mesh.vertices) {
      const Point2& c = corners[i][p.y == 0 || std::abs(p.y) < 0.5 ? 0 : p.y > 0 ? 1 : 2];
      p = {c.x, c.y, p.z};
    }
    triangles.push_back(solid(shapes::approximate_volume(mesh) > 0 ? mesh : shapes::reversed(mesh)));
  }
  const auto& [a, b, c] = std::array{triangles[0], triangles[1], triangles[2]};
  expect_same_set(unite(triangles, one_thread), (a | b) | c);
  expect_same_set(unite(triangles, one_thread), (c | a) | b);
  expect_same_set(intersect(triangles, one_thread), (a & b) & c);
  expect_same_set(symmetric_difference(triangles, one_thread), (a ^ c) ^ b);
  for (const Solid& s : {unite(triangles, one_thread), intersect(triangles, one_thread), (a ^ b) ^ c}) expect_valid(s);
}

// Sections 3.3.3 and 3.3.4: lines through vertices, along edges and in faces. Each piece is where its middle is, and
// each event where its point is.
TEST(KnownAnswersTraps, LinesThroughVerticesOfASolidWithAHole) {
  const Solid s = (box({0, 0, 0}, {4, 4, 2}) - box({1, 1, 0}, {3, 3, 2})) | box({4, 4, 0}, {5, 5, 2});
  const SolidLocator locator(s.boundary(), one_thread);
  std::vector<RationalPoint3> points;
  for (std::size_t v = 0; v < s.boundary().points.point_count(); ++v)
    points.push_back(s.boundary().points.exact(PointId{v}));
  std::size_t boundary_pieces = 0;
  for (const RationalPoint3& p : points) {
    for (const RationalPoint3& q : points) {
      if (p == q) continue;
      const LineClassification line = classify_line(locator, {p, q - p}, one_thread);
      ASSERT_EQ(line.pieces.size(), line.events.size() + 1);
      EXPECT_EQ(line.pieces.front().place, Place::out);
      EXPECT_EQ(line.pieces.back().place, Place::out);
      for (std::size_t i = 0; i + 1 < line.events.size(); ++i) {
        const Rational middle = (line.events[i].parameter + line.events[i + 1].parameter) / Rational(2);
        EXPECT_EQ(line.pieces[i + 1].place, locator.locate(p + (q - p) * middle).place);
        EXPECT_EQ(line.events[i].location.place, locator.locate(line.events[i].point).place);
        boundary_pieces += is_on_boundary(line.pieces[i + 1].place) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(boundary_pieces, 100U);
}

// Section 4.3.3: a rotation about the origin carries a far solid away by any error of its angle; about its own centre,
// by translations before and after, that centre stays, exactly.
TEST(KnownAnswersTraps, RotationsAboutAFarCentre) {
  const RationalPoint3 centre{Rational(0x1p40), Rational(1) / Rational(3), -7};
  const Transformation there = Transformation::translation(centre.x, centre.y, centre.z);
  Transformation turned;
  for (int i = 0; i < 200; ++i) {
    turned = there * Transformation::rotation(static_cast<unsigned>(i % 3), Rational(1) / Rational(100 + i)) *
             there.inverse() * turned;
  }
  EXPECT_EQ(turned(centre), centre);
  EXPECT_EQ(turned.determinant(), Rational(1));
}

// Sections 4.2.2 and 4.4.5: being within a distance is no equivalence. Welding by a distance takes chains as a whole,
// so that the order of the vertices decides neither how many there are nor which belong together.
TEST(KnownAnswersTraps, WeldingDoesNotDependOnTheOrder) {
  std::vector<double> places{0, 0.8e-10, 1.6e-10, 2.4e-10, 1, 1 + 0.9e-10, 2};
  std::mt19937 random(81);
  ReadOptions options;
  options.weld_tolerance = 1e-10;
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::shuffle(places.begin(), places.end(), random);
    std::ostringstream obj;
    obj.precision(17);
    for (const double x : places) obj << "v " << x << " 0 0\n";
    obj << "f 1 2 3 4 5 6 7\n";
    const MeshFile file = read_mesh(obj.str(), "chain.obj", options, one_thread);
    EXPECT_EQ(file.mesh.vertices.size(), 3U);
    EXPECT_EQ(file.report.welded, 4U);
  }
}

}  // namespace
}  // namespace quoin::testing
