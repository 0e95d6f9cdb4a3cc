// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>

#include "quoin/arrangement/sets/planar_motion.h"
#include "quoin/arrangement/sets/planar_normals.h"
#include "quoin/arrangement/sets/test_sets.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using testing::both;
using testing::box;
using testing::random_rings;
using testing::random_squares;
using testing::Ring;
using testing::Rings;
using testing::set_of;
using testing::written;

bool is_within(const CircularPolygonSet& a, const CircularPolygonSet& b) {
  return both(a, b, SetOperation::subtract).is_empty();
}

/// The area of what lies under an edge, in doubles.
double area_under(const CircularArrangement& arrangement, dcel::EdgeId e) {
  const CircularFamily& family = arrangement.family();
  const Point2 a = family.position(arrangement.point(arrangement.left(e)));
  const Point2 b = family.position(arrangement.point(arrangement.right(e)));
  const BranchId branch = arrangement.branch(e);
  if (family.is_line(branch)) return (b.x - a.x) * (a.y + b.y) / 2;
  const CircularSupport& circle = family.rounded(CircularFamily::support(branch));
  const auto integral = [&](double x) {
    const double u = std::clamp((x - circle.x) / circle.radius, -1.0, 1.0);
    return circle.radius * circle.radius / 2 * (u * std::sqrt(1 - u * u) + std::asin(u));
  };
  const double half = integral(b.x) - integral(a.x);
  return circle.y * (b.x - a.x) + (CircularFamily::is_upper(branch) ? half : -half);
}

double area_of(const CircularPolygonSet& set) {
  const CircularArrangement& arrangement = set.arrangement();
  double result = 0;
  for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!arrangement.cells().is_real(e)) continue;
    const bool above = set.contains(arrangement.cells().face(dcel::HalfedgeId(e, false)));
    const bool below = set.contains(arrangement.cells().face(dcel::HalfedgeId(e, true)));
    if (above != below) result += (below ? 1 : -1) * area_under(arrangement, e);
  }
  return result;
}

/// Boundary edges of a set as pairs of exact points.
std::vector<std::pair<RationalPoint2, RationalPoint2>> edges_of(const LinearPolygonSet& set) {
  std::vector<std::pair<RationalPoint2, RationalPoint2>> result;
  const LinearArrangement& arrangement = set.arrangement();
  for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!arrangement.cells().is_real(e)) continue;
    result.emplace_back(arrangement.family().exact(arrangement.point(arrangement.left(e))),
                        arrangement.family().exact(arrangement.point(arrangement.right(e))));
  }
  return result;
}

/// Squared distance from a point to the boundary of a set, and whether the point is inside (nothing if on it).
struct Place {
  Rational square;
  bool is_inside = false;
};

Place place_of(const LinearPolygonSet& set, const RationalPoint2& p) {
  Place result{Rational(1 << 30), false};
  for (const auto& [a, b] : edges_of(set)) {
    const RationalPoint2 d{b.x - a.x, b.y - a.y};
    const RationalPoint2 v{p.x - a.x, p.y - a.y};
    Rational along = (d.x * v.x + d.y * v.y) / (d.x * d.x + d.y * d.y);
    along = std::clamp(along, Rational(0), Rational(1));
    const RationalPoint2 gap{v.x - along * d.x, v.y - along * d.y};
    result.square = std::min(result.square, gap.x * gap.x + gap.y * gap.y);
    if ((a.x > p.x) != (b.x > p.x) && (d.x * v.y - d.y * v.x).sign() == Sign::positive) {
      result.is_inside = !result.is_inside;
    }
  }
  return result;
}

CircularPolygonSet points_set(const std::vector<RationalPoint2>& points) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  for (const RationalPoint2& p : points) family.add_point(list, p);
  const CircularArrangement drawn = arrange(std::move(family), list, Context());
  return {drawn, std::vector<bool>(drawn.vertex_count(), true), std::vector<bool>(drawn.edge_count(), false),
          std::vector<bool>(drawn.face_count(), false)};
}

/// Points of a grid and where they are.
class Samples {
 public:
  explicit Samples(const LinearPolygonSet& set) {
    for (int x = -8; x <= 24; x += 2) {
      for (int y = -5; y <= 17; ++y) {
        points_.push_back({Rational(Integer(x), Integer(3)), Rational(Integer(y), Integer(2))});
        places_.push_back(place_of(set, points_.back()));
      }
    }
  }
  /// Those at a distance (negative inside) of at most `limit` are members of `around`, all others not of `within`.
  void expect_between(const Rational& limit, const CircularPolygonSet& within, const CircularPolygonSet& around) const {
    std::vector<RationalPoint2> near;
    std::vector<RationalPoint2> far;
    const Rational square = limit * limit;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Place& place = places_[i];
      const bool is_near = limit.sign() == Sign::negative ? place.is_inside && place.square >= square
                                                          : place.is_inside || place.square <= square;
      (is_near ? near : far).push_back(points_[i]);
    }
    EXPECT_TRUE(is_within(points_set(near), around));
    EXPECT_TRUE(both(points_set(far), within, SetOperation::intersect).is_empty());
  }

 private:
  std::vector<RationalPoint2> points_;
  std::vector<Place> places_;
};

TEST(PlanarOffset, HoldsTheRightPoints) {
  std::mt19937 random(31);
  for (int round = 0; round < test_rounds(40); ++round) {
    const bool squares = round % 3 == 0;
    const Rings rings = squares ? random_squares(random, 4) : random_rings(random, 1 + round % 2, 5, 6);
    const LinearPolygonSet set = set_of(rings);
    const Rational radius(Integer(1 + round % 5), Integer(2));
    const Rational bound(Integer(1), Integer(8 << round % 3));
    SCOPED_TRACE("round " + std::to_string(round) + ": " + written(rings) + " by " + radius.to_string());
    const Samples samples(set);
    const PlanarOffset out = offset(set, radius, {.bound = bound}, Context());
    dcel::check_links(out.inner.arrangement().cells());
    dcel::check_links(out.outer.arrangement().cells());
    EXPECT_TRUE(is_within(out.inner, out.outer));
    EXPECT_TRUE(out.inner.is_regular());
    EXPECT_TRUE(!squares || out.is_exact);
    samples.expect_between(radius, out.inner, out.outer);
    samples.expect_between(radius - out.bound, CircularPolygonSet(), out.inner);
    samples.expect_between(radius + out.bound, out.outer, CircularPolygonSet().complement());
    const Rational thin = radius / Rational(4);
    const PlanarOffset in = inset(set, thin, {.bound = bound / Rational(4)}, Context());
    EXPECT_TRUE(is_within(in.inner, in.outer));
    // Regularized: points of thin parts, which lie on the boundary of what is left of nothing, are no members.
    samples.expect_between(-thin, in.inner, CircularPolygonSet().complement());
    samples.expect_between(-thin - bound, CircularPolygonSet(), in.outer);
    samples.expect_between(-thin - bound, CircularPolygonSet(), in.inner);
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(PlanarOffset, AreaOfConvexPolygons) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  for (int round = 0; round < 40; ++round) {
    std::vector<double> angles(3 + round % 10);
    for (double& a : angles) a = angle(random);
    std::sort(angles.begin(), angles.end());
    Ring ring;
    for (const double a : angles) ring.push_back({3 * std::cos(a), 2 * std::sin(a)});
    double twice = 0;
    double perimeter = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& a = ring[i];
      const Point2& b = ring[(i + 1) % ring.size()];
      twice += a.x * b.y - a.y * b.x;
      perimeter += std::hypot(b.x - a.x, b.y - a.y);
    }
    const double radius = 0.25 * (1 + round % 7);
    const PlanarOffset result = offset(set_of({ring}), radius, {.bound = Rational(0x1p-10)}, Context());
    const double expected = twice / 2 + perimeter * radius + std::numbers::pi * radius * radius;
    const double inner = area_of(result.inner);
    const double outer = area_of(result.outer);
    EXPECT_LE(inner, expected + 1e-9) << written({ring});
    EXPECT_GE(outer, expected - 1e-9) << written({ring});
    EXPECT_LE(outer - inner, 2.1 * 0x1p-10 * (perimeter + 2 * std::numbers::pi * radius)) << written({ring});
    EXPECT_FALSE(result.is_exact);
  }
}

TEST(PlanarOffset, EdgesOfRationalLengthAreExact) {
  const LinearPolygonSet triangle = set_of({{{0, 0}, {3, 0}, {0, 4}}});
  const PlanarOffset result = offset(triangle, 1.5, {}, Context());
  EXPECT_TRUE(result.is_exact);
  EXPECT_EQ(result.bound, Rational(0));
  EXPECT_NEAR(area_of(result.inner), 6 + 12 * 1.5 + std::numbers::pi * 2.25, 1e-12);
  const PlanarOffset inner = inset(triangle, 0.5, {}, Context());
  EXPECT_TRUE(inner.is_exact);
  // Of half the inradius: similar, half as large.
  EXPECT_NEAR(area_of(inner.inner), 1.5, 1e-12);
  EXPECT_EQ(inner.inner.arrangement().counts().edges, 3U);
  EXPECT_TRUE(inset(triangle, 1, {}, Context()).outer.is_empty());
  EXPECT_FALSE(inset(triangle, 0x1.ffffffffp-1, {}, Context()).inner.is_empty());
  const LinearPolygonSet third = translated(triangle, {Rational(Integer(1), Integer(3)), Rational(0.1)}, Context());
  const PlanarOffset moved = offset(third, Rational(Integer(1), Integer(7)), {}, Context());
  EXPECT_TRUE(moved.is_exact);
  EXPECT_NEAR(area_of(moved.outer), 6 + 12 / 7.0 + std::numbers::pi / 49, 1e-12);
}

TEST(PlanarOffset, SquaresAndHoles) {
  const LinearPolygonSet frame = set_of({box(0, 0, 10, 10), box(3, 3, 4, 4)});
  const PlanarOffset wide = offset(frame, 1.0, {}, Context());
  EXPECT_TRUE(wide.is_exact);
  EXPECT_NEAR(area_of(wide.inner), 100 + 40 + std::numbers::pi - 4, 1e-12);
  EXPECT_NEAR(area_of(offset(frame, 2.0, {}, Context()).inner), 100 + 80 + 4 * std::numbers::pi, 1e-12);
  const CircularPolygonSet smaller = inset(set_of({box(0, 0, 10, 10)}), 2.0, {}, Context()).inner;
  EXPECT_EQ(smaller.arrangement().counts().edges, 4U);
  EXPECT_NEAR(area_of(smaller), 36, 1e-12);
  EXPECT_TRUE(inset(set_of({box(0, 0, 10, 10)}), 5.0, {}, Context()).outer.is_empty());
  EXPECT_NEAR(area_of(inset(frame, 1.0, {}, Context()).inner), 64 - 16 - 16 - std::numbers::pi, 1e-12);
  EXPECT_EQ(polygons_of(inset(frame, 1.5, {}, Context()).inner).size(), 4U);  // only the corners are wide enough
  EXPECT_TRUE(inset(frame, 2.125, {}, Context()).inner.is_empty());
}

TEST(PlanarOffset, ManyShortEdges) {
  // Edges far shorter than what the normals may be off by, times the radius.
  Ring ring;
  for (int i = 0; i < 200; ++i) {
    const double a = 2 * std::numbers::pi * i / 200;
    ring.push_back({std::cos(a) * 0x1p-6, std::sin(a) * 0x1p-6});
  }
  const PlanarOffset result = offset(set_of({ring}), 1.0, {.bound = Rational(0x1p-4)}, Context());
  EXPECT_TRUE(is_within(result.inner, result.outer));
  const double exact = std::numbers::pi * (1 + 0x1p-6) * (1 + 0x1p-6);
  EXPECT_LE(area_of(result.inner), exact);
  EXPECT_GE(area_of(result.inner), exact - 2 * std::numbers::pi * 1.1 * 0x1p-4);
  EXPECT_LE(area_of(result.outer), exact + 2 * std::numbers::pi * 1.1 * 0x1p-4);
}

TEST(PlanarOffset, RefusesAtTheDoor) {
  const LinearPolygonSet square = set_of({box(0, 0, 1, 1)});
  EXPECT_THROW(offset(square, 0.0, {}, Context()), InputError);
  EXPECT_THROW(offset(square, -1.0, {}, Context()), InputError);
  EXPECT_THROW(offset(square, std::numeric_limits<double>::quiet_NaN(), {}, Context()), InputError);
  EXPECT_THROW(inset(square, std::numeric_limits<double>::infinity(), {}, Context()), InputError);
  EXPECT_THROW(offset(square, 1.0, {.bound = Rational(-1)}, Context()), InputError);
  EXPECT_THROW(offset(square.complement(), 1.0, {}, Context()), InputError);
  EXPECT_TRUE(offset(LinearPolygonSet(), 1.0, {}, Context()).inner.is_empty());
  EXPECT_TRUE(inset(LinearPolygonSet(), 1.0, {}, Context()).outer.is_empty());
}

TEST(UnitBracket, EnclosesEveryDirection) {
  std::mt19937 random(2);
  for (int round = 0; round < 2000; ++round) {
    const auto coordinate = [&] {
      return Rational(Integer(static_cast<int>(random() % 41) - 20), Integer(1 + round % 3));
    };
    const RationalPoint2 v{coordinate(), coordinate()};
    if (v.x.sign() == Sign::zero && v.y.sign() == Sign::zero) continue;
    const Rational cosine = Rational(1) - Rational(std::ldexp(1.0, -1 - round % 90));
    const planar::UnitBracket bracket = planar::unit_bracket(v, cosine);
    const auto turn = [](const RationalPoint2& a, const RationalPoint2& b) { return (a.x * b.y - a.y * b.x).sign(); };
    for (const RationalPoint2& u : {bracket.clockwise, bracket.counterclockwise}) {
      ASSERT_EQ(u.x * u.x + u.y * u.y, Rational(1));
      const Rational along = u.x * v.x + u.y * v.y;
      ASSERT_EQ(along.sign(), Sign::positive);
      ASSERT_TRUE(along * along >= cosine * cosine * (v.x * v.x + v.y * v.y));
    }
    const Sign expected = bracket.is_exact ? Sign::zero : Sign::positive;
    ASSERT_EQ(turn(bracket.clockwise, v), expected) << v.x.to_string() << ' ' << v.y.to_string();
    ASSERT_EQ(turn(v, bracket.counterclockwise), expected) << v.x.to_string() << ' ' << v.y.to_string();
  }
}

}  // namespace
}  // namespace quoin
