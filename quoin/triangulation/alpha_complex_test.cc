// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/alpha_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/persistence.h"
#include "quoin/triangulation/alpha_shape.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/regular3.h"
#include "quoin/triangulation/test_clouds.h"
#include "quoin/triangulation/test_spheres.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;
using testing::SlowSpheres;
using testing::Subset;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

AlphaComplex alpha_of(const std::vector<Point3>& points) {
  return AlphaComplex(Delaunay3(points, context()), context());
}
AlphaComplex alpha_of(const std::vector<Point3>& points, const std::vector<double>& weights) {
  return AlphaComplex(Regular3(points, weights, context()), context());
}
AlphaComplex alpha_of(const std::vector<Point2>& points) {
  return AlphaComplex(Delaunay2(points, {}, context()), context());
}
AlphaComplex alpha_of(const std::vector<WeightedPoint2>& points) {
  return AlphaComplex(Regular2(points, context()), context());
}

template <class Visit>
void for_each_simplex(const AlphaComplex& alpha, const Visit& visit) {
  for (int k = 0; k <= alpha.dimension(); ++k) {
    for (std::uint32_t i = 0; i < alpha.complex().count(k); ++i) visit(SimplexId{k, i});
  }
}

/// Distinct points, of equal ones the heaviest weight; sorted.
struct Distinct {
  std::vector<Point3> points;
  std::vector<double> weights;

  Distinct(const std::vector<Point3>& all, const std::vector<double>& of_all) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return all[i] == all[j] ? of_all[i] > of_all[j] : lexicographically_less(all[i], all[j]);
    });
    for (const std::size_t i : order) {
      if (!points.empty() && points.back() == all[i]) continue;
      points.push_back(all[i]);
      weights.push_back(of_all[i]);
    }
  }
  std::uint32_t place(const Point3& p) const {
    return static_cast<std::uint32_t>(
        std::lower_bound(points.begin(), points.end(), p,
                         [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); }) -
        points.begin());
  }
};

void expect_by_definition(const AlphaComplex& alpha, const Distinct& input) {
  const SlowSpheres slow(input.points, input.weights);
  for_each_simplex(alpha, [&](SimplexId s) {
    Subset subset;
    for (const std::uint32_t v : alpha.complex().vertices(s)) subset.push_back(input.place(alpha.spheres().point(v)));
    std::sort(subset.begin(), subset.end());
    const std::optional<Rational> value = slow.value(subset);
    ASSERT_TRUE(value);
    ASSERT_EQ(alpha.exact_value(alpha.grade_of(s)), *value);
    ASSERT_EQ(alpha.is_gabriel(s), slow.has_empty_sphere(subset));
  });
}

/// Values ascend, doubles are nearest; faces come first; it ends as a convex set.
void expect_sound(const AlphaComplex& alpha) {
  for (std::uint32_t g = 0; g < alpha.grade_count(); ++g) {
    const Rational exact = alpha.exact_value(g);
    ASSERT_EQ(alpha.value(g), exact.to_double());
    ASSERT_EQ(alpha.grade_of(alpha.simplex_of_grade(g)), g);
    ASSERT_EQ(alpha.grades_up_to(exact), g + 1);
    if (g == 0) continue;
    ASSERT_LT(alpha.exact_value(g - 1), exact);
    ASSERT_EQ(alpha.grades_up_to((alpha.exact_value(g - 1) + exact) / Rational(2)), g);
  }
  for_each_simplex(alpha, [&](SimplexId s) {
    if (s.dimension == 0) return;
    for (const std::uint32_t f : alpha.complex().facets(s)) {
      ASSERT_LE(alpha.grade_of({s.dimension - 1, f}), alpha.grade_of(s));
    }
  });
  ASSERT_EQ(alpha.complex().euler_characteristic(), alpha.dimension() < 0 ? 0 : 1);
}

std::vector<double> weights_for(Random& random, const std::vector<Point3>& points) {
  std::vector<double> weights;
  double size = 0;
  for (const Point3& p : points) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double square = std::min(size * size, 0x1p1000);
  for (std::size_t i = 0; i < points.size(); ++i) weights.push_back(testing::small_integer(random, 3) / 8 * square);
  return weights;
}

/// Five, where rationals have thousands of bits.
std::size_t few_of(const Cloud& cloud) {
  double largest = 0;
  double least = 1;
  for (const Point3& p : cloud.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      largest = std::max(largest, std::fabs(p[axis]));
      if (p[axis] != 0) least = std::min(least, std::fabs(p[axis]));
    }
  }
  return std::min<std::size_t>(cloud.points.size(), largest > 1e50 && least < 1e-50 ? 5 : 8);
}

TEST(AlphaComplex, ValuesAreThoseOfTheirDefinition) {
  Random random(1);
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const Cloud& cloud : testing::clouds(random, 8)) {
      SCOPED_TRACE(cloud.name);
      const std::size_t count = few_of(cloud);
      const std::vector<Point3> points(cloud.points.begin(), cloud.points.begin() + static_cast<std::ptrdiff_t>(count));
      const AlphaComplex alpha = alpha_of(points);
      expect_sound(alpha);
      expect_by_definition(alpha, Distinct(points, std::vector<double>(points.size(), 0.0)));
      const std::vector<double> weights = weights_for(random, points);
      const AlphaComplex weighted = alpha_of(points, weights);
      expect_sound(weighted);
      expect_by_definition(weighted, Distinct(points, weights));
    }
  }
}

TEST(AlphaComplex, ValuesInThePlane) {
  Random random(2);
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const Cloud& cloud : testing::clouds(random, 8)) {
      SCOPED_TRACE(cloud.name);
      const std::size_t count = few_of(cloud);
      std::vector<Point3> in_space(cloud.points.begin(), cloud.points.begin() + static_cast<std::ptrdiff_t>(count));
      for (Point3& p : in_space) p.z = 0;
      const std::vector<double> weights = weights_for(random, in_space);
      std::vector<Point2> points;
      std::vector<WeightedPoint2> weighted_points;
      for (std::size_t i = 0; i < count; ++i) {
        points.push_back({in_space[i].x, in_space[i].y});
        weighted_points.push_back({points.back(), weights[i]});
      }
      const AlphaComplex alpha = alpha_of(points);
      expect_sound(alpha);
      expect_by_definition(alpha, Distinct(in_space, std::vector<double>(count, 0.0)));
      const AlphaComplex weighted = alpha_of(weighted_points);
      expect_sound(weighted);
      expect_by_definition(weighted, Distinct(in_space, weights));
    }
  }
}

/// Points of the plane, and the same in space: the same values, and as many simplices of each.
TEST(AlphaComplex, PlaneAndSpaceAgree) {
  Random random(9);
  for (const Cloud& cloud : testing::clouds(random, 60)) {
    SCOPED_TRACE(cloud.name);
    std::vector<Point2> plane;
    std::vector<Point3> space;
    for (const Point3& p : cloud.points) {
      plane.push_back({p.x, p.y});
      space.push_back({p.x, p.y, 0});
    }
    const AlphaComplex a = alpha_of(plane);
    const AlphaComplex b = alpha_of(space);
    ASSERT_EQ(a.dimension(), b.dimension());
    ASSERT_EQ(a.grade_count(), b.grade_count());
    for (std::uint32_t g = 0; g < a.grade_count(); ++g) ASSERT_EQ(a.exact_value(g), b.exact_value(g));
    for (int k = 0; k <= a.dimension(); ++k) {
      std::vector<std::uint32_t> of_a = a.filtration().grade[k];
      std::vector<std::uint32_t> of_b = b.filtration().grade[k];
      std::sort(of_a.begin(), of_a.end());
      std::sort(of_b.begin(), of_b.end());
      ASSERT_EQ(of_a, of_b);
    }
  }
}

TEST(AlphaComplex, ThreadsChangeNothing) {
  Random random(10);
  const Delaunay3 triangulation(testing::random_points(random, 2000, testing::unit), context());
  const AlphaComplex one(triangulation, context());
  const AlphaComplex four(triangulation, Context({.threads = 4}));
  EXPECT_EQ(one.filtration().grade, four.filtration().grade);
  EXPECT_EQ(one.order(context()), four.order(context()));
}

/// Homology at each value is that of the nerve of the balls, of all subsets of them with a common point.
void expect_nerve(const AlphaComplex& alpha, const Distinct& input) {
  const SlowSpheres slow(input.points, input.weights);
  SimplexList nerve;
  std::vector<Rational> meets;
  for (std::uint32_t mask = 1; mask < 1U << input.points.size(); ++mask) {
    Subset subset;
    for (std::uint32_t v = 0; v < input.points.size(); ++v) {
      if ((mask >> v & 1) != 0) subset.push_back(v);
    }
    if (subset.size() > 5) continue;
    nerve.add(subset);
    meets.push_back(slow.meeting(subset));
  }
  const Grades<Rational> grades = grades_of<Rational>(meets);
  const Filtration cech = filtration_of(nerve, grades.grade, context());
  const std::vector<PersistencePair> of_nerve = persistence(cech, {}, context());
  const std::vector<PersistencePair> of_alpha = persistence(alpha.filtration(), {}, context());
  for (std::uint32_t g = 0; g < alpha.grade_count(); ++g) {
    const Rational value = alpha.exact_value(g);
    const auto up_to = std::upper_bound(grades.values.begin(), grades.values.end(), value) - grades.values.begin();
    std::vector<std::size_t> expected = up_to == 0
                                            ? std::vector<std::size_t>{}
                                            : betti_numbers_at(cech, of_nerve, static_cast<std::uint32_t>(up_to - 1));
    std::vector<std::size_t> found = betti_numbers_at(alpha.filtration(), of_alpha, g);
    std::vector<std::size_t> again = betti_numbers(alpha_subcomplex(alpha, g + 1, context()), 2, context());
    // Simplices of five vertices have boundaries that nothing fills.
    expected.resize(4);
    found.resize(4);
    again.resize(4);
    ASSERT_EQ(found, expected) << "value " << value.to_string();
    ASSERT_EQ(found, again);
  }
}

TEST(AlphaComplex, HomologyIsThatOfTheBalls) {
  Random random(3);
  for (int round = 0; round < test_rounds(20); ++round) {
    const int size = 1 + static_cast<int>(random() % 4);
    std::vector<Point3> points;
    std::vector<double> weights;
    for (int i = 0; i < 7; ++i) {
      points.push_back({testing::small_integer(random, size), testing::small_integer(random, size),
                        round % 4 == 0 ? 0 : testing::small_integer(random, size)});
      weights.push_back(testing::small_integer(random, 2));
    }
    expect_nerve(alpha_of(points), Distinct(points, std::vector<double>(7, 0.0)));
    expect_nerve(alpha_of(points, weights), Distinct(points, weights));
  }
}

/// Betti numbers from each value on where they change.
using Jumps = std::vector<std::pair<Rational, std::vector<std::size_t>>>;

Jumps jumps_of(const AlphaComplex& alpha) {
  const std::vector<PersistencePair> pairs = persistence(alpha.filtration(), {}, context());
  Jumps jumps;
  for (std::uint32_t g = 0; g < alpha.grade_count(); ++g) {
    std::vector<std::size_t> betti = betti_numbers_at(alpha.filtration(), pairs, g);
    betti.resize(3);
    if (jumps.empty() || jumps.back().second != betti) jumps.emplace_back(alpha.exact_value(g), betti);
  }
  return jumps;
}

Rational ratio(int p, int q) {
  return Rational(Integer(p), Integer(q));
}

/// Section 3C of the notes on the flow complex: Rote, Vegter, and the flow complexes of Cazals, Parameswaran and Pion.
TEST(AlphaComplex, KnownJumps) {
  std::vector<Point3> cube = testing::lattice(2, 2, 2);
  for (Point3& p : cube) p = {2 * p.x, 2 * p.y, 2 * p.z};
  EXPECT_EQ(jumps_of(alpha_of(cube)), (Jumps{{0, {8, 0, 0}}, {1, {1, 5, 0}}, {2, {1, 0, 1}}, {3, {1, 0, 0}}}));
  std::vector<Point3> centred = cube;
  centred.push_back({1, 1, 1});
  EXPECT_EQ(jumps_of(alpha_of(centred)),
            (Jumps{{0, {9, 0, 0}}, {ratio(3, 4), {1, 0, 0}}, {1, {1, 12, 0}}, {ratio(9, 8), {1, 0, 0}}}));
  const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  EXPECT_EQ(jumps_of(alpha_of(octahedron)),
            (Jumps{{0, {6, 0, 0}}, {ratio(1, 2), {1, 7, 0}}, {ratio(2, 3), {1, 0, 1}}, {1, {1, 0, 0}}}));
  EXPECT_EQ(jumps_of(alpha_of(testing::lattice(3, 3, 3))),
            (Jumps{{0, {27, 0, 0}}, {ratio(1, 4), {1, 28, 0}}, {ratio(1, 2), {1, 0, 8}}, {ratio(3, 4), {1, 0, 0}}}));
  const std::vector<Point3> tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  EXPECT_EQ(jumps_of(alpha_of(tetrahedron)),
            (Jumps{{0, {4, 0, 0}}, {2, {1, 3, 0}}, {ratio(8, 3), {1, 0, 1}}, {3, {1, 0, 0}}}));
  EXPECT_EQ(jumps_of(alpha_of(testing::cospherical())),
            (Jumps{{0, {24, 0, 0}}, {ratio(1, 2), {1, 13, 0}}, {1, {1, 7, 0}}, {2, {1, 0, 1}}, {5, {1, 0, 0}}}));
  EXPECT_EQ(jumps_of(alpha_of(testing::lattice(1, 5, 1))), (Jumps{{0, {5, 0, 0}}, {ratio(1, 4), {1, 0, 0}}}));
  EXPECT_EQ(jumps_of(alpha_of(testing::lattice(4, 4, 1))),
            (Jumps{{0, {16, 0, 0}}, {ratio(1, 4), {1, 9, 0}}, {ratio(1, 2), {1, 0, 0}}}));
  EXPECT_EQ(jumps_of(alpha_of(std::vector<Point2>{{0, 0}, {3, 0}, {0, 4}})),
            (Jumps{{0, {3, 0, 0}}, {ratio(9, 4), {2, 0, 0}}, {4, {1, 0, 0}}}));
}

/// Everything about it, with coordinates times a factor.
struct Summary {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::uint32_t>> grade;
  std::vector<std::vector<std::uint32_t>> vertices;
  std::vector<SimplexId> order;
  std::vector<Rational> values;
  friend bool operator==(const Summary&, const Summary&) = default;
};

Summary summary_of(const AlphaComplex& alpha, double factor) {
  Summary s;
  for (std::uint32_t v = 0; v < alpha.spheres().size(); ++v) {
    const Point3& p = alpha.spheres().point(v);
    s.points.push_back({p.x * factor, p.y * factor, p.z * factor});
  }
  s.grade = alpha.filtration().grade;
  for_each_simplex(alpha, [&](SimplexId id) {
    const auto v = alpha.complex().vertices(id);
    s.vertices.emplace_back(v.begin(), v.end());
  });
  s.order = alpha.order(context());
  for (std::uint32_t g = 0; g < alpha.grade_count(); ++g) {
    s.values.push_back(alpha.exact_value(g) * Rational(factor) * Rational(factor));
  }
  return s;
}

TEST(AlphaComplex, OrderOfTheInputAndScaleChangeNothing) {
  Random random(4);
  for (const Cloud& cloud : testing::clouds(random, 40)) {
    SCOPED_TRACE(cloud.name);
    const Summary expected = summary_of(alpha_of(cloud.points), 1);
    std::vector<Point3> points = cloud.points;
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(summary_of(alpha_of(points), 1), expected);
    const double size = std::abs(points[0].x) + std::abs(points[1 % points.size()].y);
    if (size > 1e100 || size < 1e-20) continue;
    for (const double factor : {0x1p-3, 0x1p40, 0x1p300, 0x1p-250}) {
      std::vector<Point3> scaled;
      bool is_exact = true;
      for (const Point3& p : points) {
        scaled.push_back({p.x * factor, p.y * factor, p.z * factor});
        const Point3& q = scaled.back();
        is_exact = is_exact && Point3{q.x / factor, q.y / factor, q.z / factor} == p;
      }
      if (!is_exact) continue;
      EXPECT_EQ(summary_of(alpha_of(scaled), 1 / factor), expected) << factor;
    }
  }
}

/// Steps that compute nothing, but take long where there are many simplices, poll as often as others.
TEST(AlphaComplex, PollsAtEveryStepOfItsSimplices) {
  constexpr std::uint64_t unlimited = 1'000'000'000;
  Random random(12);
  const Delaunay3 triangulation(testing::random_points(random, 3000, testing::unit), context());
  const Context building({.threads = 1, .most_polls = unlimited});
  const AlphaComplex alpha(triangulation, building);
  const std::uint64_t size = alpha.complex().size();
  EXPECT_GT(building.polls(), 6 * size / 1024);
  const Context ordering({.threads = 1, .most_polls = unlimited});
  const std::vector<SimplexId> order = alpha.order(ordering);
  EXPECT_GT(ordering.polls(), 2 * size / 1024);
  for (std::uint64_t sixteenths = 0; sixteenths < 16; ++sixteenths) {
    EXPECT_THROW(AlphaComplex(triangulation, Context({.threads = 1, .most_polls = building.polls() * sixteenths / 16})),
                 Cancelled);
    EXPECT_THROW(alpha.order(Context({.threads = 1, .most_polls = ordering.polls() * sixteenths / 16})), Cancelled);
  }
  EXPECT_EQ(alpha.order(context()), order);
}

TEST(AlphaComplex, OrderIsByValueThenDimensionThenVertices) {
  Random random(5);
  for (const Cloud& cloud : testing::clouds(random, 30)) {
    SCOPED_TRACE(cloud.name);
    const AlphaComplex alpha = alpha_of(cloud.points);
    const std::vector<SimplexId> order = alpha.order(context());
    ASSERT_EQ(order.size(), alpha.complex().size());
    for (std::size_t i = 1; i < order.size(); ++i) {
      const auto key = [&](SimplexId s) { return std::tuple(alpha.grade_of(s), s.dimension, s.index); };
      ASSERT_LT(key(order[i - 1]), key(order[i]));
    }
  }
}

/// Points of one sphere, up to rounding: all cells have almost the same value. Of a lattice in tenths.
TEST(AlphaComplex, ManyValuesThatAreAlmostEqual) {
  Random random(6);
  std::vector<Point3> tenths;
  for (const Point3& p : testing::lattice(7, 6, 5)) tenths.push_back({0.1 * p.x, 0.1 * p.y, 0.1 * p.z});
  const std::vector<Point3> fewer(tenths.begin(), tenths.begin() + 120);
  for (const auto& points : {testing::near_sphere(random, 150), tenths, fewer}) {
    const AlphaComplex alpha = alpha_of(points);
    expect_sound(alpha);
    for_each_simplex(alpha, [&](SimplexId s) {
      if (!alpha.is_gabriel(s)) return;
      const Rational own = alpha.spheres().exact_power(alpha.complex().vertices(s)).rational();
      ASSERT_EQ(own, alpha.exact_value(alpha.grade_of(s)));
    });
  }
  const AlphaComplex lattice = alpha_of(testing::lattice(8, 8, 8));
  ASSERT_EQ(lattice.grade_count(), 4U);
  EXPECT_EQ(lattice.value(1), 0.25);
  EXPECT_EQ(lattice.value(3), 0.75);
}

TEST(AlphaComplex, PlacesInTheShape) {
  Random random(7);
  for (const Cloud& cloud : testing::clouds(random, 20)) {
    SCOPED_TRACE(cloud.name);
    const AlphaComplex alpha = alpha_of(cloud.points);
    const AlphaIntervals intervals(alpha, context());
    const SimplicialComplex& complex = alpha.complex();
    for (const std::uint32_t grades : {0U, 1U, alpha.grade_count() / 2, alpha.grade_count()}) {
      const AlphaShape shape = alpha_shape(alpha, intervals, grades, context());
      std::size_t inside = 0;
      for_each_simplex(alpha, [&](SimplexId s) {
        const bool is_in = alpha.grade_of(s) < grades;
        inside += is_in ? 1 : 0;
        bool has_coface = false;
        bool is_surrounded = true;
        std::size_t sides = 0;
        for_each_simplex(alpha, [&](SimplexId t) {
          if (t.dimension <= s.dimension || !std::includes(complex.vertices(t).begin(), complex.vertices(t).end(),
                                                           complex.vertices(s).begin(), complex.vertices(s).end()))
            return;
          has_coface = has_coface || alpha.grade_of(t) < grades;
          is_surrounded = is_surrounded && alpha.grade_of(t) < grades;
          // On the hull is what is in a facet with one cell.
          if (t.dimension + 1 == alpha.dimension()) {
            const SimplexIncidence cells = complex.cofacets(t.dimension);
            is_surrounded = is_surrounded && cells[t.index].size() == 2;
          }
          if (t.dimension == alpha.dimension()) ++sides;
        });
        if (s.dimension + 1 == alpha.dimension()) is_surrounded = is_surrounded && sides == 2;
        const AlphaPlace expected = !is_in                                              ? AlphaPlace::outside
                                    : s.dimension == alpha.dimension() || is_surrounded ? AlphaPlace::interior
                                    : has_coface                                        ? AlphaPlace::regular
                                                                                        : AlphaPlace::singular;
        ASSERT_EQ(intervals.of(s).place(grades), expected);
      });
      ASSERT_EQ(shape.singular.size() + shape.regular.size() + shape.interior.size(), inside);
    }
  }
}

TEST(AlphaComplex, FewPointsAndBadValues) {
  EXPECT_EQ(alpha_of(std::vector<Point2>{}).dimension(), -1);
  EXPECT_EQ(alpha_of(std::vector<Point2>{}).grade_count(), 0U);
  EXPECT_EQ(alpha_of(std::vector<WeightedPoint2>{}).dimension(), -1);
  const AlphaComplex one = alpha_of(std::vector<Point3>{{1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(one.dimension(), 0);
  EXPECT_EQ(one.grades_up_to(0.0), 1U);
  EXPECT_EQ(one.grades_up_to(-1e-300), 0U);
  EXPECT_EQ(one.grades_up_to(std::numeric_limits<double>::infinity()), 1U);
  EXPECT_EQ(one.grades_up_to(-std::numeric_limits<double>::infinity()), 0U);
  EXPECT_THROW(one.grades_up_to(std::numeric_limits<double>::quiet_NaN()), InputError);
  const AlphaComplex heavy = alpha_of(std::vector<Point3>{{1, 2, 3}}, {2.5});
  EXPECT_EQ(heavy.exact_value(0), Rational(-2.5));
  EXPECT_THROW(alpha_of(std::vector<Point3>{{1, 2, std::numeric_limits<double>::infinity()}}), InputError);

  Random random(8);
  const Delaunay3 triangulation(testing::random_points(random, 50, testing::unit), context());
  Context cancelled({.threads = 1});
  cancelled.cancel();
  EXPECT_THROW(AlphaComplex(triangulation, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
