// SPDX-License-Identifier: Apache-2.0
//
// Convex pieces of solids and their distances, against those of the solids.
#include "quoin/polytope/piecewise_proximity.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/test_polytopes.h"
#include "quoin/solid/moved_boundary.h"
#include "quoin/solid/query/distance.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Solid solid(const Mesh& mesh) {
  return Solid::from_leaf(make_leaf(mesh, {}, one_thread).leaf, one_thread);
}
Solid box(const Point3& low, const Point3& high) {
  return solid(shapes::box(low, high));
}
Solid joined(const Solid& a, const Solid& b) {
  return unite(std::array{a, b}, one_thread);
}
Solid moved(const Solid& s, const RationalPoint3& by) {
  return Solid::from_leaf(make_leaf(moved_boundary(s.boundary(), by), "moved", {}, one_thread).leaf, one_thread);
}
std::size_t pieces_of(const Solid& s) {
  const auto pieces = convex_pieces(s.boundary(), one_thread);
  return pieces ? pieces->size() : 0;
}

TEST(ConvexPieces, AreToldFromOthers) {
  const Solid unit = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(pieces_of(unit), 1U);
  EXPECT_EQ(pieces_of(joined(unit, box({3, 0, 0}, {4, 1, 1}))), 2U);
  EXPECT_EQ(pieces_of(joined(unit, box({1, 1, 1}, {2, 2, 2}))), 2U);                                        // a vertex
  EXPECT_EQ(pieces_of(joined(unit, solid(shapes::translated(shapes::octahedron(1), {0.5, 0.5, 2})))), 2U);  // in a face
  EXPECT_EQ(pieces_of(joined(unit, box({1, 1, 0}, {2, 2, 1}))), 0U);                                        // an edge
  EXPECT_EQ(pieces_of(joined(unit, box({0.5, 0.5, 0.5}, {2, 2, 2}))), 0U);
  const Solid inner = box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
  EXPECT_EQ(pieces_of(subtract(unit, {&inner, 1}, one_thread)), 0U);
  EXPECT_EQ(pieces_of(complement(unit, one_thread)), 0U);
  EXPECT_EQ(pieces_of(Solid()), 0U);
  EXPECT_EQ(pieces_of(moved(unit, {Rational(1) / Rational(3), 0, 0})), 0U);  // no doubles
  EXPECT_EQ(pieces_of(moved(unit, {Rational(0.5), 0, 0})), 1U);
}

Interference interference_of(Proximity relation) {
  return relation == Proximity::apart      ? Interference::apart
         : relation == Proximity::touching ? Interference::touching
                                           : Interference::overlapping;
}

TEST(PiecewiseProximity, AgreesWithSolids) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(12U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto some = [&](double away) {
      Solid s = box({away, 0, 0}, {away + 1 + below(random, 2), 1, 1 + 1.0 * below(random, 2)});
      const Mesh shape = below(random, 2) == 0 ? shapes::octahedron(1) : shapes::tetrahedron(2);
      return joined(s, solid(shapes::translated(shape, {away + 1, 4, 2.0 * below(random, 2)})));
    };
    const Solid a = some(0);
    const Solid b = some(4);
    const auto first = convex_pieces(a.boundary(), one_thread);
    const auto second = convex_pieces(b.boundary(), one_thread);
    ASSERT_TRUE(first && second);
    PiecewiseProximity proximity(*first, *second);
    Vector3 last{-9, 0, 0};
    for (int round = 0; round < 5; ++round) {
      const Vector3 t{0.5 * below(random, 16), 0.5 * (below(random, 9) - 4), 0.5 * (below(random, 5) - 2)};
      const PiecewiseDistance d = proximity.distance(t, one_thread);
      const SolidDistance expected = solid_distance(moved(a, exact_point({t.x, t.y, t.z})), b, one_thread);
      EXPECT_EQ(interference_of(d.distance.relation), expected.relation);
      EXPECT_EQ(d.distance.squared_distance, expected.squared_distance);
      ++seen.at(static_cast<std::size_t>(d.distance.relation));
      // A way that ends there has contact at its end if, and only if, there is contact there.
      bool has_contact = false;
      const auto passages = proximity.passages(last, t, one_thread);
      for (std::size_t i = 0; i < passages.size(); ++i) {
        has_contact = has_contact || passages[i].passage.leave == Rational(1);
        if (i > 0) {
          EXPECT_LE(passages[i - 1].passage.enter, passages[i].passage.enter);
        }
      }
      EXPECT_EQ(has_contact, expected.relation != Interference::apart);
      last = t;
      if (HasFailure()) return;
    }
  }
  EXPECT_GE(seen[0], test_cases(3));
  EXPECT_GE(seen[2], test_cases(3));
}

TEST(PiecewiseProximity, NamesThePieces) {
  const std::vector<Polytope> robot{Polytope::hull_of(icosahedron(), one_thread)};
  const auto obstacles =
      convex_pieces(joined(box({20, -9, -9}, {21, 9, 9}), box({-31, -9, -9}, {-30, 9, 9})).boundary(), one_thread);
  ASSERT_TRUE(obstacles);
  PiecewiseProximity proximity(robot, *obstacles);
  const PiecewiseDistance near = proximity.distance({4, 0, 0}, one_thread);
  const PiecewiseDistance far = proximity.distance({-20, 0, 0}, one_thread);
  EXPECT_EQ(near.distance.squared_distance, Rational(64));
  EXPECT_EQ(far.distance.squared_distance, Rational(4));
  EXPECT_NE(near.second, far.second);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(proximity.passages({4, 0, 0}, {no_number, 0, 0}, one_thread), InputError);
  EXPECT_THROW(proximity.passages({0, no_number, 0}, {4, 0, 0}, one_thread), InputError);
  const auto passages = proximity.passages({20, 0, 0}, {-30, 0, 0}, one_thread);
  ASSERT_EQ(passages.size(), 2U);
  EXPECT_EQ(passages[0].second, near.second);
  EXPECT_EQ(passages[1].second, far.second);
  EXPECT_EQ(passages[1].passage.enter, Rational(42) / Rational(50));
  EXPECT_THROW(PiecewiseProximity(robot, {}), InputError);
}

}  // namespace
}  // namespace quoin
