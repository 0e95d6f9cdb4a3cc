// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/decomposition.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/notches.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/test_solids.h"

namespace quoin {

namespace {

using namespace testing;
using Random = std::mt19937_64;

/// Convex pieces that do not overlap and make up the solid; no fewer than the bound.
ConvexDecomposition checked(const Solid& s) {
  EXPECT_EQ(has_notch(s.boundary(), one_thread), !find_notches(s.boundary(), one_thread).empty());
  ConvexDecomposition result = convex_decomposition(s, one_thread);
  Rational sum(0);
  for (const Solid& piece : result.pieces) {
    EXPECT_EQ(piece.boundary().component_count, 1U);
    EXPECT_EQ(piece.boundary().shells.size(), 1U);
    EXPECT_TRUE(find_notches(piece.boundary(), one_thread).empty());
    EXPECT_FALSE(has_notch(piece.boundary(), one_thread));
    sum += volume_of(piece);
  }
  EXPECT_EQ(sum, volume_of(s)) << "so they do not overlap, as their union is the solid";
  if (!result.pieces.empty()) expect_same_set(unite(result.pieces, one_thread), s);
  EXPECT_GE(result.pieces.size(), result.lower_bound);
  return result;
}

Solid l_shape() {
  return box({0, 0, 0}, {2, 1, 1}) | box({0, 0, 0}, {1, 2, 1});
}

Solid random_solid(Random& random) {
  std::vector<Solid> parts;
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<std::uint64_t>(end)); };
  for (int i = 2 + below(3); i > 0; --i) {
    Point3 low;
    Point3 high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = below(4);
      high[axis] = low[axis] + 1 + below(3);
    }
    Solid part = box(low, high);
    if (below(3) == 0) part = solid(shapes::translated(shapes::octahedron(1 + below(2)), {low.x, low.y, low.z}));
    parts.push_back(below(4) == 0 && !parts.empty() ? parts.back() - part : part);
  }
  return unite(parts, one_thread);
}

}  // namespace

TEST(ConvexDecomposition, OfConvexSolidsIsTheSolid) {
  for (const Solid& s : {box({0, 0, 0}, {1, 2, 3}), solid(shapes::icosahedron(1)), solid(shapes::prism(7, 1, 2))}) {
    const ConvexDecomposition d = checked(s);
    EXPECT_EQ(d.pieces.size(), 1U);
    EXPECT_EQ(d.cuts, 0U);
    EXPECT_EQ(d.lower_bound, 1U);
  }
}

TEST(ConvexDecomposition, FindsTheFewestPiecesOfSimpleShapes) {
  EXPECT_EQ(checked(l_shape()).pieces.size(), 2U);
  EXPECT_EQ(checked(l_shape()).lower_bound, 2U);
  const Solid cross = box({0, 1, 0}, {3, 2, 1}) | box({1, 0, 0}, {2, 3, 1});
  EXPECT_EQ(checked(cross).pieces.size(), 3U);
  const Solid frame = box({-3, -3, -1}, {3, 3, 1}) - box({-2, -2, -2}, {2, 2, 2});
  EXPECT_EQ(checked(frame).pieces.size(), 4U);
  EXPECT_EQ(checked(frame).notches, 4U);
  const Solid cavity = box({-3, -3, -3}, {3, 3, 3}) - box({-2, -2, -2}, {2, 2, 2});
  EXPECT_EQ(checked(cavity).pieces.size(), 6U);
  std::vector<Solid> comb{box({0, 0, 0}, {9, 1, 1})};
  for (int i = 0; i < 5; ++i) comb.push_back(box({2.0 * i, 0, 0}, {2.0 * i + 1, 3, 1}));
  EXPECT_EQ(checked(unite(comb, one_thread)).pieces.size(), 6U);
}

TEST(ConvexDecomposition, OfComponentsAndOfSolidsThatTouchThemselves) {
  const Solid apart = box({0, 0, 0}, {1, 1, 1}) | box({2, 0, 0}, {3, 1, 1});
  EXPECT_EQ(checked(apart).pieces.size(), 2U);
  EXPECT_EQ(checked(apart).lower_bound, 2U);
  const Solid at_edge = box({0, 0, 0}, {1, 1, 1}) | box({1, 1, 0}, {2, 2, 1});
  EXPECT_EQ(checked(at_edge).pieces.size(), 2U);
  // A ring that closes at an edge.
  const Solid ring =
      box({0, 0, 0}, {3, 1, 1}) | box({0, 0, 0}, {1, 3, 1}) | box({0, 2, 0}, {2, 3, 1}) | box({2, 0, 0}, {3, 2, 1});
  EXPECT_EQ(checked(ring).pieces.size(), 4U);
  EXPECT_TRUE(convex_decomposition(Solid(), one_thread).pieces.empty());
  EXPECT_THROW(convex_decomposition(~apart, one_thread), InputError);
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(convex_decomposition(ring, cancelled), Cancelled);
}

/// Where pieces touch along edges alone, no plane has to be shared: the bound holds there too.
TEST(ConvexDecomposition, BoundHoldsWhereASolidTouchesItself) {
  std::vector<Solid> steps;
  for (int i = 0; i < 5; ++i) steps.push_back(box({1.0 * i, 1.0 * i, 0}, {i + 1.0, i + 1.0, 1}));
  steps.push_back(box({0, 0, -1}, {5, 5, 0}));
  const ConvexDecomposition d = checked(unite(steps, one_thread));
  EXPECT_LE(d.lower_bound, d.pieces.size());
  EXPECT_LE(d.pieces.size(), 6U);
}

TEST(ConvexDecomposition, OfRandomSolidsIsExact) {
  for (std::uint64_t seed = 0; seed < test_rounds(25U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    checked(random_solid(random));
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(ConvexDecomposition, OfCurvedShapesStaysSmall) {
  const ConvexDecomposition torus = checked(solid(shapes::torus(6, 4, 3, 1)));
  EXPECT_LE(torus.pieces.size(), 30U);
  const Solid ball_hole = box({-2, -2, -2}, {2, 2, 2}) - solid(shapes::octahedron(1.5));
  EXPECT_LE(checked(ball_hole).pieces.size(), 14U);
}

/// Sums of pieces make up the sum.
TEST(ConvexDecomposition, AgreesWithSumsOfSolids) {
  const Solid a = l_shape();
  const Solid b = solid(shapes::tetrahedron(1)) | box({0, 0, 0}, {2, 0.5, 0.5});
  std::vector<Solid> sums;
  for (const Solid& p : checked(a).pieces) {
    for (const Solid& q : checked(b).pieces) sums.push_back(minkowski_sum(p, q, one_thread));
  }
  expect_same_set(unite(sums, one_thread), minkowski_sum(a, b, one_thread));
}

}  // namespace quoin
