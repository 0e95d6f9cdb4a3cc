// SPDX-License-Identifier: Apache-2.0
//
// Distances of solids against all pairs of a vertex and a face, and of two edges, one by one in rationals, and
// relations against regularized intersections.
#include "quoin/solid/query/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/solid/moved_boundary.h"
#include "quoin/solid/query/boundary_distance.h"
#include "quoin/solid/query/face_place.h"
#include "quoin/solid/test_solids.h"

namespace quoin {
namespace {

using namespace testing;
using Random = std::mt19937_64;

/// The least square over pairs that do not cross.
class AllPairs {
 public:
  AllPairs(const Brep& a, const Brep& b) {
    add_vertices(a, b);
    add_vertices(b, a);
    for_each_edge(a, [&](const RationalPoint3& p, const RationalPoint3& q) {
      for_each_edge(b, [&](const RationalPoint3& r, const RationalPoint3& s) { add_edges(p, q, r, s); });
    });
  }
  const Rational& squared() const { return *least_; }

 private:
  template <class Visit>
  static void for_each_edge(const Brep& b, const Visit& visit) {
    for (std::size_t l = 0; l < b.loop_count(); ++l) {
      const auto loop = b.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointId p = loop[i];
        const PointId q = loop[(i + 1) % loop.size()];
        if (p < q) visit(b.points.exact(p), b.points.exact(q));
      }
    }
  }
  void add(const RationalPoint3& p, const RationalPoint3& q) {
    Rational square = dot(p - q, p - q);
    if (!least_ || square < *least_) least_ = std::move(square);
  }
  void add_vertices(const Brep& from, const Brep& to) {
    for (const PointId corner : from.loop_vertices) {
      const RationalPoint3 p = from.points.exact(corner);
      for (std::uint32_t f = 0; f < to.face_count(); ++f) {
        const auto& plane = to.face_planes[f];
        const RationalPoint3 a = to.points.exact(plane[0]);
        const RationalPoint3 n = cross(to.points.exact(plane[1]) - a, to.points.exact(plane[2]) - a);
        const RationalPoint3 foot = p - n * (dot(n, p - a) / dot(n, n));
        const FacePlace place = place_in_face(to, f, PlacedPoint(to.points, foot), projection_axis(to, f));
        if (place.kind != FacePlace::Kind::outside) add(p, foot);
      }
    }
  }
  static RationalPoint3 closest_on(const RationalPoint3& p, const RationalPoint3& q, const RationalPoint3& x) {
    const Rational t = dot(x - p, q - p) / dot(q - p, q - p);
    return p + (q - p) * std::clamp(t, Rational(0), Rational(1));
  }
  void add_edges(const RationalPoint3& p, const RationalPoint3& q, const RationalPoint3& r, const RationalPoint3& s) {
    for (const RationalPoint3& x : {p, q}) add(x, closest_on(r, s, x));
    for (const RationalPoint3& x : {r, s}) add(x, closest_on(p, q, x));
    const RationalPoint3 n = cross(q - p, s - r);
    if (dot(n, n).sign() == Sign::zero) return;
    // Where each meets the plane through the other and the common normal.
    const RationalPoint3 by_first = cross(q - p, n);
    const RationalPoint3 by_second = cross(s - r, n);
    const Rational t = dot(by_second, r - p) / dot(by_second, q - p);
    const Rational w = dot(by_first, p - r) / dot(by_first, s - r);
    if (t < Rational(0) || Rational(1) < t || w < Rational(0) || Rational(1) < w) return;
    add(p + (q - p) * t, r + (s - r) * w);
  }

  std::optional<Rational> least_;
};

SolidDistance check(const Solid& a, const Solid& b) {
  const SolidDistance d = solid_distance(a, b, one_thread);
  EXPECT_EQ(d.relation, interference(a, b, one_thread).kind);
  const SolidDistance turned = solid_distance(b, a, one_thread);
  EXPECT_EQ(turned.relation, d.relation);
  EXPECT_EQ(turned.squared_distance, d.squared_distance);
  if (d.relation == Interference::overlapping) {
    EXPECT_EQ(d.squared_distance, Rational(0));
    return d;
  }
  const RationalPoint3 between = d.witness[0] - d.witness[1];
  EXPECT_EQ(dot(between, between), d.squared_distance);
  EXPECT_TRUE(is_on_boundary(place_of(a, d.witness[0])));
  EXPECT_TRUE(is_on_boundary(place_of(b, d.witness[1])));
  EXPECT_EQ(d.squared_distance.sign() == Sign::zero, d.relation == Interference::touching);
  const std::size_t pairs = a.boundary().face_count() * b.boundary().face_count();
  if (tests_take_fewer_rounds && pairs > 60) return d;
  EXPECT_EQ(AllPairs(a.boundary(), b.boundary()).squared(), d.squared_distance);
  return d;
}

TEST(SolidDistance, OfSolidsThatAreKnown) {
  const Solid unit = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(check(unit, box({2, 0, 0}, {3, 1, 1})).squared_distance, Rational(1));
  EXPECT_EQ(check(unit, box({2, 3, 3}, {3, 4, 4})).squared_distance, Rational(9));
  EXPECT_EQ(check(unit, box({1, 0.5, 0.25}, {2, 2, 2})).relation, Interference::touching);
  EXPECT_EQ(check(unit, box({1, 1, 1}, {2, 2, 2})).relation, Interference::touching);
  EXPECT_EQ(check(unit, box({0.5, 0.5, 0.5}, {2, 2, 2})).relation, Interference::overlapping);
  EXPECT_EQ(check(unit, unit).relation, Interference::overlapping);
  EXPECT_EQ(check(unit, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})).relation, Interference::overlapping);
  EXPECT_EQ(check(unit, box({1 + 0x1p-52, 0, 0}, {2, 1, 1})).squared_distance, Rational(0x1p-104));
}

TEST(SolidDistance, OfSolidsInCavitiesAndHoles) {
  const Solid hollow = box({0, 0, 0}, {10, 10, 10}) - box({1, 1, 1}, {9, 9, 9});
  EXPECT_EQ(check(hollow, box({4, 4, 4}, {6, 6, 7})).squared_distance, Rational(4));
  EXPECT_EQ(check(hollow, box({4, 4, 4}, {6, 6, 9})).relation, Interference::touching);
  EXPECT_EQ(check(hollow, box({4, 4, 4}, {6, 6, 9.5})).relation, Interference::overlapping);
  EXPECT_EQ(check(hollow, box({-1, -1, -1}, {11, 11, 11})).relation, Interference::overlapping);
  EXPECT_EQ(check(hollow, box({11, 4, 4}, {12, 6, 7})).squared_distance, Rational(1));
  // Through a hole, and a piece beside it.
  const Solid frame = box({0, 0, 0}, {10, 10, 1}) - box({3, 3, -1}, {7, 7, 2});
  EXPECT_EQ(check(frame, box({4, 4, -5}, {6, 6, 5})).squared_distance, Rational(1));
  EXPECT_EQ(check(frame, box({3, 4, -5}, {6, 6, 5})).relation, Interference::touching);
  const Solid pieces = box({4, 4, -5}, {6, 6, 5}) | box({20, 0, 0}, {21, 1, 1}) | box({10.5, 0, 0}, {11, 1, 1});
  EXPECT_EQ(check(frame, pieces).squared_distance, Rational(0.25));
  // One hollow solid in another, and the complement.
  const Solid inner = box({3, 3, 3}, {7, 7, 7}) - box({4, 4, 4}, {6, 6, 6});
  EXPECT_EQ(check(hollow, inner).squared_distance, Rational(4));
  EXPECT_EQ(check(~hollow, box({2, 2, 2}, {3, 3, 3})).relation, Interference::overlapping);
  EXPECT_EQ(check(~box({0, 0, 0}, {10, 10, 10}), box({2, 3, 4}, {5, 5, 5})).squared_distance, Rational(4));
}

TEST(SolidDistance, OfSolidsWithoutBoundary) {
  const Solid unit = box({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(solid_distance(unit, Solid(), one_thread), InputError);
  EXPECT_THROW(solid_distance(Solid(), unit, one_thread), InputError);
  EXPECT_EQ(solid_distance(unit, ~Solid(), one_thread).relation, Interference::overlapping);
  const Brep none;
  EXPECT_THROW(BoundaryProximity(none, unit.boundary(), one_thread), InputError);
}

Solid random_box(Random& random, int size) {
  const auto draw = [&](int end) { return static_cast<double>(random() % static_cast<std::uint64_t>(end)); };
  const Point3 low{draw(size), draw(size), draw(size)};
  return box(low, {low.x + 1 + draw(3), low.y + 1 + draw(3), low.z + 1 + draw(3)});
}

/// Two or three boxes of a grid, joined or taken away; with slants where corners are constructed points.
Solid random_solid(Random& random, const Vector3& at) {
  Solid s = random_box(random, 4);
  for (int i = 0; i < 2; ++i) s = random() % 3 == 0 ? s - random_box(random, 4) : s | random_box(random, 4);
  if (random() % 2 == 0) {
    Mesh cut = shapes::tetrahedron(3);
    for (Point3& p : cut.vertices) p = {std::round(p.x * 4) / 4 + 2, std::round(p.y * 4) / 4 + 2, std::round(p.z) + 2};
    s = random() % 2 == 0 ? s - solid(cut) : s | solid(cut);
  }
  // What of it is in a window.
  return s & box({at.x, at.y, at.z}, {at.x + 8, at.y + 8, at.z + 8});
}

TEST(SolidDistance, AgreesWithAllPairsOfFeatures) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(40U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto draw = [&](int end) { return static_cast<double>(random() % static_cast<std::uint64_t>(end)); };
    const Solid a = random_solid(random, {-6 + draw(2), -1, -1});
    const Solid b = random_solid(random, {1 + draw(3), -draw(3), -1 + draw(2)});
    if (a.is_empty() || b.is_empty()) continue;
    ++seen.at(static_cast<std::size_t>(check(a, b).relation));
    if (HasFailure()) return;
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(2));
}

/// Turned by angles of no rational sine, so that all distances are of constructed points without a short form.
TEST(SolidDistance, AgreesWhereNothingIsParallel) {
  for (std::uint64_t seed = 0; seed < test_rounds(5U); ++seed) {
    Random random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto turned = [&](const Mesh& mesh, double x) {
      return shapes::translated(
          shapes::rotated(shapes::rotated(mesh, shapes::Axis::x, unit(random)), shapes::Axis::z, unit(random)),
          {x, unit(random) / 4, unit(random) / 4});
    };
    const Solid a = solid(turned(shapes::cube(2), 0)) - solid(turned(shapes::octahedron(1), 1));
    const Solid b = solid(turned(shapes::torus(5, 4, 1, 0.4), 3.1 + unit(random) / 4));
    check(a, b);
    if (HasFailure()) return;
  }
}

TEST(SolidDistance, OfSlantedFacesThatAreNearlyInContact) {
  // A wedge whose slant is the plane x + y + z = 1, and boxes with a corner on it, short of it, and beyond.
  Mesh wedge;
  wedge.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& f : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {0U, 3U, 2U}, {1U, 2U, 3U}}) wedge.add_face(f);
  const Solid s = solid(wedge);
  const auto at = [](double x) { return box({x, 0.25, 0.25}, {2, 2, 2}); };
  EXPECT_EQ(check(s, at(0.5)).relation, Interference::touching);
  EXPECT_EQ(check(s, at(0.5 + 0x1p-53)).squared_distance, Rational(0x1p-106) / Rational(3));
  EXPECT_EQ(check(s, at(0.5 - 0x1p-54)).relation, Interference::overlapping);
}

TEST(SolidDistance, OfAnySize) {
  for (const double size : {0x1p-1060, 0x1p1000}) {
    const auto scaled = [&](double x) { return box({x * size, 0, 0}, {(x + 1) * size, size, size}); };
    EXPECT_EQ(check(scaled(0), scaled(3)).squared_distance, Rational(4) * Rational(size) * Rational(size));
    EXPECT_EQ(check(scaled(0), scaled(1)).relation, Interference::touching);
  }
}

Solid moved(const Solid& s, const RationalPoint3& by) {
  return Solid::from_leaf(make_leaf(moved_boundary(s.boundary(), by), "moved", {}, one_thread).leaf, one_thread);
}

/// By vectors of doubles and of fractions, also to where little of the coordinates is left.
TEST(SolidProximity, AgreesWithSolidsThatWereMoved) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 0; seed < test_rounds(12U); ++seed) {
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Rational away(seed % 3 == 0 ? 1e6 : 0);
    const Solid a = moved(random_solid(random, {-1, -1, -1}), {away, 0, 0});
    const Solid b = random_solid(random, {-1, -1, -1});
    if (a.is_empty() || b.is_empty()) continue;
    const SolidProximity proximity(a, b, one_thread);
    for (int round = 0; round < 5; ++round) {
      const auto draw = [&](int end) { return Rational(static_cast<int>(random() % static_cast<unsigned>(end))); };
      const Rational part = round % 2 == 0 ? Rational(1) : Rational(1) / Rational(3);
      const RationalPoint3 by{(draw(16) - Rational(7)) * part - away, draw(5) * part - Rational(2), draw(3) * part};
      const SolidDistance d = proximity.distance(by, one_thread);
      const SolidDistance expected = solid_distance(moved(a, by), b, one_thread);
      ++seen.at(static_cast<std::size_t>(d.relation));
      EXPECT_EQ(d.relation, expected.relation);
      EXPECT_EQ(d.squared_distance, expected.squared_distance);
      if (d.relation == Interference::overlapping) continue;
      EXPECT_TRUE(is_on_boundary(place_of(a, d.witness[0] - by)));
      EXPECT_TRUE(is_on_boundary(place_of(b, d.witness[1])));
    }
    if (HasFailure()) return;
  }
  for (const int count : seen) EXPECT_GE(count, test_cases(3));
  // In the cavity of one that moves, and one that moves in a cavity.
  const Solid hollow = box({0, 0, 0}, {10, 10, 10}) - box({1, 1, 1}, {9, 9, 9});
  const Solid inner = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(SolidProximity(hollow, inner, one_thread).distance({-4, -4, -4}, one_thread).squared_distance, Rational(9));
  EXPECT_EQ(SolidProximity(inner, hollow, one_thread).distance({4, 4, 5}, one_thread).squared_distance, Rational(9));
  EXPECT_EQ(SolidProximity(inner, hollow, one_thread).distance({8, 4, 5}, one_thread).relation, Interference::touching);
  EXPECT_EQ(SolidProximity(~hollow, inner, one_thread).distance({-4, -4, -4}, one_thread).relation,
            Interference::overlapping);
  EXPECT_EQ(SolidProximity(~hollow, inner, one_thread).distance({1, 0, 0}, one_thread).relation,
            Interference::overlapping);
  const Rational far(1e300);
  EXPECT_EQ(
      SolidProximity(inner, inner, one_thread).distance({far * far + Rational(1), 0, 0}, one_thread).squared_distance,
      far * far * far * far);
}

TEST(SolidDistance, OfFinelyDividedSolids) {
  const Solid torus = solid(shapes::torus(60, 40, 5, 1));
  const Solid ball = solid(shapes::geodesic_sphere(12, 1));
  const Context context({.threads = 1});
  const SolidDistance d = solid_distance(torus, ball, context);
  EXPECT_EQ(d.relation, Interference::apart);
  EXPECT_NEAR(std::sqrt(d.squared_distance.to_double()), 3, 0.05);
  EXPECT_TRUE(is_on_boundary(place_of(torus, d.witness[0])));
  EXPECT_TRUE(is_on_boundary(place_of(ball, d.witness[1])));
  Context cancelled({.threads = 1});
  cancelled.cancel();
  EXPECT_THROW(solid_distance(torus, ball, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
