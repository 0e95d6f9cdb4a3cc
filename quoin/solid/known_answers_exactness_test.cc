// SPDX-License-Identifier: Apache-2.0
//
// Known answers about incidence and exact arithmetic, each a failure of floating-point numbers: C. M. Hoffmann,
// Geometric and Solid Modeling, 1989, chapter 4.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "quoin/kernel/constructions.h"
#include "quoin/kernel/plane.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/test_points.h"
#include "quoin/kernel/transformation.h"
#include "quoin/solid/test_solids.h"

namespace quoin::testing {
namespace {

Rational power_of_two(int exponent) {
  return Rational(std::ldexp(1.0, exponent));
}

// Section 4.2.2, asymmetry: u is where L1 and L2 meet, v where L3 and L4 do. Residuals below 1e-10 would put v on L1
// and L2, but u neither on L3 nor on L4. Exactly, u and v differ, whichever is asked about the other.
TEST(KnownAnswersExactness, IncidenceIsSymmetric) {
  const double tiny = 0x1p-23;
  const double at = 1 + 0x1p-15;
  // Two points of each line (z = 0), and what spans the plane z = 0.
  Constructions table(std::vector<Point3>{{0, 0, 0},
                                          {2, 2, 0},
                                          {1 + 2 * (1 - tiny), 1 + 2 * (1 + tiny), 0},
                                          {1 - 2 * (1 - tiny), 1 - 2 * (1 + tiny), 0},
                                          {at, 0, 0},
                                          {at, 4, 0},
                                          {0, at, 0},
                                          {4, at, 0}});
  table.resize_planes(5);
  for (std::uint32_t l = 0; l < 4; ++l) table.set_axis_plane(PlaneId{l}, PointId{2 * l}, PointId{2 * l + 1}, 2);
  table.set_plane(PlaneId{4U}, PointId{0U}, PointId{1U}, PointId{4U});
  table.resize_points(10);
  const PointId u{8U};
  const PointId v{9U};
  table.set_point(u, PlaneId{0U}, PlaneId{1U}, PlaneId{4U});
  table.set_point(v, PlaneId{2U}, PlaneId{3U}, PlaneId{4U});
  EXPECT_EQ(table.exact(u), (RationalPoint3{1, 1, 0}));
  EXPECT_EQ(table.exact(v), (RationalPoint3{at, at, 0}));
  EXPECT_FALSE(table.equal(u, v));
  EXPECT_FALSE(table.equal(v, u));
  EXPECT_EQ(table.side(v, PlaneId{0U}), Sign::zero);
  EXPECT_NE(table.side(v, PlaneId{1U}), Sign::zero);
  EXPECT_NE(table.side(u, PlaneId{2U}), Sign::zero);
  EXPECT_NE(table.side(u, PlaneId{3U}), Sign::zero);
  // The same by coefficients; the residuals are those printed.
  const Plane3 l2{{-(1 + tiny), 1 - tiny, 0}, -2 * tiny};
  EXPECT_EQ(side({at, at, 0}, l2), Sign::negative);
  EXPECT_EQ(-(1 + tiny) * at + (1 - tiny) * at + 2 * tiny, -0x1p-37);
  EXPECT_LT(0x1p-37, 1e-10);
  EXPECT_GT(at - 1, 1e-10);
}

// Section 4.2.2, intransitivity: three points 0.8e-10 apart are three points, and equality is an equivalence.
TEST(KnownAnswersExactness, EqualityIsTransitive) {
  Constructions table(std::vector<Point3>{{0, 0, 0}, {0, 0.8e-10, 0}, {0, 1.6e-10, 0}});
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) EXPECT_EQ(table.equal(PointId{i}, PointId{j}), i == j);
  }
  const Solid thin = box({0, 0, 0}, {1, 1.6e-10, 1});
  const Solid half = box({0, 0, 0}, {1, 0.8e-10, 1});
  EXPECT_EQ(counts_of(thin - half), (Counts{8, 12, 6, 6, 1, 0}));
  EXPECT_EQ(volume_of(thin - half), Rational(1.6e-10) - Rational(0.8e-10));
}

// Section 4.2.2, topology violation: an edge leaves through the top of a block at a shallow angle close to one of the
// top's edges. What the top says and what the side says about that edge agree.
TEST(KnownAnswersExactness, AnEdgeThatCrossesAFaceCloseToAnother) {
  const Solid block = box({0, 0, 0}, {4, 4, 4});
  for (const int exponent : {4, 20, 33, 45, 50}) {
    const double tiny = std::ldexp(1.0, -exponent);
    for (const double across : {-tiny, 0.0, tiny}) {  // where the needle's edge passes: outside, on, inside of the edge
      Mesh needle;
      needle.vertices = {{4 - across, 1, 4 - tiny}, {4 - across, 3, 4 + tiny}, {6, 1, 5}, {6, 1, 3}};
      for (const Tile& t : {Tile{0, 1, 2}, Tile{1, 0, 3}, Tile{2, 1, 3}, Tile{0, 2, 3}}) needle.add_face(t);
      const Solid b = solid(shapes::approximate_volume(needle) > 0 ? needle : shapes::reversed(needle));
      SCOPED_TRACE(::testing::Message() << exponent << " " << across);
      for (const Solid& s : {block | b, block & b, block - b, b - block}) expect_valid(s);
      EXPECT_EQ(volume_of(block | b) + volume_of(block & b), volume_of(block) + volume_of(b));
      EXPECT_EQ((block & b).is_empty(), across <= 0);
    }
  }
}

// Where a x + b y + c = 0 and d x + e y + f = 0 meet, as a constructed point of a table of rational points.
RationalPoint3 meet(const std::array<Rational, 3>& l, const std::array<Rational, 3>& m) {
  const auto points_on = [](const std::array<Rational, 3>& line) {
    const Rational norm = line[0] * line[0] + line[1] * line[1];
    const RationalPoint3 foot{-line[0] * line[2] / norm, -line[1] * line[2] / norm, 0};
    return std::array{foot, foot + RationalPoint3{line[1], -line[0], 0}};
  };
  const auto p = points_on(l);
  const auto q = points_on(m);
  Constructions table(std::vector<RationalPoint3>{p[0], p[1], q[0], q[1]});
  table.resize_points(5);
  table.set_crossing(PointId{4U}, PointId{0U}, PointId{1U}, PointId{2U}, PointId{3U}, 2);
  return table.exact(PointId{4U});
}

// Section 4.2.3, conditioning: -x + y = 0 and -(1 + q) x + (1 - q) y + 2 q = 0 meet in (1, 1) for every q = 2^-m. With
// coefficients off by p = 2^-53, at q = 2^-18 (an angle of a second of arc), they meet 5.8e-11 away.
TEST(KnownAnswersExactness, LinesAtASecondOfArc) {
  for (int m = 6; m <= 200; ++m) {
    const Rational q = power_of_two(-m);
    EXPECT_EQ(meet({-1, 1, 0}, {-(Rational(1) + q), Rational(1) - q, Rational(2) * q}), (RationalPoint3{1, 1, 0})) << m;
  }
  const Rational q = power_of_two(-18);
  const Rational p = power_of_two(-53);
  const RationalPoint3 moved =
      meet({-(Rational(1) + p), Rational(1) - p, 0}, {-(Rational(1) + q - p), Rational(1) - q + p, Rational(2) * q});
  EXPECT_NEAR((moved.x - Rational(1)).to_double(), 5.82e-11, 0.01e-11);
  EXPECT_NEAR((moved.y - Rational(1)).to_double(), 5.82e-11, 0.01e-11);
}

using Pentagon = std::array<RationalPoint3, 5>;

// Crossings of the diagonals (step 2), or of the sides produced (step 1), in the order of the vertices opposite to
// them.
Pentagon crossings(const Pentagon& p, std::uint32_t step) {
  Constructions table(std::vector<RationalPoint3>(p.begin(), p.end()));
  table.resize_points(10);
  Pentagon result;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const auto at = [&](std::uint32_t k) { return PointId{(i + k) % 5}; };
    const PointId made{5 + i};
    if (step == 2) {
      table.set_crossing(made, at(1), at(3), at(2), at(4), 2);
    } else {
      table.set_crossing(made, at(1), at(2), at(3), at(4), 2);
    }
    result[i] = table.exact(made);
  }
  return result;
}

Pentagon times(const Pentagon& p, int count, std::uint32_t step) {
  Pentagon result = p;
  for (int i = 0; i < count; ++i) result = crossings(result, step);
  return result;
}

std::size_t largest_bits(const Pentagon& p) {
  std::size_t bits = 0;
  for (const RationalPoint3& v : p) {
    for (const unsigned axis : {0U, 1U})
      bits = std::max({bits, v[axis].numerator().bit_length(), v[axis].denominator().bit_length()});
  }
  return bits;
}

// Section 4.2.4, compound operations: the pentagon of the diagonals' crossings and that of the produced sides undo one
// another, at any depth and flatness; in doubles the error reaches 0.8 at depth 3 and p = 1e-5.
TEST(KnownAnswersExactness, PentagonsWithinPentagons) {
  for (const int decade : {10, 100, 1000, 10000, 100000, 1000000}) {
    const Rational far = Rational(1) + Rational(1) / Rational(decade);
    const Pentagon p{RationalPoint3{0, 0, 0}, {1, 0, 0}, {far, 1, 0}, {1, far, 0}, {0, 1, 0}};
    for (int depth = 1; depth <= 5; ++depth) {
      SCOPED_TRACE(::testing::Message() << "p 1/" << decade << " depth " << depth);
      EXPECT_EQ(times(times(p, depth, 2), depth, 1), p);
      EXPECT_EQ(times(times(p, depth, 1), depth, 2), p);
    }
  }
  const Rational far = Rational(1001) / Rational(1000);
  const Pentagon p{RationalPoint3{0, 0, 0}, {1, 0, 0}, {far, 1, 0}, {1, far, 0}, {0, 1, 0}};
  constexpr std::size_t inward[] = {11, 22, 41, 54, 72};
  constexpr std::size_t outward[] = {11, 31, 41, 61, 72};
  for (int depth = 1; depth <= 5; ++depth) {
    EXPECT_EQ(largest_bits(times(p, depth, 2)), inward[depth - 1]);
    EXPECT_EQ(largest_bits(times(p, depth, 1)), outward[depth - 1]);
  }
}

// Section 4.6: a matrix and its inverse, each multiplied m times.
TEST(KnownAnswersExactness, PowersOfAMatrixAndItsInverse) {
  const Transformation a = Transformation::rotation(0, Rational(3) / Rational(7)) *
                           Transformation::rotation(2, Rational(1) / Rational(1000)) *
                           Transformation::translation(Rational(1) / Rational(3), 5, -2);
  Transformation product;
  Transformation undo;
  for (int m = 0; m < 100; ++m) {
    product = product * a;
    undo = undo * a.inverse();
    ASSERT_EQ(product * undo, Transformation()) << m;
  }
}

// Section 4.3.2: of x - 1, y - 1, 1 - z the point (1, 1, 1) is above x + y - z = 0. The determinant of the three is
// negative here and positive when one plane is turned round: the verdict must not change.
TEST(KnownAnswersExactness, APointAboveAPlane) {
  Constructions table(std::vector<Point3>{{1, 0, 0},
                                          {1, 1, 0},
                                          {1, 0, 1},
                                          {0, 1, 0},
                                          {0, 1, 1},
                                          {1, 1, 5},
                                          {0, 0, 1},
                                          {0, 1, 1},
                                          {1, 0, 1},
                                          {0, 0, 0},
                                          {1, -1, 0},
                                          {1, 0, 1}});
  table.resize_planes(7);
  const auto point = [](std::uint32_t i) { return PointId{i}; };
  for (std::uint32_t plane = 0; plane < 3; ++plane) {
    table.set_plane(PlaneId{plane}, point(3 * plane), point(3 * plane + 1), point(3 * plane + 2));
    table.set_plane(PlaneId{4 + plane}, point(3 * plane + 1), point(3 * plane), point(3 * plane + 2));
  }
  table.set_plane(PlaneId{3U}, point(9), point(11), point(10));
  const auto equation = table.plane_equation(PlaneId{3U});
  ASSERT_EQ(equation[0].sign(), Sign::positive);
  ASSERT_EQ(equation[2].sign(), Sign::negative);
  table.resize_points(13);
  for (std::uint32_t turned = 0; turned < 8; ++turned) {
    const auto plane = [&](std::uint32_t k) { return PlaneId{(turned >> k & 1U) != 0 ? 4 + k : k}; };
    std::array<std::uint32_t, 3> order{0, 1, 2};
    do {
      table.set_point(point(12), plane(order[0]), plane(order[1]), plane(order[2]));
      EXPECT_EQ(table.exact(point(12)), (RationalPoint3{1, 1, 1}));
      EXPECT_EQ(table.side(point(12), PlaneId{3U}), Sign::positive);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

// Sections 4.3.1 and 4.3.2: planes over numbers of 48 bits, extreme ones among them. The side of the meeting point of
// three of them against a fourth, in fixed widths, is that of rationals.
TEST(KnownAnswersExactness, ExtremePlanesOfFortyEightBits) {
  std::mt19937_64 random(49);
  const double largest = 0x1p48 - 1;
  const auto coordinate = [&]() -> double {
    const std::uint64_t r = random();
    if (r % 4 == 0) return r % 8 == 0 ? largest : -largest;
    return static_cast<double>(static_cast<std::int64_t>(r >> 15) - (std::int64_t{1} << 48));
  };
  int decided = 0;
  for (int repeat = 0; repeat < 20'000; ++repeat) {
    std::vector<Point3> points(12);
    for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
    std::array<std::array<Rational, 4>, 4> planes;
    std::array<RationalPoint3, 4> normals;
    bool is_proper = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = [&](std::size_t i) {
        return RationalPoint3{points[3 * k + i].x, points[3 * k + i].y, points[3 * k + i].z};
      };
      normals[k] = cross(at(1) - at(0), at(2) - at(0));
      is_proper = is_proper && dot(normals[k], normals[k]).sign() != Sign::zero;
      planes[k] = {normals[k].x, normals[k].y, normals[k].z, -dot(normals[k], at(0))};
    }
    const Rational d = dot(normals[0], cross(normals[1], normals[2]));
    if (!is_proper || d.sign() == Sign::zero) continue;
    Matrix rows;
    for (const auto& plane : planes) rows.emplace_back(plane.begin(), plane.end());
    const Sign expected = determinant(rows).sign() * d.sign();
    Constructions table(points);
    table.resize_planes(4);
    for (std::uint32_t k = 0; k < 4; ++k)
      table.set_plane(PlaneId{k}, PointId{3 * k}, PointId{3 * k + 1}, PointId{3 * k + 2});
    table.resize_points(13);
    table.set_point(PointId{12U}, PlaneId{0U}, PlaneId{1U}, PlaneId{2U});
    ASSERT_EQ(table.side(PointId{12U}, PlaneId{3U}), expected) << "repeat " << repeat;
    ++decided;
  }
  EXPECT_GT(decided, 15'000);
}

// Section 4.3.4: turning by 30 degrees about x has no rational matrix; tan 15 is nearly 209 / 780, whose sine and
// cosine are 326040 and 564719 over 652081.
TEST(KnownAnswersExactness, ARationalRotationNearThirtyDegrees) {
  const Transformation t = Transformation::rotation(0, Rational(209) / Rational(780));
  EXPECT_EQ(t.rows()[1][1], Rational(564719) / Rational(652081));
  EXPECT_EQ(t.rows()[2][1], Rational(326040) / Rational(652081));
  EXPECT_EQ(t.determinant(), Rational(1));
  EXPECT_NEAR(std::asin(t.rows()[2][1].to_double()) * 180 / std::numbers::pi, 29.99995, 1e-5);
}

}  // namespace
}  // namespace quoin::testing
