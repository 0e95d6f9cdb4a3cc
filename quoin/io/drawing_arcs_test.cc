// SPDX-License-Identifier: Apache-2.0
//
// Bulges against circles in multiple-precision floating point: an oracle that shares nothing with the code.
#include "quoin/io/drawing_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quoin/io/test_drawings.h"
#include "quoin/number/rational.h"

namespace quoin::io {
namespace {

using quoin::testing::Random;
using quoin::testing::random_bulge;
using quoin::testing::small_integer;
using quoin::testing::with_exponent;

using Real = long double;

struct Vector {
  Real x = 0;
  Real y = 0;
};

// The point that divides the arc's turn in the ratio t, by complex numbers: with w = (z - a) / (b - z) an arc is a ray.
Vector point_on_arc(const Point2& a, const Point2& b, Real bulge, Real t) {
  const Real half_turn = 2 * std::atan(bulge);
  const Real off = -(1 - t) * half_turn;
  const Real scale = bulge == 0 ? t : std::sin(t * half_turn) / std::sin(half_turn);
  const Real dx = static_cast<Real>(b.x) - a.x;
  const Real dy = static_cast<Real>(b.y) - a.y;
  return {a.x + scale * (std::cos(off) * dx - std::sin(off) * dy),
          a.y + scale * (std::sin(off) * dx + std::cos(off) * dy)};
}

// Largest distance from points of the first arc to a fine chain on the second.
Real one_sided(const Point2& a, const Point2& b, Real p, const Point2& c, const Point2& d, Real q) {
  Real worst = 0;
  for (int i = 0; i <= 60; ++i) {
    const Vector u = point_on_arc(a, b, p, i / 60.0L);
    Real best = HUGE_VALL;
    for (int k = 0; k <= 2000; ++k) {
      const Vector v = point_on_arc(c, d, q, k / 2000.0L);
      best = std::min(best, std::hypot(u.x - v.x, u.y - v.y));
    }
    worst = std::max(worst, best);
  }
  return worst;
}

TEST(DrawingArcs, DistanceOfBulgesIsThatOfTheTops) {
  const Point2 a{-1, 0};
  const Point2 b{1, 0};
  for (const auto& [p, q] : {std::pair{0.1, 0.2}, {0.5, 1.0}, {1.0, 3.0}, {-0.3, 0.4}, {2.0, 2.5}, {0.0, 1.5}}) {
    const double bound = distance_of_bulges(a, b, p, q);
    EXPECT_NEAR(bound, std::fabs(p - q), 1e-14);
    // The chain adds at most half of its longest chord.
    const Real chord = 13.0L / 2000;
    EXPECT_LE(one_sided(a, b, p, a, b, q), bound + chord) << p << " " << q;
    EXPECT_LE(one_sided(a, b, q, a, b, p), bound + chord) << p << " " << q;
  }
}

TEST(DrawingArcs, ThroughThreePointsOfThePythagoreanCircle) {
  // 3-4-5: every one of these arcs has a rational bulge, and those that are doubles come exactly.
  const auto bulge = [](Point2 a, Point2 m, Point2 b) { return bulge_through(a, m, b).value(); };
  EXPECT_EQ(bulge({5, 0}, {0, 5}, {-5, 0}).bulge, 1);
  EXPECT_EQ(bulge({5, 0}, {0, 5}, {-5, 0}).distance, 0);
  EXPECT_EQ(bulge({-5, 0}, {0, 5}, {5, 0}).bulge, -1);
  EXPECT_EQ(bulge({-5, 0}, {-4, 3}, {5, 0}).bulge, -1);
  EXPECT_EQ(bulge({4, -3}, {5, 0}, {4, 3}).bulge, 1 / 3.0);
  EXPECT_GT(bulge({4, -3}, {5, 0}, {4, 3}).distance, 0);
  EXPECT_EQ(bulge({3, -4}, {5, 0}, {3, 4}).bulge, 0.5);
  EXPECT_EQ(bulge({3, -4}, {5, 0}, {3, 4}).distance, 0);
  EXPECT_EQ(bulge({3, -4}, {-5, 0}, {3, 4}).bulge, -2);
  EXPECT_EQ(bulge({3, 4}, {0, -5}, {3, -4}).bulge, 2);
  EXPECT_EQ(bulge({0, 0}, {1, 1}, {3, 3}).bulge, 0);
  EXPECT_FALSE(bulge_through({0, 0}, {4, 4}, {3, 3}));
  EXPECT_FALSE(bulge_through({0, 0}, {0, 0}, {3, 3}));
  EXPECT_FALSE(bulge_through({0, 0}, {3, 3}, {3, 3}));
}

// The circle through a, b with the bulge misses m by no more than the bound, in rationals: with top t and centre on the
// bisector, |m - c|^2 - r^2 is a polynomial in the bulge.
TEST(DrawingArcs, ThroughThreePointsWithinTheBound) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const auto coordinate = [&] { return i % 3 == 0 ? small_integer(random, 5) : with_exponent(random, -30, 30); };
    const Point2 a{coordinate(), coordinate()};
    const Point2 b{coordinate(), coordinate()};
    Point2 m{coordinate(), coordinate()};
    if (i % 4 == 1) m = {(a.x + b.x) / 2, (a.y + b.y) / 2};  // all but on the line
    if (a == b) continue;
    SCOPED_TRACE(i);
    const auto found = bulge_through(a, m, b);
    if (!found || found->bulge == 0) continue;
    // Neighbours of the bulge are on either side, or it is exact.
    const auto side = [&](double bulge) {
      // (m - c)^2 - r^2 over the chord's frame: u along, v across (to the right), chord from -h to h:
      // u^2 + v^2 - h^2 - 2 v (b^2 - 1) h / 2b with h^2 = |d|^2 / 4; all scaled by |d|^2.
      const Rational dx = Rational(b.x) - Rational(a.x);
      const Rational dy = Rational(b.y) - Rational(a.y);
      const Rational half(Integer(1), Integer(2));
      const Rational px = Rational(m.x) - (Rational(a.x) + Rational(b.x)) * half;
      const Rational py = Rational(m.y) - (Rational(a.y) + Rational(b.y)) * half;
      const Rational square = dx * dx + dy * dy;
      const Rational v = px * dy - py * dx;  // times |d|
      const Rational q(bulge);
      return ((px * px + py * py - square * Rational(Integer(1), Integer(4))) * Rational(2) * q -
              v * (q * q - Rational(1)))
          .sign();
    };
    if (found->distance == 0) {
      EXPECT_EQ(side(found->bulge), Sign::zero);
    } else {
      const double below = std::nextafter(found->bulge, -HUGE_VAL);
      const double above = std::nextafter(found->bulge, HUGE_VAL);
      EXPECT_NE(side(found->bulge), Sign::zero);
      EXPECT_NE(side(below), side(above));
      const double h = std::hypot(b.x / 2 - a.x / 2, b.y / 2 - a.y / 2);
      EXPECT_LE(found->distance, h * (above - below) * 0.51);
    }
  }
}

TEST(DrawingArcs, OfRadius) {
  const auto half = bulge_of_radius({0, 0}, {2, 0}, 1, false, true);
  EXPECT_EQ(half->bulge, 1);
  EXPECT_EQ(half->radius_change, 0);
  const auto short_one = bulge_of_radius({0, 0}, {2, 0}, 0.5, true, false);
  EXPECT_EQ(short_one->bulge, -1);
  EXPECT_EQ(short_one->radius_change, 0.5);
  const auto exact = bulge_of_radius({3, -4}, {3, 4}, 5, false, true);
  EXPECT_EQ(exact->bulge, 0.5);
  EXPECT_EQ(exact->distance, 0);
  EXPECT_EQ(exact->radius_change, 0);
  EXPECT_EQ(bulge_of_radius({3, -4}, {3, 4}, 5, true, false)->bulge, -2);
  const auto quarter = bulge_of_radius({1, 0}, {0, 1}, 1, false, true);
  EXPECT_EQ(quarter->bulge, 0.41421356237309504880);
  EXPECT_GT(quarter->radius_change, 0);
  EXPECT_LT(quarter->radius_change, 1e-15);
  EXPECT_EQ(bulge_of_radius({0, 0}, {5e-324, 0}, 1e308, false, true)->bulge, 0);
  EXPECT_FALSE(bulge_of_radius({0, 0}, {5e-324, 0}, 1e308, true, true));
}

// r = h (1 + b^2) / 2b is monotone between 0 and 1, so radius_change bounds what long double sees.
TEST(DrawingArcs, RadiusOfBulgeComesBack) {
  Random random(6);
  std::size_t exact = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point2 a{with_exponent(random, -20, 20), with_exponent(random, -20, 20)};
    const Point2 b{with_exponent(random, -20, 20), with_exponent(random, -20, 20)};
    const double bulge = random_bulge(random);
    if (bulge == 0) continue;
    const auto radius = radius_of_bulge(a, b, bulge);
    ASSERT_TRUE(radius);
    const auto read = bulge_of_radius(a, b, radius->radius, std::fabs(bulge) > 1, bulge > 0);
    ASSERT_TRUE(read);
    EXPECT_EQ(distance_of_bulges(a, b, read->bulge, bulge), radius->distance);
    if (std::fabs(bulge) == 1) {
      EXPECT_EQ(read->bulge, bulge);
    }
    const Real h = std::hypot((static_cast<Real>(b.x) - a.x) / 2, (static_cast<Real>(b.y) - a.y) / 2);
    const Real q = std::fabs(static_cast<Real>(read->bulge));
    const Real moved = std::fabs(h * (1 / q + q) / 2 - radius->radius);
    EXPECT_LE(moved, read->radius_change + 1e-17L * radius->radius) << a.x << " " << a.y << " " << bulge;
    if (radius->distance == 0) ++exact;
  }
  EXPECT_GT(exact, 500U);
}

TEST(DrawingArcs, OfAnglesAtTheAxes) {
  const auto quarter = arc_of_angles({1, 2}, 3, 0, 90).value();
  EXPECT_EQ(quarter.start, (Point2{4, 2}));
  EXPECT_EQ(quarter.end, (Point2{1, 5}));
  EXPECT_EQ(quarter.bulge, 0.41421356237309504880);
  EXPECT_GT(quarter.distance, 0);
  EXPECT_LT(quarter.distance, 1e-15);
  const auto half = arc_of_angles({1, 2}, 3, 270, 90).value();
  EXPECT_EQ(half.start, (Point2{1, -1}));
  EXPECT_EQ(half.end, (Point2{1, 5}));
  EXPECT_EQ(half.bulge, 1);
  EXPECT_EQ(half.distance, 0);
  EXPECT_EQ(arc_of_angles({1, 2}, 3, -90, 450).value().bulge, 1);
  EXPECT_TRUE(arc_of_angles({1, 2}, 3, 10, 370).value().is_whole);
  EXPECT_EQ(arc_of_angles({1, 2}, 3, 10, 370).value().distance, 0);
  EXPECT_GT(arc_of_angles({0.1, 2}, 0.2, 270, 0).value().distance, 0);  // 0.1 + 0.2 is rounded
}

TEST(DrawingArcs, OfAnglesWithinTheBound) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const Point2 c{with_exponent(random, -5, 5), with_exponent(random, -5, 5)};
    const double r = std::fabs(with_exponent(random, -5, 5));
    const double start = std::uniform_real_distribution<double>(-400, 400)(random);
    const double end = i % 5 == 0 ? start + with_exponent(random, -40, 0) : with_exponent(random, -3, 9);
    SCOPED_TRACE(std::to_string(start) + " " + std::to_string(end));
    const auto arc = arc_of_angles(c, r, start, end).value();
    if (arc.is_whole || arc.start == arc.end) continue;
    const Real degree = std::numbers::pi_v<Real> / 180;
    Real sweep = std::fmod(static_cast<Real>(end) - start, 360.0L);
    if (sweep < 0) sweep += 360;
    const Real slack = 2e-17L * (std::fabs(c.x) + std::fabs(c.y) + r);
    for (int k = 0; k <= 16; ++k) {
      // The same part of both arcs: no further apart than the bound, which is made of such pairs and of the tops.
      const Real angle = (start + sweep * k / 16) * degree;
      const Vector p = point_on_arc(arc.start, arc.end, arc.bulge, k / 16.0L);
      const Real distance = std::hypot(p.x - (c.x + r * std::cos(angle)), p.y - (c.y + r * std::sin(angle)));
      ASSERT_LE(distance, 1.01L * arc.distance + slack * 64);
    }
    ASSERT_LE(arc.distance, 1e-14 * (std::fabs(c.x) + std::fabs(c.y) + r) * std::max(1.0, arc.bulge));
  }
}

TEST(DrawingArcs, AnglesOfAnySizeAreSafe) {
  constexpr double sizes[] = {0, 5e-324, 1e-300, 1e-30, 1e-17, 1, 359.99999999999994, 360, 1e17, 1e300, 1.7e308};
  for (const double r : {0.0, 1.0, 1e300, 5e-324}) {
    for (const double start : sizes) {
      for (const double end : sizes) {
        for (const double sign : {1.0, -1.0}) {
          const auto arc = arc_of_angles({0, 1}, r, start, sign * end);
          if (!arc) continue;
          EXPECT_TRUE(std::isfinite(arc->bulge)) << r << " " << start << " " << end;
          EXPECT_GE(arc->bulge, 0);
        }
      }
    }
  }
}

TEST(DrawingArcs, TopOfArcIsOnTheRight) {
  EXPECT_EQ(top_of_arc({1, 0}, {-1, 0}, 1)->point, (Point2{0, 1}));
  EXPECT_EQ(top_of_arc({1, 0}, {-1, 0}, -1)->point, (Point2{0, -1}));
  EXPECT_EQ(top_of_arc({0, 0}, {4, 0}, 0.5)->point, (Point2{2, -1}));
  EXPECT_FALSE(top_of_arc({0, 0}, {1e308, 0}, 100));
}

TEST(DrawingArcs, CircleOverDiameter) {
  EXPECT_EQ(circle_over_diameter({-1, 2}, {3, 2}), (DrawingCircle{{1, 2}, 2}));
  EXPECT_EQ(circle_over_diameter({0, 0}, {6, 8}), (DrawingCircle{{3, 4}, 5}));
  EXPECT_FALSE(circle_over_diameter({0, 0}, {1, 1}));
}

}  // namespace
}  // namespace quoin::io
