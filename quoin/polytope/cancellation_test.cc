// SPDX-License-Identifier: Apache-2.0
//
// The steps of hulls, balls and sums that go over all their input each poll: none of them ends where the context was
// cancelled before, however little there is to do after it.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/as_doubles.h"
#include "quoin/polytope/ball_filter.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/hull_simplex.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/planar_hull.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

class Cancellation : public testing::Test {
 protected:
  Cancellation() { context.cancel(); }
  Context context{{.threads = 1}};
  std::vector<RationalPoint3> thirds() const {
    std::vector<RationalPoint3> points;
    for (const Point3& p : icosahedron()) points.push_back(exact_point(p) * (Rational(1) / Rational(3)));
    return points;
  }
};

TEST_F(Cancellation, OfWhatPreparesHulls) {
  const Points points = icosahedron();
  EXPECT_THROW(HullBuilder(points, context), Cancelled);
  EXPECT_NO_THROW(HullBuilder(points, one_thread));
  // All are equal: no step but the first.
  EXPECT_THROW(find_simplex(Points(1000, Point3{1, 2, 3}), context), Cancelled);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto turn = [](std::uint32_t, std::uint32_t, std::uint32_t) { return Sign::positive; };
  EXPECT_THROW(planar_hull_of_sorted(order, turn, context), Cancelled);
  EXPECT_THROW(convex_hull(std::vector<Point2>{{0, 0}}, context), Cancelled);
}

TEST_F(Cancellation, OfWhatPreparesRationals) {
  EXPECT_THROW(Constructions(thirds(), &context), Cancelled);
  EXPECT_THROW(as_doubles(thirds(), &context), Cancelled);
  const Constructions table(thirds());
  const std::vector<PointId> one{PointId(0)};
  EXPECT_THROW(convex_hull(table, one, context), Cancelled);
  EXPECT_THROW(convex_hull(std::vector<RationalPoint3>{{0, 0, 0}}, context), Cancelled);
}

TEST_F(Cancellation, OfWhatPreparesBalls) {
  EXPECT_THROW(BallFilter(icosahedron(), context), Cancelled);
}

/// Equal maps take no overlay.
TEST_F(Cancellation, OfSumsOfEqualMaps) {
  const Polytope p = Polytope::hull_of(icosahedron(), one_thread);
  EXPECT_THROW(minkowski_sum(p, p, context), Cancelled);
  const Polytope q = Polytope::hull_of(thirds(), one_thread);
  EXPECT_THROW(minkowski_sum(p, q, context), Cancelled);
  EXPECT_THROW(Polytope::hull_of(thirds(), context), Cancelled);
}

}  // namespace
}  // namespace quoin
