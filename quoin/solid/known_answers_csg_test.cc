// SPDX-License-Identifier: Apache-2.0
//
// Known answers about expressions of solids: C. M. Hoffmann, Geometric and Solid Modeling, 1989, section 2.2. Where the
// text has a cylinder, a prism takes its place.
#include <gtest/gtest.h>

#include <algorithm>

#include "quoin/io/exact_text.h"
#include "quoin/solid/query/interference.h"
#include "quoin/solid/query/line_classification.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

const Rational half = Rational(1) / Rational(2);

struct Bracket {
  Solid upright = box({0, 0, 0}, {1, 4, 8});
  Solid plate = box({1, 0, 0}, {9, 4, 1});
  Solid drill = solid(shapes::translated(shapes::prism(48, 1, 1), {5, 2, 0}));
  Solid all = (upright | plate) - drill;
};

// Section 2.2.4, example of a point query: out of one block, in the other, out of the drill.
TEST(KnownAnswersCsg, APointInThePlateOfTheBracket) {
  const Bracket bracket;
  const RationalPoint3 p{2, 1, Rational(3) / Rational(10)};
  EXPECT_EQ(place_of(bracket.upright, p), Place::out);
  EXPECT_EQ(place_of(bracket.plate, p), Place::in);
  EXPECT_EQ(place_of(bracket.drill, p), Place::out);
  EXPECT_EQ(place_of(bracket.all, p), Place::in);
}

// Section 2.2.4, neighbourhoods: on both blocks, whose two half-balls fuse, so the answer is in and not on.
TEST(KnownAnswersCsg, APointOnBothBlocksIsInTheBracket) {
  const Bracket bracket;
  const RationalPoint3 p{1, 1, half};
  EXPECT_EQ(place_of(bracket.upright, p), Place::on_face);
  EXPECT_EQ(place_of(bracket.plate, p), Place::on_face);
  EXPECT_EQ(place_of(bracket.drill, p), Place::out);
  EXPECT_EQ(place_of(bracket.all, p), Place::in);
}

// Section 2.2.4: merged neighbourhoods of every dimension. Four wedges about a line fill it up, three leave an edge,
// two opposite ones an edge of four faces, eight octants a full ball.
TEST(KnownAnswersCsg, NeighbourhoodsThatFillUp) {
  const auto octant = [](int x, int y, int z) {
    const Point3 low{x - 1.0, y - 1.0, z - 1.0};
    return box(low, {low.x + 1, low.y + 1, low.z + 1});
  };
  const RationalPoint3 on_line{0, 0, half};
  const RationalPoint3 origin{0, 0, 0};
  Solid upper = octant(0, 0, 1) | octant(1, 1, 1);
  EXPECT_EQ(place_of(upper, on_line), Place::on_edge);
  EXPECT_EQ(count_topology(upper.boundary()).nonmanifold_edges, 1U);
  upper = upper | octant(1, 0, 1);
  EXPECT_EQ(place_of(upper, on_line), Place::on_edge);
  EXPECT_EQ(count_topology(upper.boundary()).nonmanifold_edges, 0U);
  upper = upper | octant(0, 1, 1);
  EXPECT_EQ(place_of(upper, on_line), Place::in);
  EXPECT_EQ(place_of(upper, origin), Place::on_face);
  const Solid opposite = octant(0, 0, 0) | octant(1, 1, 1);  // two cones at one vertex
  EXPECT_EQ(place_of(opposite, origin), Place::on_vertex);
  EXPECT_EQ(place_of(upper | octant(0, 0, 0), origin), Place::on_vertex);
  Solid all = upper;
  for (const auto& [x, y] : {std::array{0, 0}, {0, 1}, {1, 0}, {1, 1}}) all = all | octant(x, y, 0);
  EXPECT_EQ(place_of(all, origin), Place::in);
  EXPECT_EQ(counts_of(all), (Counts{8, 12, 6, 6, 1, 0}));
}

// Section 2.2.5: the line (2 - 2 l, 0, l) is in the primitive for 1/2 < l < 3/2; what it has in common with the planes
// of the caps lies beside the caps and is no event.
TEST(KnownAnswersCsg, ALineThroughAPrimitive) {
  const Solid prism = box({-1, -1, 0}, {1, 1, 2});
  const SolidLocator locator(prism.boundary(), one_thread);
  const LineClassification line = classify_line(locator, {{2, 0, 0}, {-2, 0, 1}}, one_thread);
  ASSERT_EQ(line.events.size(), 2U);
  EXPECT_EQ(line.events[0].parameter, half);
  EXPECT_EQ(line.events[0].point, (RationalPoint3{1, 0, half}));
  EXPECT_EQ(line.events[1].parameter, Rational(3) / Rational(2));
  EXPECT_EQ(line.events[1].point, (RationalPoint3{-1, 0, Rational(3) / Rational(2)}));
  EXPECT_EQ(line.pieces[0].place, Place::out);
  EXPECT_EQ(line.pieces[1].place, Place::in);
  EXPECT_EQ(line.pieces[2].place, Place::out);
}

// Section 2.2.7: of A in B, A is redundant in the union; of D in C, C is redundant in the intersection.
TEST(KnownAnswersCsg, RedundantOperandsChangeNothing) {
  const Solid outer = solid(shapes::geodesic_sphere(2, 4));
  for (const Solid& inner : {box({-1, -1, -1}, {1, 1, 1}), solid(shapes::torus(7, 5, 2, 0.5)), outer}) {
    expect_same_set(inner | outer, outer);
    expect_same_set(outer & inner, inner);
    EXPECT_EQ(counts_of(inner | outer), counts_of(outer));
    EXPECT_EQ(counts_of(outer & inner), counts_of(inner));
  }
}

// Section 2.2.7 (figure 2.27): D lies outside a box about A and B, so (A + B) - (C + D) does not know of it.
TEST(KnownAnswersCsg, AnOperandOutsideTheBoundsLeavesNoTrace) {
  const Solid a = box({0, 0, 0}, {4, 2, 1});
  const Solid b = box({2, 1, 0}, {6, 4, 1});
  const Solid c = box({3, 0, 0}, {5, 3, 1});
  Mesh far = shapes::box({7, 5, 0}, {9, 6, 1});
  far.name = "far";
  const Solid d = solid(far);
  const auto knows_of_d = [](const Brep& boundary) {
    return std::ranges::any_of(boundary.origins, [&](const Origin& o) { return boundary.leaf_names[o.leaf] == "far"; });
  };
  const Solid pruned = (a | b) - c;
  const Solid result = (a | b) - (c | d);
  expect_same_set(result, pruned);
  EXPECT_EQ(counts_of(result), counts_of(pruned));
  EXPECT_TRUE(knows_of_d((a | d).boundary()));
  EXPECT_FALSE(knows_of_d(result.boundary()));
  // The box of a difference is that of its first operand, not that minus the box of the second.
  EXPECT_EQ(bounds(result.boundary())->lo, bounds((a | b).boundary())->lo);
  EXPECT_EQ(bounds(result.boundary())->hi, bounds((a | b).boundary())->hi);
}

// Section 2.2.2: contact without volume is nothing in common, and not an interference (2.2.7).
TEST(KnownAnswersCsg, ContactHasNoVolume) {
  const Solid a = box({0, 0, 0}, {2, 2, 2});
  const Solid contacts[] = {box({2, 0, 0}, {4, 2, 2}), box({2, 1, 1}, {4, 3, 3}), box({2, 2, 0}, {4, 4, 2}),
                            box({2, 2, 2}, {4, 4, 4}), solid(shapes::translated(shapes::octahedron(1), {3, 1, 1}))};
  for (const Solid& b : contacts) {
    EXPECT_TRUE((a & b).is_empty());
    EXPECT_EQ(interference(a, b, one_thread).kind, Interference::touching);
    expect_same_set(a - b, a);
    EXPECT_EQ(volume_of(a | b), volume_of(a) + volume_of(b));
    expect_valid(a | b);
  }
}

std::string text_of(const Solid& s) {
  std::ostringstream out;
  write_exact_text(out, s.boundary());
  return out.str();
}

// Pairs of solids: general position, shared planes, copies, nested, touching.
std::vector<std::array<Solid, 2>> pairs_of_solids() {
  const Solid cube = box({0, 0, 0}, {4, 4, 4});
  const Solid sphere = solid(shapes::geodesic_sphere(2, 2));
  const Solid torus = solid(shapes::torus(9, 7, 2, 0.7));
  return {{cube, box({1, 1, 3}, {2, 2, 6})},
          {cube, box({2, 0, 0}, {6, 4, 4})},
          {cube, box({4, 0, 0}, {6, 4, 4})},
          {cube, cube},
          {cube, box({1, 1, 1}, {2, 2, 2})},
          {cube, sphere},
          {sphere, torus},
          {torus, solid(shapes::torus(9, 7, 2, 0.7))},
          {torus, solid(shapes::translated(shapes::torus(9, 7, 2, 0.7), {0.25, 0, 0}))},
          {torus, solid(shapes::pointing_along(shapes::torus(9, 7, 2, 0.7), shapes::Axis::x))}};
}

// Sections 2.2.2 and 3.6: identities between sets, as sets and not by volume.
TEST(KnownAnswersCsg, IdentitiesHoldAsSets) {
  for (const auto& [a, b] : pairs_of_solids()) {
    SCOPED_TRACE(::testing::Message() << "volumes " << volume_of(a).to_double() << " " << volume_of(b).to_double());
    expect_same_set(a - b, a & ~b);
    expect_same_set(a | b, ~(~a & ~b));
    expect_same_set(a & b, ~(~a | ~b));
    expect_same_set(a ^ b, (a - b) | (b - a));
    expect_same_set((a - b) | (a & b), a);
    EXPECT_TRUE(((a - b) & b).is_empty());
    EXPECT_TRUE((a & ~a).is_empty());
    EXPECT_TRUE((a | ~a).boundary().is_unbounded);
    EXPECT_EQ((a | ~a).boundary().face_count(), 0U);
    EXPECT_EQ(volume_of(a) + volume_of(b), volume_of(a | b) + volume_of(a & b));
    EXPECT_EQ(text_of(~~(a | b)), text_of(a | b));
    for (const Solid& result : {a | b, a & b, a - b, a ^ b, a & ~b, ~(~a & ~b)}) expect_valid(result);
  }
}

// The symmetric difference tells sets apart that agree in volume.
TEST(KnownAnswersCsg, SetsOfOneVolumeAreNotTheSame) {
  EXPECT_FALSE((box({0, 0, 0}, {1, 1, 1}) ^ box({0x1p-1000, 0, 0}, {1, 1, 1})).is_empty());
  EXPECT_FALSE((box({0, 0, 0}, {1, 1, 1}) ^ box({1, 0, 0}, {2, 1, 1})).is_empty());
}

// A torus through its own copy, turned by a right angle about each axis, shifted, and itself: every result is checked.
TEST(KnownAnswersCsg, ATorusThroughItsOwnCopy) {
  const Mesh mesh = shapes::torus(16, 10, 2, 0.75);
  const Solid torus = solid(mesh);
  const Mesh copies[] = {mesh, shapes::translated(shapes::pointing_along(mesh, shapes::Axis::y), {2, 0, 0}),
                         shapes::pointing_along(mesh, shapes::Axis::x), shapes::translated(mesh, {2, 0, 0}),
                         shapes::translated(mesh, {0, 0, 0.5})};
  for (const Mesh& copy : copies) {
    const Solid other = solid(copy);
    for (const Solid& result : {torus | other, torus & other, torus - other, torus ^ other}) expect_valid(result);
    expect_same_set((torus | other) - (torus ^ other), torus & other);
  }
  const Solid linked = torus | solid(copies[1]);  // the tube of each passes through the hole of the other, no contact
  EXPECT_EQ(linked.boundary().component_count, 2U);
  EXPECT_EQ(counts_of(linked).genus, 2);
  EXPECT_TRUE((torus & solid(copies[1])).is_empty());
}

}  // namespace
}  // namespace quoin::testing
