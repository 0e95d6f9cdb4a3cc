// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "quoin/base/error.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/test_solids.h"

namespace quoin {

using namespace testing;

namespace {

/// Squared distances of vertices and of facet planes from the origin.
void expect_between(const Solid& s, const Rational& inner, const Rational& outer) {
  const Brep& b = s.boundary();
  for (const PointId v : b.loop_vertices) {
    const RationalPoint3 p = b.points.exact(v);
    EXPECT_LE(dot(p, p), outer * outer);
  }
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    const RationalPoint3 n = area_vector(b, f);
    const Rational offset = dot(n, b.points.exact(b.face_planes[f][0]));
    EXPECT_GE(offset.sign(), Sign::positive);
    EXPECT_GE(offset * offset, inner * inner * dot(n, n));
  }
}

}  // namespace

TEST(Ball, IsBoundedFromBothSides) {
  for (const double radius : {1.0, 0.3, 0x1.5p100, 0x1p-200}) {
    for (const double part : {2.0, 0.5, 0.1, 0.003}) {
      const Rational r(radius);
      const Rational t(radius * part);
      const Rational inner = part > 1 ? Rational(0) : r - t;
      expect_between(ball_polytope(radius, radius * part, BallSide::within, one_thread), inner, r);
      expect_between(ball_polytope(radius, radius * part, BallSide::around, one_thread), r, r + t);
    }
  }
  EXPECT_LE(ball_polytope(1, 0.01, BallSide::around, one_thread).boundary().face_count(), 800U);
}

TEST(Ball, RefusesWhatIsNoBall) {
  for (const double bad : {0.0, -1.0, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(ball_polytope(bad, 0.1, BallSide::within, one_thread), InputError);
    EXPECT_THROW(ball_polytope(1, bad, BallSide::within, one_thread), InputError);
  }
  EXPECT_THROW(ball_polytope(1, 1e-9, BallSide::around, one_thread), InputError);
}

/// Steiner's formula: the volume of a box and what is within r of it.
TEST(Ball, OffsetsHaveTheVolumeBetweenThoseOfBothBounds) {
  const Solid brick = box({0, 0, 0}, {1, 2, 3});
  const double r = 0.5;
  const double pi = std::numbers::pi;
  const double exact = 6 + r * 22 + pi * r * r * 6 + 4.0 / 3 * pi * r * r * r;
  const auto volume_with = [&](BallSide side) {
    return volume_of(minkowski_sum(brick, ball_polytope(r, 0.01, side, one_thread), one_thread)).to_double();
  };
  EXPECT_LT(volume_with(BallSide::within), exact);
  EXPECT_GT(volume_with(BallSide::around), exact);
  EXPECT_LT(volume_with(BallSide::around) - volume_with(BallSide::within), 0.02 * 30);
}

}  // namespace quoin
