// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/constructions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/test_constructions.h"

namespace quoin {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

double nearest(const Rational& x) {
  return x.to_double() + 0.0;
}

bool same_bits(const Point3& p, const Point3& q) {
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z);
}

void check_points(const Model& m) {
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    SCOPED_TRACE("point " + std::to_string(i));
    const PointId id{i};
    const RationalPoint3 exact = point_of(m.points[i]);
    const Point3 rounded{nearest(exact.x), nearest(exact.y), nearest(exact.z)};
    ASSERT_EQ(m.table.exact(id), exact);
    ASSERT_TRUE(same_bits(m.table.rounded(id), rounded))
        << m.table.rounded(id).x << " " << m.table.rounded(id).y << " " << m.table.rounded(id).z << " not " << rounded.x
        << " " << rounded.y << " " << rounded.z;
    const bool finite = std::isfinite(rounded.x) && std::isfinite(rounded.y) && std::isfinite(rounded.z);
    ASSERT_EQ(m.table.is_exact(id), finite && rational_of(rounded) == exact);
  }
}

void check_explicit_predicates(const Model& m, Random& random, int count) {
  for (int i = 0; i < count; ++i) {
    const PointId a = m.explicit_point(random), b = m.explicit_point(random), c = m.explicit_point(random);
    const PointId d = m.explicit_point(random);
    const auto axis = static_cast<unsigned>(random() % 3);
    SCOPED_TRACE(std::to_string(a.value) + " " + std::to_string(b.value) + " " + std::to_string(c.value) + " " +
                 std::to_string(d.value) + " axis " + std::to_string(axis));
    const Vector ab = minus(m.at(b), m.at(a));
    const Vector ac = minus(m.at(c), m.at(a));
    ASSERT_EQ(m.table.orientation(a, b, c, d), dot(cross(ab, ac), minus(m.at(d), m.at(a))).sign());
    ASSERT_EQ(m.table.turn(a, b, c, axis), turn_of(ab, ac, axis).sign());
  }
}

void check_point_predicates(const Model& m, Random& random, int count) {
  for (int i = 0; i < count; ++i) {
    const PointId a = m.explicit_point(random), b = m.explicit_point(random), p = m.point(random), q = m.point(random);
    const PlaneId plane = m.plane(random);
    const auto axis = static_cast<unsigned>(random() % 3);
    SCOPED_TRACE(std::to_string(p.value) + " " + std::to_string(q.value) + " axis " + std::to_string(axis));
    ASSERT_EQ(m.table.side(p, plane), (dot(m.at(plane).normal, m.at(p)) - m.at(plane).offset).sign());
    ASSERT_EQ(m.table.compare(p, q, axis), (m.at(p)[axis] - m.at(q)[axis]).sign());
    ASSERT_EQ(m.table.equal(p, q), m.at(p) == m.at(q));
    ASSERT_EQ(m.table.turn_any(a, b, p, axis), turn_of(minus(m.at(b), m.at(a)), minus(m.at(p), m.at(a)), axis).sign());
  }
}

void check_plane_predicates(const Model& m, Random& random, int count) {
  for (int i = 0; i < count; ++i) {
    const PlaneId p = m.plane(random), q = m.plane(random);
    const auto axis = static_cast<unsigned>(random() % 3);
    SCOPED_TRACE("planes " + std::to_string(p.value) + " " + std::to_string(q.value));
    ASSERT_EQ(m.table.normal_component(p, axis), m.at(p).normal[axis].sign());
    ASSERT_NE(m.table.normal_component(p, m.table.main_axis(p)), Sign::zero);
    ASSERT_EQ(m.table.dot(p, q), dot(m.at(p).normal, m.at(q).normal).sign());
    if (m.lines.empty()) continue;
    const LineId d = m.line(random), e = m.line(random);
    SCOPED_TRACE("lines " + std::to_string(d.value) + " " + std::to_string(e.value));
    ASSERT_EQ(m.table.component(d, axis), m.at(d)[axis].sign());
    ASSERT_EQ(m.table.turn(d, e, axis), turn_of(m.at(d), m.at(e), axis).sign());
    ASSERT_EQ(m.table.triple(d, p, q), dot(m.at(d), cross(m.at(p).normal, m.at(q).normal)).sign());
  }
}

void check_plane_equations(const Model& m) {
  for (std::size_t i = 0; i < m.planes.size(); ++i) {
    const auto equation = m.table.plane_equation(PlaneId{i});
    const RationalPlane& plane = m.planes[i];
    // Proportional by a positive factor, integers without a common divisor.
    unsigned k = 0;
    while (plane.normal[k].sign() == Sign::zero) ++k;
    const Rational factor = equation[k] / plane.normal[k];
    ASSERT_EQ(factor.sign(), Sign::positive);
    Integer content;
    for (unsigned j = 0; j < 4; ++j) {
      ASSERT_EQ(equation[j], factor * (j < 3 ? plane.normal[j] : plane.offset));
      ASSERT_EQ(equation[j].denominator(), Integer(1));
      mpz_gcd(content.raw(), content.raw(), equation[j].numerator().raw());
    }
    ASSERT_EQ(content, Integer(1));
  }
}

void check_subset(const Model& m, Random& random) {
  std::vector<PointId> chosen;
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    if (random() % 3 != 0) chosen.push_back(PointId{i});
  }
  const Constructions part = m.table.subset(chosen);
  ASSERT_EQ(part.point_count(), chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    ASSERT_EQ(part.exact(PointId{i}), m.table.exact(chosen[i]));
    ASSERT_TRUE(same_bits(part.rounded(PointId{i}), m.table.rounded(chosen[i])));
    const std::size_t j = random() % chosen.size();
    ASSERT_EQ(part.equal(PointId{i}, PointId{j}), m.at(chosen[i]) == m.at(chosen[j]));
    ASSERT_EQ(part.compare(PointId{i}, PointId{j}, 1), (m.at(chosen[i])[1] - m.at(chosen[j])[1]).sign());
  }
}

/// Everything a table answers about the explicit points and random constructions on them, against the definitions.
void check_table(Model& m, Random& random, int effort) {
  SCOPED_TRACE(m.reproduce());
  construct(m, random, effort);
  check_points(m);
  check_explicit_predicates(m, random, 20 * effort);
  if (m.planes.empty()) return;
  check_point_predicates(m, random, 20 * effort);
  check_plane_predicates(m, random, 10 * effort);
  check_plane_equations(m);
  check_subset(m, random);
}

GridClass class_of(int b) {
  return b <= 30 ? GridClass::bits30 : b <= 61 ? GridClass::bits61 : b <= 124 ? GridClass::bits124 : GridClass::big;
}

// ---- Properties ----

TEST(Constructions, SmallGridsInEveryClassAgreeWithRationals) {
  for (const int b : {3, 30, 31, 61, 62, 124, 125, 300}) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Random random(seed);
      SCOPED_TRACE("b " + std::to_string(b) + " seed " + std::to_string(seed));
      std::vector<Point3> points = small_grid(random, 12, 2 + static_cast<int>(seed % 3));
      if (b > 3) widen_grid(points, b);
      Model m(points);
      ASSERT_EQ(m.table.grid_class(), class_of(b));
      ASSERT_NO_FATAL_FAILURE(check_table(m, random, 12));
    }
  }
}

TEST(Constructions, LimitsOfTheClassesAgreeWithRationals) {
  for (const int b : {29, 30, 31, 60, 61, 62, 123, 124, 125}) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Random random(100 + seed);
      SCOPED_TRACE("b " + std::to_string(b) + " seed " + std::to_string(seed));
      Model m(at_limits(random, 12, b));
      ASSERT_EQ(m.table.grid_class(), class_of(b));
      ASSERT_NO_FATAL_FAILURE(check_table(m, random, 12));
    }
  }
}

TEST(Constructions, NearlyDegeneratePointsAgreeWithRationals) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(200 + seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Model m(nearly_degenerate(random, 16));
    ASSERT_NO_FATAL_FAILURE(check_table(m, random, 12));
  }
}

TEST(Constructions, MixedMagnitudesAgreeWithRationals) {
  for (const int spread : {0, 5, 20, 70, 72, 200, 900}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      Random random(300 + seed);
      SCOPED_TRACE("spread " + std::to_string(spread) + " seed " + std::to_string(seed));
      Model m(floating(random, 12, 10 + static_cast<int>(seed % 4) * 14, spread));
      ASSERT_NO_FATAL_FAILURE(check_table(m, random, 8));
    }
  }
}

TEST(Constructions, AnyScaleAgreesWithRationals) {
  for (int k = -900; k <= 900; k += 50) {
    Random random(static_cast<std::uint64_t>(k + 2000));
    SCOPED_TRACE("scale 2^" + std::to_string(k));
    std::vector<Point3> points = k % 100 == 0 ? nearly_degenerate(random, 12) : small_grid(random, 12, 3);
    scale(points, k);
    Model m(points);
    ASSERT_NO_FATAL_FAILURE(check_table(m, random, 8));
  }
}

TEST(Constructions, EndsOfTheRangeOfDoublesAgreeWithRationals) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  for (const auto& [small, large] : {std::pair(least, 100 * least),
                                     {least, 1.0},
                                     {1.0, 1e300},
                                     {1e300, most},
                                     {least, most},
                                     {1e-300, 1e300},
                                     {0x1p-331, 1.0},
                                     {0x1p-1022, 0x1p-1000}}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      Random random(400 + seed);
      SCOPED_TRACE(std::to_string(small) + " to " + std::to_string(large) + " seed " + std::to_string(seed));
      std::vector<Point3> points(10);
      for (Point3& p : points) {
        for (unsigned i = 0; i < 3; ++i) {
          p[i] = random() % 2 == 0 ? large : small;
          if (random() % 4 == 0) p[i] *= 0.75;
          if (random() % 2 == 0) p[i] = -p[i];
          if (random() % 5 == 0) p[i] = 0;
        }
      }
      Model m(points);
      ASSERT_NO_FATAL_FAILURE(check_table(m, random, 6));
    }
  }
}

TEST(Constructions, RationalPointsAgreeWithRationals) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(500 + seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::vector<RationalPoint3> points;
    for (int i = 0; i < 12; ++i) {
      Vector v;
      for (Rational& x : v) {
        x = Rational(static_cast<std::int64_t>(random() % 19) - 9) /
            Rational(static_cast<std::int64_t>(random() % 7) + 1);
        if (seed % 4 == 1 && random() % 3 == 0) x += Rational(1) / Rational(Integer(1) << (40 + random() % 60));
        if (seed % 8 == 2) x *= Rational(Integer(1) << 1100);
        if (seed % 8 == 6) x *= Rational(Integer(1), Integer(1) << 1100);
      }
      points.push_back(point_of(v));
    }
    Model m(points);
    ASSERT_EQ(m.table.grid_class(), GridClass::rational);
    ASSERT_NO_FATAL_FAILURE(check_table(m, random, 8));
  }
}

/// Coordinates that are the sum of two doubles but no double: small integers, moved by multiples of a small power of
/// two that leave many of them coplanar.
TEST(Constructions, SumsOfTwoDoublesHaveTheGridClassOfTheirBits) {
  struct Case {
    int bits;
    GridClass grid_class;
  };
  for (const Case& c : {Case{54, GridClass::bits61}, Case{110, GridClass::bits124}, Case{300, GridClass::big}}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      Random random(700 + seed);
      SCOPED_TRACE(std::to_string(c.bits) + " bits, seed " + std::to_string(seed));
      const Rational step = Rational(Integer(1), Integer(1) << static_cast<std::size_t>(c.bits));
      std::vector<RationalPoint3> points;
      for (int i = 0; i < 12; ++i) {
        Vector v;
        for (Rational& x : v) {
          x = Rational(static_cast<std::int64_t>(random() % 9) - 4) * (Rational(1) + step);
          if (i > 5 && random() % 4 == 0) x += step;
        }
        points.push_back(point_of(v));
      }
      points.push_back(point_of({Rational(4) + step, Rational(0), Rational(0)}));
      Model m(points);
      ASSERT_EQ(m.table.grid_class(), c.grid_class);
      ASSERT_FALSE(m.table.has_explicit_doubles());
      ASSERT_NO_FATAL_FAILURE(check_table(m, random, 8));
    }
  }
  const Constructions doubles(std::vector<RationalPoint3>{point_of({Rational(1), Rational(0.5), Rational(3)})});
  EXPECT_TRUE(doubles.has_explicit_doubles());
  EXPECT_EQ(doubles.grid_class(), GridClass::bits30);
}

/// The same point made in all ways: as given, on lines, of planes, as a weighted mean.
TEST(Constructions, EqualPointsAreEqualHoweverTheyWereMade) {
  for (const int b : {4, 31, 62, 125}) {
    SCOPED_TRACE(b);
    std::vector<Point3> points{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}, {6, 6, 6}, {2, 2, 2}, {1, 5, 0}, {3, 3, -3}};
    if (b > 4) widen_grid(points, b);
    Model m(points);
    m.make_plane(PointId{1}, PointId{2}, PointId{3});  // x + y + z = 6
    m.make_axis_plane(PointId{0}, PointId{4}, 2);      // x = y
    m.make_axis_plane(PointId{4}, PointId{0}, 0);      // y = z
    m.make_point(PointId{0}, PointId{4}, PlaneId{0});
    m.make_point(PlaneId{0}, PlaneId{1}, PlaneId{2});
    m.make_point(PlaneId{2}, PlaneId{1}, PlaneId{0});
    m.make_point({PointId{1}, PointId{2}, PointId{3}}, {7, 7, 7});
    const std::size_t first = points.size();
    ASSERT_EQ(m.points.size(), first + 4);
    for (std::size_t i = first; i < first + 4; ++i) {
      EXPECT_TRUE(m.table.equal(PointId{5}, PointId{i}));
      EXPECT_TRUE(m.table.equal(PointId{first}, PointId{i}));
      EXPECT_TRUE(same_bits(m.table.rounded(PointId{i}), points[5]));
      EXPECT_TRUE(m.table.is_exact(PointId{i}));
      EXPECT_EQ(m.table.side(PointId{i}, PlaneId{0}), Sign::zero);
    }
  }
}

TEST(Constructions, FiltersDecideNearlyAllOfRandomInputAtAnyScale) {
  for (const int k : {-940, -600, -280, 0, 280, 600, 900}) {
    Random random(7);
    std::vector<Point3> points = floating(random, 60, 40, 0);
    scale(points, k);
    Model m(points);
    construct(m, random, 40);
    const TierCounts before = m.table.tier_counts();
    for (int i = 0; i < 10'000; ++i) m.table.side(m.point(random), m.plane(random));
    const TierCounts sides = m.table.tier_counts();
    EXPECT_EQ(sides.filter + sides.exact - before.filter - before.exact, 10'000U);
    EXPECT_LT(sides.exact - before.exact, 1'000U) << "scale 2^" << k;
    for (int i = 0; i < 10'000; ++i) m.table.turn(m.line(random), m.line(random), 0);
    for (int i = 0; i < 10'000; ++i) m.table.dot(m.plane(random), m.plane(random));
    const TierCounts directions = m.table.tier_counts();
    EXPECT_LT(directions.exact - sides.exact, 1'000U) << "scale 2^" << k;
    for (int i = 0; i < 10'000; ++i) {
      m.table.orientation(PointId{0}, m.explicit_point(random), m.explicit_point(random), m.explicit_point(random));
    }
    const TierCounts orientations = m.table.tier_counts();
    if (std::abs(k) <= 300) {
      EXPECT_LT(orientations.exact - directions.exact, 2'000U) << "scale 2^" << k;
    }
  }
}

TEST(Constructions, TrueZerosAreLeftToTheExactTier) {
  Constructions table(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  EXPECT_EQ(table.orientation(PointId{0}, PointId{1}, PointId{2}, PointId{3}), Sign::zero);
  EXPECT_EQ(table.tier_counts().exact, 1U);
  EXPECT_EQ(table.tier_counts().filter, 0U);
}

TEST(Constructions, RoundingTiesGoToEven) {
  // Middles of neighbouring doubles, made as weighted means: every one is a tie.
  Random random(8);
  for (int i = 0; i < 2'000; ++i) {
    const double x = static_cast<double>(random() >> 11) * std::ldexp(1, static_cast<int>(random() % 40) - 1070);
    const double above = std::nextafter(x, HUGE_VAL);
    Model m(std::vector<Point3>{{x, -x, 1}, {above, -above, 1}});
    m.make_point({PointId{0}, PointId{1}, PointId{0}}, {1, 1, 0});
    m.make_point({PointId{0}, PointId{1}, PointId{0}}, {524287, 524288, 0});
    SCOPED_TRACE(m.reproduce());
    ASSERT_NO_FATAL_FAILURE(check_points(m));
  }
}

TEST(Constructions, PointsBeyondTheRangeOfDoublesStayExact) {
  // Nearly parallel lines at 1e300 meet far beyond the largest double.
  Model m(std::vector<Point3>{{0, 0, 0}, {1e300, 0, 0}, {0, 1, 0}, {1e300, 1 + 0x1p-52, 0}, {0, 0, 1}, {1e300, 0, 1}});
  m.make_axis_plane(PointId{2}, PointId{3}, 2);
  m.make_axis_plane(PointId{0}, PointId{1}, 2);
  m.make_axis_plane(PointId{0}, PointId{2}, 2);
  m.make_point(PointId{0}, PointId{1}, PlaneId{0});
  m.make_point(PointId{4}, PointId{5}, PlaneId{0});
  SCOPED_TRACE(m.reproduce());
  ASSERT_NO_FATAL_FAILURE(check_points(m));
  EXPECT_EQ(m.table.rounded(PointId{6}).x, -HUGE_VAL);
  Random random(9);
  ASSERT_NO_FATAL_FAILURE(check_point_predicates(m, random, 200));
}

TEST(Constructions, NegativeZeroIsZero) {
  const Constructions table(std::vector<Point3>{{-0.0, 1, -0.0}});
  EXPECT_TRUE(same_bits(table.rounded(PointId{0}), {0, 1, 0}));
}

TEST(Constructions, RefusesCoordinatesThatAreNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    try {
      Constructions table(std::vector<Point3>{{0, 0, 0}, {0, bad, 0}});
      ADD_FAILURE() << bad;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("point 1"), std::string::npos);
    }
  }
}

TEST(Constructions, RefusesConstructionsThatDoNotExist) {
  for (const int b : {4, 31, 62, 125}) {
    std::vector<Point3> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1, 0}, {1, 2, 1}};
    if (b > 4) widen_grid(points, b);
    Constructions table(points);
    table.resize_planes(2);
    table.resize_lines(1);
    table.resize_points(points.size() + 1);
    const PointId point{points.size()};
    EXPECT_THROW(table.set_plane(PlaneId{0}, PointId{0}, PointId{1}, PointId{2}), InternalError);
    EXPECT_THROW(table.set_axis_plane(PlaneId{0}, PointId{0}, PointId{3}, 1), InternalError);
    EXPECT_THROW(table.set_line(LineId{0}, PointId{1}, PointId{1}), InternalError);
    table.set_plane(PlaneId{0}, PointId{0}, PointId{1}, PointId{3});
    table.set_plane(PlaneId{1}, PointId{0}, PointId{3}, PointId{1});
    EXPECT_THROW(table.set_line(LineId{0}, PlaneId{0}, PlaneId{1}), InternalError);
    EXPECT_THROW(table.set_point(point, PointId{3}, PointId{4}, PlaneId{0}), InternalError);
    EXPECT_THROW(table.set_point(point, PlaneId{0}, PlaneId{1}, PlaneId{0}), InternalError);
    EXPECT_THROW(table.exact(point), InternalError);
    const std::vector<PointId> wrong_order{point, PointId{0}};
    EXPECT_THROW(table.subset(wrong_order), InternalError);
  }
}

TEST(Constructions, DistinctSlotsMayBeSetFromSeveralThreads) {
  Random random(10);
  const std::vector<Point3> points = floating(random, 300, 25, 0);
  Constructions table(points);
  Constructions same(points);
  const std::size_t count = 100;
  for (Constructions* t : {&table, &same}) {
    t->resize_planes(count);
    t->resize_points(points.size() + count);
  }
  const auto fill = [&](Constructions& t, std::size_t begin, std::size_t step) {
    for (std::size_t i = begin; i < count; i += step) {
      t.set_plane(PlaneId{i}, PointId{3 * i}, PointId{3 * i + 1}, PointId{3 * i + 2});
      t.set_point(PointId{points.size() + i}, PointId{(3 * i + 3) % 300}, PointId{(3 * i + 4) % 300}, PlaneId{i});
      EXPECT_EQ(t.side(PointId{points.size() + i}, PlaneId{i}), Sign::zero);
    }
  };
  fill(same, 0, 1);
  std::thread first(fill, std::ref(table), 0, 2);
  std::thread second(fill, std::ref(table), 1, 2);
  first.join();
  second.join();
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_TRUE(same_bits(table.rounded(PointId{points.size() + i}), same.rounded(PointId{points.size() + i})));
  }
}

TEST(Constructions, TheEmptyTableAnswersCounts) {
  Constructions table{std::vector<Point3>{}};
  EXPECT_EQ(table.point_count(), 0U);
  EXPECT_EQ(table.explicit_count(), 0U);
  EXPECT_EQ(table.plane_count(), 0U);
  EXPECT_EQ(table.subset({}).point_count(), 0U);
}

}  // namespace
}  // namespace quoin
