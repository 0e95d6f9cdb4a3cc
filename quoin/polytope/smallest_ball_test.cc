// SPDX-License-Identifier: Apache-2.0
//
// Every ball is checked from its definition: all points are in it, its support is on its sphere and has its center in
// the hull, which makes it the smallest. On small grids it is compared with the smallest of the balls of all subsets.
#include "quoin/polytope/smallest_ball.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/ball_filter.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

Rational squared_distance(const RationalPoint3& a, const RationalPoint3& b) {
  return dot(a - b, a - b);
}

Sign det(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) {
  return dot(cross(a, b), c).sign();
}

/// The center is strictly inside the simplex, whose vectors from the center are these: it is on the inner side of every
/// face, or on the line or plane that there is.
bool surround_origin(const std::vector<RationalPoint3>& v) {
  const auto is_zero = [](const RationalPoint3& p) { return dot(p, p).sign() == Sign::zero; };
  switch (v.size()) {
    case 1:
      return is_zero(v[0]);
    case 2:
      return is_zero(cross(v[0], v[1])) && dot(v[0], v[1]).sign() == Sign::negative;
    case 3: {
      const RationalPoint3 n = cross(v[0], v[1]);
      return det(v[0], v[1], v[2]) == Sign::zero && dot(n, cross(v[1], v[2])).sign() == Sign::positive &&
             dot(n, cross(v[2], v[0])).sign() == Sign::positive;
    }
    case 4: {
      const Sign all = det(v[1] - v[0], v[2] - v[0], v[3] - v[0]);
      return all != Sign::zero && det(v[0], v[1], v[2]) == -all && det(v[0], v[1], v[3]) == all &&
             det(v[0], v[2], v[3]) == -all && det(v[1], v[2], v[3]) == all;
    }
    default:
      return false;
  }
}

using RationalPoints = std::vector<RationalPoint3>;

RationalPoints exact(const Points& points) {
  RationalPoints result;
  for (const Point3& p : points) result.push_back(exact_point(p));
  return result;
}

void check(const SmallestBall& ball, const RationalPoints& points) {
  std::vector<RationalPoint3> from_center;
  for (const std::uint32_t i : ball.support) {
    from_center.push_back(points[i] - ball.center);
    EXPECT_EQ(dot(from_center.back(), from_center.back()), ball.squared_radius);
  }
  EXPECT_TRUE(std::is_sorted(ball.support.begin(), ball.support.end()));
  EXPECT_TRUE(surround_origin(from_center)) << ball.support.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(squared_distance(points[i], ball.center), ball.squared_radius) << "point " << i;
  }
}

SmallestBall checked(const Points& points) {
  SmallestBall ball = smallest_ball(points, one_thread);
  check(ball, exact(points));
  return ball;
}

SmallestBall checked_exactly(const RationalPoints& points) {
  SmallestBall ball = smallest_ball(points, one_thread);
  check(ball, points);
  return ball;
}

/// The center of the smallest circle or sphere through all of two to four points, by Cramer's rule; none if they are
/// dependent.
std::optional<RationalPoint3> center_of(const std::vector<RationalPoint3>& p) {
  const RationalPoint3 u = p[1] - p[0];
  if (dot(u, u).sign() == Sign::zero) return std::nullopt;
  if (p.size() == 2) return (p[0] + p[1]) * (Rational(1) / Rational(2));
  const RationalPoint3 v = p[2] - p[0];
  const RationalPoint3 n = cross(u, v);
  const RationalPoint3 w = p.size() == 3 ? n : p[3] - p[0];
  const Rational determinant = dot(cross(u, v), w) * Rational(2);
  if (determinant.sign() == Sign::zero) return std::nullopt;
  const Rational last = p.size() == 3 ? Rational(0) : dot(w, w);
  const RationalPoint3 sum = cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * last;
  return p[0] + sum * (Rational(1) / determinant);
}

/// The least squared radius of the balls of all subsets of two to four that hold everything.
Rational by_subsets(const Points& points) {
  std::vector<RationalPoint3> exact;
  for (const Point3& p : points) exact.push_back(exact_point(p));
  std::optional<Rational> best;
  for (unsigned subset = 1; subset < (1U << points.size()); ++subset) {
    std::vector<RationalPoint3> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(exact[i]);
    }
    if (chosen.size() < 2 || chosen.size() > 4) continue;
    const std::optional<RationalPoint3> center = center_of(chosen);
    if (!center) continue;
    const Rational radius = squared_distance(*center, chosen[0]);
    const auto is_inside = [&](const RationalPoint3& p) { return squared_distance(p, *center) <= radius; };
    if ((!best || radius < *best) && std::all_of(exact.begin(), exact.end(), is_inside)) best = radius;
  }
  return best.value_or(Rational(0));
}

TEST(SmallestBall, KnownOnes) {
  EXPECT_EQ(checked({{3, 4, 5}}).squared_radius, Rational(0));
  EXPECT_EQ(checked({{3, 4, 5}, {3, 4, 5}, {3, 4, 5}}).support.size(), 1U);
  EXPECT_EQ(checked({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}).squared_radius, Rational(1));
  EXPECT_EQ(checked({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).squared_radius, Rational(2) / Rational(3));
  EXPECT_EQ(checked({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).squared_radius, Rational(3));
  EXPECT_EQ(checked(icosahedron()).squared_radius, Rational(89));
  // The circle of a triangle with a right or obtuse angle is that of its longest side.
  EXPECT_EQ(checked({{0, 0, 0}, {6, 0, 0}, {2, 1, 0}}).support, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(checked({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}).support.size(), 3U);
}

TEST(SmallestBall, IsTheLeastOfAllSubsets) {
  for (std::uint64_t seed = 0; seed < test_rounds(150U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points points = on_a_small_grid(random, 1, 8);
    ASSERT_EQ(checked(points).squared_radius, by_subsets(points));
    if (HasFailure()) return;
  }
}

/// Integer points of a sphere, each many times and in disorder, so that all are on the boundary.
/// The same ball, moved by a vector and scaled by a factor that are no doubles, of any size.
TEST(SmallestBall, OfRationalsIsThatOfDoublesMovedAndScaled) {
  for (std::uint64_t seed = 0; seed < test_rounds(60U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points points = on_a_small_grid(random, 1, 40);
    const SmallestBall expected = checked(points);
    const SmallestBall same = checked_exactly(exact(points));
    EXPECT_EQ(same.center, expected.center);
    EXPECT_EQ(same.support, expected.support);
    Rational factor = Rational(1) / Rational(3);
    for (int i = below(random, 9); i > 0; --i) factor *= seed % 2 == 0 ? Rational(0x1p500) : Rational(0x1p-500);
    const RationalPoint3 by = RationalPoint3{1, 2, -3} * (Rational(below(random, 3)) * factor / Rational(7));
    RationalPoints moved;
    for (const Point3& p : points) moved.push_back(exact_point(p) * factor + by);
    const SmallestBall ball = checked_exactly(moved);
    EXPECT_EQ(ball.center, expected.center * factor + by);
    EXPECT_EQ(ball.squared_radius, expected.squared_radius * factor * factor);
    if (HasFailure()) return;
  }
}

/// Points of the unit sphere whose coordinates are fractions, and some that are closer to it than doubles tell.
TEST(SmallestBall, OfRationalsOnASphereAndCloseToIt) {
  RationalPoints points;
  Random random(4);
  const Rational one(1);
  while (points.size() < 400) {
    // Stereographic.
    const Rational u = Rational(below(random, 4001) - 2000) / Rational(1 + below(random, 999));
    const Rational v = Rational(below(random, 4001) - 2000) / Rational(1 + below(random, 999));
    const Rational square = u * u + v * v;
    points.push_back(RationalPoint3{u + u, v + v, square - one} * (one / (square + one)));
  }
  const SmallestBall unit = checked_exactly(points);
  EXPECT_EQ(unit.squared_radius, one);
  EXPECT_EQ(unit.center, (RationalPoint3{0, 0, 0}));
  const Rational most = one + Rational(0x1p-200);
  for (int k = 0; k < 200; ++k) points[k] = points[k] * (one + Rational(0x1p-200 * k / 256));
  points.push_back({0, 0, most});
  points.push_back({0, 0, -most});
  std::shuffle(points.begin(), points.end(), random);
  const SmallestBall ball = checked_exactly(points);
  EXPECT_EQ(ball.squared_radius, most * most);
  EXPECT_LE(ball.steps, 25U);
}

TEST(SmallestBall, OfCosphericalPoints) {
  Points points;
  constexpr int squared = 3 * 3 * 7 * 7;
  for (int x = -21; x <= 21; ++x) {
    for (int y = -21; y <= 21; ++y) {
      for (int z = -21; z <= 21; ++z) {
        if (x * x + y * y + z * z == squared) points.push_back({x + 1e6, y - 1e6, double(z)});
      }
    }
  }
  Random random(1);
  std::shuffle(points.begin(), points.end(), random);
  ASSERT_GT(points.size(), 100U);
  const SmallestBall ball = checked(points);
  EXPECT_EQ(ball.squared_radius, Rational(squared));
  EXPECT_EQ(ball.center, (RationalPoint3{Rational(1000000), Rational(-1000000), Rational(0)}));
}

/// Rounded points of a sphere, and of one that is far away and small: doubles alone do not tell inside from outside.
TEST(SmallestBall, OfNearlyCosphericalPoints) {
  for (std::uint64_t seed = 0; seed < test_rounds(6U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double size = seed % 2 == 0 ? 1 : 1e-6;
    const double away = seed % 3 == 0 ? 0 : 1;
    Points points;
    for (int i = 0; i < 300; ++i) {
      const auto draw = [&] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; };
      const double x = draw();
      const double y = draw();
      const double z = draw();
      const double length = std::hypot(x, y, z) / size;
      points.push_back({away + x / length, away + y / length, z / length});
    }
    checked(points);
    if (HasFailure()) return;
  }
}

TEST(SmallestBall, OfCoordinatesOfAllSizes) {
  checked({{1e308, 0, 0}, {-1e308, 1e308, 0}, {0, 1e-308, 1e308}, {1, 1, 1}});
  checked({{0x1p-1074, 0, 0}, {0, 0x1p-1074, 0}, {0, 0, 0x1p-1074}, {0, 0, 0}});
  checked({{1e308, 0, 0}, {1e308, 0x1p-1074, 0}, {1e308, 0, 0x1p-1074}});
  checked({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0x1p-1074}, {0, -1, 0x1p-540}});
  checked({{-1, 0, 0}, {1, 0, 0}, {0x1p-60, 1 - 0x1p-53, 0x1p-300}, {0, 1, 0x1p-60}});
}

/// What the filter decides, rationals do too; and it leaves open only what is close to the sphere.
TEST(SmallestBall, FilterIsRight) {
  Points points;
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const double turn = i + 1;
    const double near = 1 + std::ldexp(static_cast<double>(below(random, 9) - 4), -52);
    points.push_back({near * std::cos(turn), near * std::sin(turn), 0});
  }
  points.push_back({1, 0, 0});
  points.push_back({-1, 0, 0});
  points.push_back({0, 1, 0});
  const SmallestBall unit{{}, Rational(1), {2000, 2001}, 0};
  const auto is_outside = [&](std::uint32_t i) {
    return squared_distance(exact_point(points[i]), unit.center) > unit.squared_radius;
  };
  const BallFilter::Outcome some = BallFilter(points, one_thread).find_outside(unit, one_thread);
  ASSERT_NE(some.outside, BallFilter::nobody);
  EXPECT_TRUE(is_outside(some.outside));
  std::erase_if(points,
                [&](const Point3& p) { return squared_distance(exact_point(p), unit.center) > unit.squared_radius; });
  const auto last = static_cast<std::uint32_t>(points.size() - 1);
  const SmallestBall again{{}, Rational(1), {last - 2, last - 1}, 0};
  const BallFilter::Outcome none = BallFilter(points, one_thread).find_outside(again, one_thread);
  EXPECT_EQ(none.outside, BallFilter::nobody);
  EXPECT_EQ(none.open, (std::vector<std::uint32_t>{last - 2, last - 1, last}));
}

TEST(SmallestBall, OfManyPointsTakesFewSteps) {
  Random random(11);
  const auto draw = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  for (const double height : {1.0, 0x1p-20, 0x1p20}) {
    SCOPED_TRACE(height);
    Points points;
    for (int i = 0; i < 50000; ++i) {
      const double x = draw();
      const double y = draw();
      points.push_back({x, y, draw() * height});
    }
    const SmallestBall ball = smallest_ball(points, one_thread);
    EXPECT_EQ(BallFilter(points, one_thread).find_outside(ball, one_thread).outside, BallFilter::nobody);
    EXPECT_GE(ball.support.size(), 2U);
    EXPECT_GE(ball.steps, ball.support.size() - 1);
    EXPECT_LE(ball.steps, 20U);
  }
}

/// Each point is outside of the ball of those before it by less than what doubles or pairs of them tell: rationals find
/// the last, which is furthest.
TEST(SmallestBall, FurthestOfPointsThatOnlyRationalsTellApart) {
  Points points{{-1, 0, 0}, {1, 0, 0}};
  const double d = 0x1p-530;
  for (int k = 1; k <= 300; ++k) points.push_back({k * d, 1, k * k * d * 0x1p-16});
  const SmallestBall ball = checked(points);
  EXPECT_LE(ball.steps, 8U);
  EXPECT_TRUE(std::ranges::count(ball.support, points.size() - 1) == 1);
  std::reverse(points.begin(), points.end());
  const SmallestBall same = checked(points);
  EXPECT_EQ(same.center, ball.center);
  EXPECT_LE(same.steps, 8U);
}

TEST(SmallestBall, RefusesNothingAndWhatIsNotFinite) {
  EXPECT_THROW(smallest_ball(Points{}, one_thread), InputError);
  EXPECT_THROW(smallest_ball(RationalPoints{}, one_thread), InputError);
  const Points points{{0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}};
  try {
    smallest_ball(points, one_thread);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("point 1"), std::string::npos);
  }
  Context context({.threads = 1});
  context.cancel();
  EXPECT_THROW(smallest_ball(icosahedron(), context), Cancelled);
  EXPECT_THROW(smallest_ball(exact(icosahedron()), context), Cancelled);
}

}  // namespace
}  // namespace quoin
