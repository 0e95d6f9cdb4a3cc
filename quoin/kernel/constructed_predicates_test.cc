// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/constructed_filters.h"
#include "quoin/kernel/order.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/radial_order.h"
#include "quoin/kernel/test_constructions.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::Matrix;
using testing::Model;
using testing::Random;
using testing::Vector;
using testing::vector_of;

// ---- Points where a test wants them ----

/// A model with one constructed point at a third of each target, of every kind in turn: targets are integers times
/// 2^exponent. No double is a third of 1, so the rounded coordinates are not the exact ones.
///
/// A third of t lies on the line through a = t - 2b and b for any b, and on every plane through a and b.
class Thirds {
 public:
  Thirds(Random& random, std::vector<Point3> targets, int exponent, int most_offset)
      : targets_(std::move(targets)), model_(lines_through(random, targets_, exponent, most_offset)) {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      construct(i, static_cast<unsigned>(random() % 4));
    }
  }

  Model& model() { return model_; }
  const Constructions& table() const { return model_.table; }
  const Point3& target(std::size_t i) const { return targets_[i]; }
  std::size_t count() const { return targets_.size(); }
  PointId operator[](std::size_t i) const { return PointId{model_.table.explicit_count() + i}; }

 private:
  static constexpr std::size_t ends_per_target = 6;

  static std::vector<Point3> lines_through(Random& random, const std::vector<Point3>& targets, int exponent,
                                           int most_offset) {
    std::vector<Point3> ends;
    for (const Point3& target : targets) {
      for (std::size_t k = 0; k < ends_per_target / 2; ++k) {
        Point3 a;
        Point3 b;
        for (unsigned i = 0; i < 3; ++i) {
          const double x = testing::small_integer(random, most_offset);
          b[i] = std::ldexp(x, exponent);
          a[i] = std::ldexp(target[i] - 2 * x, exponent);
        }
        ends.push_back(a);
        ends.push_back(b);
      }
    }
    return ends;
  }

  void construct(std::size_t i, unsigned kind) {
    std::array<PointId, ends_per_target> e;
    for (std::size_t k = 0; k < ends_per_target; ++k) e[k] = PointId{ends_per_target * i + k};
    const std::size_t before = model_.points.size();
    const auto plane = [&](PointId a, PointId b, PointId c) {
      const std::size_t planes = model_.planes.size();
      model_.make_plane(a, b, c);
      return model_.planes.size() > planes;
    };
    const auto last = [&](std::size_t k) { return PlaneId{model_.planes.size() - k}; };
    if (kind == 0 && plane(e[2], e[3], e[4])) model_.make_point(e[0], e[1], last(1));
    if (kind == 1) model_.make_crossing(e[0], e[1], e[2], e[3], static_cast<unsigned>(i % 3));
    if (kind == 2 && plane(e[0], e[1], e[2]) && plane(e[2], e[3], e[4]) && plane(e[4], e[5], e[0])) {
      model_.make_point(last(1), last(2), last(3));
    }
    if (model_.points.size() == before) model_.make_point({e[0], e[1], e[1]}, {1, 1, 1});
  }

  std::vector<Point3> targets_;
  Model model_;
};

/// Three tiers at once: whatever the filter decides must be right; the answer must be right in any case.
::testing::AssertionResult agrees(Sign answer, int filtered, Sign expected) {
  if (answer != expected) {
    return ::testing::AssertionFailure() << "answer " << to_int(answer) << " instead of " << to_int(expected);
  }
  if (filtered != 0 && filtered != to_int(expected)) {
    return ::testing::AssertionFailure() << "the filter decided " << filtered << " instead of " << to_int(expected);
  }
  return ::testing::AssertionSuccess();
}

/// Determinant of the rows (p, 1) or (p, |p|^2, 1), of the chosen coordinates.
template <std::size_t N>
Sign sign_of_rows(const std::array<Vector, N>& points, const std::vector<unsigned>& axes, bool is_lifted) {
  Matrix rows;
  for (const Vector& p : points) {
    std::vector<Rational> row;
    Rational lift;
    for (const unsigned axis : axes) {
      row.push_back(p[axis]);
      lift += p[axis] * p[axis];
    }
    if (is_lifted) row.push_back(lift);
    row.emplace_back(1);
    rows.push_back(std::move(row));
  }
  return testing::determinant(rows).sign();
}

void check_predicates(const Model& m, const std::array<PointId, 5>& p, unsigned axis) {
  const Constructions& t = m.table;
  std::array<Vector, 5> v;
  std::array<Point3, 5> r;
  std::string names = "axis " + std::to_string(axis) + ", points";
  for (std::size_t k = 0; k < 5; ++k) {
    v[k] = m.at(p[k]);
    r[k] = t.rounded(p[k]);
    names += " " + std::to_string(p[k].value);
  }
  SCOPED_TRACE(names);
  const unsigned i = (axis + 1) % 3;
  const unsigned j = (axis + 2) % 3;
  const std::vector<unsigned> across{i, j};
  const std::vector<unsigned> all{0, 1, 2};
  ASSERT_TRUE(agrees(t.turn_any(p[0], p[1], p[2], axis), filter::turn_rounded(r[0], r[1], r[2], i, j),
                     sign_of_rows(std::array{v[0], v[1], v[2]}, across, false)));
  ASSERT_TRUE(agrees(t.orientation_any(p[0], p[1], p[2], p[3]), filter::orientation_rounded(r[0], r[1], r[2], r[3]),
                     -sign_of_rows(std::array{v[0], v[1], v[2], v[3]}, all, false)));
  ASSERT_TRUE(agrees(t.in_circle(p[0], p[1], p[2], p[3], axis), filter::in_circle_rounded(r[0], r[1], r[2], r[3], i, j),
                     sign_of_rows(std::array{v[0], v[1], v[2], v[3]}, across, true)));
  ASSERT_TRUE(agrees(t.in_sphere(p[0], p[1], p[2], p[3], p[4]), filter::in_sphere_rounded(r[0], r[1], r[2], r[3], r[4]),
                     -sign_of_rows(v, all, true)));
  const Sign order = v[0][0] != v[1][0]   ? (v[0][0] - v[1][0]).sign()
                     : v[0][1] != v[1][1] ? (v[0][1] - v[1][1]).sign()
                                          : (v[0][2] - v[1][2]).sign();
  ASSERT_EQ(t.compare_lexicographically(p[0], p[1]), order);
}

void check_along(const Model& m, LineId line, PointId p, PointId q) {
  SCOPED_TRACE("line " + std::to_string(line.value) + " points " + std::to_string(p.value) + " " +
               std::to_string(q.value));
  const Sign expected = testing::dot(m.at(line), testing::minus(m.at(p), m.at(q))).sign();
  ASSERT_EQ(m.table.compare_along(line, p, q), expected);
  ASSERT_EQ(m.table.compare_along(line, q, p), -expected);
}

/// Random calls, half of them on five points drawn from a few neighbours in the table.
void check_random_calls(const Model& m, Random& random, int count) {
  for (int i = 0; i < count; ++i) {
    const std::size_t first = random() % m.points.size();
    const bool is_near = random() % 2 == 0;
    std::array<PointId, 5> p;
    for (PointId& id : p) {
      id = is_near ? PointId{(first + random() % 6) % m.points.size()} : m.point(random);
    }
    ASSERT_NO_FATAL_FAILURE(check_predicates(m, p, static_cast<unsigned>(random() % 3)));
    if (m.lines.empty()) continue;
    ASSERT_NO_FATAL_FAILURE(check_along(m, m.line(random), p[0], p[1]));
  }
}

std::vector<Point3> near_grid(Random& random, int unit, int noise) {
  std::vector<Point3> targets = testing::grid3(2);
  for (Point3& p : targets) {
    for (unsigned i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], unit) + testing::small_integer(random, noise);
  }
  return targets;
}

// ---- Properties ----

using Integers = std::array<std::int64_t, 3>;

Integers difference(const Point3& p, const Point3& q) {
  return {static_cast<std::int64_t>(p.x - q.x), static_cast<std::int64_t>(p.y - q.y),
          static_cast<std::int64_t>(p.z - q.z)};
}
std::int64_t determinant(const Integers& a, const Integers& b, const Integers& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Point2 across(const Point3& p, unsigned axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

// All of 27^4 calls; what is exactly degenerate, and nothing else, is left to the exact tier.
TEST(ConstructedPredicates, OrientationAndCircleOnTheWholeGrid) {
  Random random(51);
  Thirds grid(random, testing::grid3(2), 0, 4);
  const std::size_t n = grid.count();
  std::uint64_t zeros = 0;
  for (std::size_t code = 0; code < n * n * n * n; ++code) {
    const std::array<std::size_t, 4> k{code % n, code / n % n, code / n / n % n, code / n / n / n};
    const Point3& a = grid.target(k[0]);
    const Point3& b = grid.target(k[1]);
    const Point3& c = grid.target(k[2]);
    const Point3& d = grid.target(k[3]);
    const Sign side = sign_of(determinant(difference(b, a), difference(c, a), difference(d, a)));
    ASSERT_EQ(grid.table().orientation_any(grid[k[0]], grid[k[1]], grid[k[2]], grid[k[3]]), side) << code;
    const auto axis = static_cast<unsigned>(code % 3);
    const Sign inside = in_circle(across(a, axis), across(b, axis), across(c, axis), across(d, axis));
    ASSERT_EQ(grid.table().in_circle(grid[k[0]], grid[k[1]], grid[k[2]], grid[k[3]], axis), inside) << code;
    zeros += static_cast<std::uint64_t>(side == Sign::zero) + static_cast<std::uint64_t>(inside == Sign::zero);
  }
  EXPECT_EQ(grid.table().tier_counts().exact, zeros);
  EXPECT_EQ(grid.table().tier_counts().filter, 2 * n * n * n * n - zeros);
}

TEST(ConstructedPredicates, SpheresTurnsAndOrdersOnTheWholeGrid) {
  Random random(52);
  Thirds grid(random, testing::grid3(2), 0, 4);
  const std::size_t n = grid.count();
  std::uint64_t zeros = 0;
  for (std::size_t a = 0; a < n; a += 3) {
    for (std::size_t b = 0; b < n; ++b) {
      ASSERT_EQ(grid.table().compare_lexicographically(grid[a], grid[b]),
                compare_lexicographically(grid.target(a), grid.target(b)));
      for (std::size_t c = b + 1; c < n; ++c) {
        for (unsigned axis = 0; axis < 3; ++axis) {
          const Sign turn =
              orientation(across(grid.target(a), axis), across(grid.target(b), axis), across(grid.target(c), axis));
          ASSERT_EQ(grid.table().turn_any(grid[a], grid[b], grid[c], axis), turn) << a << " " << b << " " << c;
        }
        for (std::size_t d = c + 1; d < n; ++d) {
          for (std::size_t e = d + 1; e < n; ++e) {
            const Sign inside =
                in_sphere(grid.target(a), grid.target(b), grid.target(c), grid.target(d), grid.target(e));
            ASSERT_EQ(grid.table().in_sphere(grid[a], grid[b], grid[c], grid[d], grid[e]), inside)
                << a << " " << b << " " << c << " " << d << " " << e;
            zeros += static_cast<std::uint64_t>(inside == Sign::zero);
          }
        }
      }
    }
  }
  EXPECT_GT(zeros, 10'000U);
}

// Grid points off by a few units in the last place, from subnormals to the largest doubles and around the limits of the
// filters.
TEST(ConstructedPredicates, NearlyDegeneratePointsOfAnySizeAgreeWithRationals) {
  for (const int k : {-1074, -1050, -1022, -660, -400, -330, -296, -264, -215, -180, -50, 0,   50,  84, 86,
                      87,    88,    89,    146,  147,  148,  149,  277,  278,  279,  280, 400, 600, 970}) {
    for (const int unit : {3, 24, 50}) {
      Random random(static_cast<std::uint64_t>(5000 + 3 * k + unit));
      SCOPED_TRACE("scale 2^" + std::to_string(k) + " unit 2^" + std::to_string(unit));
      Thirds points(random, near_grid(random, unit, unit == 3 ? 0 : 1), k, 1 << std::min(unit, 30));
      testing::construct(points.model(), random, 10);
      ASSERT_NO_FATAL_FAILURE(check_random_calls(points.model(), random, test_rounds(120)));
    }
  }
}

// The same about a point far from the origin, where rounding moves the points further than they differ.
TEST(ConstructedPredicates, ClustersFarFromTheOriginAgreeWithRationals) {
  for (const int shift : {8, 20, 40, 49}) {
    for (const unsigned axes : {1U, 2U, 4U, 6U, 7U}) {
      Random random(6000 + 8 * static_cast<std::uint64_t>(shift) + axes);
      SCOPED_TRACE("shift 2^" + std::to_string(shift) + " axes " + std::to_string(axes));
      std::vector<Point3> targets = testing::grid3(2);
      for (Point3& p : targets) {
        for (unsigned i = 0; i < 3; ++i) p[i] += ((axes >> i) & 1) != 0 ? std::ldexp(1.0, shift) : 0;
      }
      Thirds points(random, targets, 0, 2);
      ASSERT_NO_FATAL_FAILURE(check_random_calls(points.model(), random, test_rounds(200)));
    }
  }
}

TEST(ConstructedPredicates, FamiliesOfEveryClassAgreeWithRationals) {
  for (const int spread : {0, 5, 20, 70, 200, 900}) {
    Random random(static_cast<std::uint64_t>(7000 + spread));
    SCOPED_TRACE("spread " + std::to_string(spread));
    Model m(testing::floating(random, 12, 40, spread));
    testing::construct(m, random, 10);
    ASSERT_NO_FATAL_FAILURE(check_random_calls(m, random, test_rounds(150)));
  }
  for (const int b : {29, 30, 31, 60, 61, 62, 123, 124, 125}) {
    Random random(static_cast<std::uint64_t>(7100 + b));
    SCOPED_TRACE("b " + std::to_string(b));
    Model m(testing::at_limits(random, 12, b));
    testing::construct(m, random, 10);
    ASSERT_NO_FATAL_FAILURE(check_random_calls(m, random, test_rounds(150)));
  }
  for (const double most : {1e300, 0x1.fffffffffffffp1023}) {
    Random random(7200);
    Model m(std::vector<Point3>{
        {1e-300, 0, 0}, {most, 0, 1e-300}, {0, 1, most}, {1, most, 5e-324}, {0, 0, 1}, {most, 1, -most}});
    testing::construct(m, random, 10);
    ASSERT_NO_FATAL_FAILURE(check_random_calls(m, random, test_rounds(150)));
  }
}

TEST(ConstructedPredicates, RationalTablesAgreeWithRationals) {
  Random random(53);
  std::vector<RationalPoint3> points;
  for (const Point3& p : testing::small_grid(random, 14, 3)) {
    points.push_back({Rational(p.x) / Rational(3), Rational(p.y) / Rational(7), Rational(p.z) / Rational(3)});
  }
  Model m(points);
  testing::construct(m, random, 12);
  ASSERT_NO_FATAL_FAILURE(check_random_calls(m, random, 600));
}

// Coordinates so small that no filter decides anything: every call shows the exact tier.
TEST(ConstructedPredicates, TheExactTierAloneAgreesWithRationals) {
  Random random(54);
  Thirds points(random, near_grid(random, 6, 3), -1074, 20);
  testing::construct(points.model(), random, 5);
  const TierCounts before = points.table().tier_counts();
  for (int i = 0; i < 300; ++i) {
    std::array<PointId, 5> p;
    for (PointId& id : p) id = points[random() % points.count()];
    ASSERT_NO_FATAL_FAILURE(check_predicates(points.model(), p, static_cast<unsigned>(random() % 3)));
    ASSERT_NO_FATAL_FAILURE(check_along(points.model(), points.model().line(random), p[0], p[1]));
  }
  const TierCounts after = points.table().tier_counts();
  EXPECT_GE(after.exact - before.exact, 6U * 300);  // all but the lexicographic comparison
  EXPECT_LE(after.filter - before.filter, 300U);
}

TEST(ConstructedPredicates, TheFilterDecidesRandomPoints) {
  Random random(55);
  std::vector<Point3> targets(100);
  for (Point3& p : targets) {
    for (unsigned i = 0; i < 3; ++i) p[i] = static_cast<double>(random() >> 24);
  }
  Thirds points(random, targets, -40, 1 << 30);
  testing::construct(points.model(), random, 20);
  const Constructions& t = points.table();
  const LineId line{0};
  const TierCounts before = t.tier_counts();
  for (int i = 0; i < 10'000; ++i) {
    std::array<PointId, 5> p;
    for (std::size_t k = 0; k < 5; ++k) p[k] = points[20 * k + random() % 20];
    t.turn_any(p[0], p[1], p[2], 0);
    t.orientation_any(p[0], p[1], p[2], p[3]);
    t.in_circle(p[0], p[1], p[2], p[3], 1);
    t.in_sphere(p[0], p[1], p[2], p[3], p[4]);
    t.compare_lexicographically(p[0], p[1]);
    t.compare_along(line, p[0], p[1]);
  }
  const TierCounts after = t.tier_counts();
  EXPECT_EQ(after.filter + after.exact - before.filter - before.exact, 60'000U);
  EXPECT_LE(after.exact - before.exact, 10U);
}

TEST(ConstructedPredicates, SwappingTwoPointsNegates) {
  Random random(56);
  Thirds points(random, near_grid(random, 40, 1), -40, 1 << 30);
  const Constructions& t = points.table();
  for (int i = 0; i < 3'000; ++i) {
    std::array<PointId, 5> p;
    for (PointId& id : p) id = points.model().point(random);
    std::array<PointId, 5> q = p;
    const std::size_t k = random() % 3;
    std::swap(q[k], q[(k + 1) % 3]);
    ASSERT_EQ(t.turn_any(q[0], q[1], q[2], 2), -t.turn_any(p[0], p[1], p[2], 2));
    ASSERT_EQ(t.orientation_any(q[0], q[1], q[2], q[3]), -t.orientation_any(p[0], p[1], p[2], p[3]));
    ASSERT_EQ(t.in_circle(q[0], q[1], q[2], q[3], 0), -t.in_circle(p[0], p[1], p[2], p[3], 0));
    ASSERT_EQ(t.in_sphere(q[0], q[1], q[2], q[3], q[4]), -t.in_sphere(p[0], p[1], p[2], p[3], p[4]));
    std::swap(p[3], p[4]);
    ASSERT_EQ(t.in_sphere(p[0], p[1], p[2], p[3], p[4]), t.in_sphere(q[0], q[1], q[2], q[3], q[4]));
    ASSERT_EQ(t.compare_lexicographically(p[1], p[0]), -t.compare_lexicographically(p[0], p[1]));
  }
}

// Two points of one value, constructed differently, are interchangeable, and together with others they are degenerate.
TEST(ConstructedPredicates, DependOnValuesAlone) {
  Random random(57);
  std::vector<Point3> targets = testing::grid3(2);
  const std::size_t n = targets.size();
  for (std::size_t i = 0; i < n; ++i) targets.push_back(Point3(targets[i]));
  Thirds points(random, targets, 0, 9);
  const Constructions& t = points.table();
  for (int i = 0; i < 3'000; ++i) {
    std::array<PointId, 5> p;
    std::array<PointId, 5> q;
    for (std::size_t k = 0; k < 5; ++k) {
      const std::size_t target = random() % n;
      p[k] = points[target];
      q[k] = points[target + n];
    }
    ASSERT_EQ(t.compare_lexicographically(p[0], q[0]), Sign::zero);
    ASSERT_EQ(t.turn_any(p[0], q[0], p[1], 1), Sign::zero);
    ASSERT_EQ(t.orientation_any(p[0], p[1], p[2], q[2]), Sign::zero);
    ASSERT_EQ(t.in_circle(p[0], p[1], p[2], q[1], 1), Sign::zero);
    ASSERT_EQ(t.in_sphere(p[0], p[1], p[2], p[3], q[3]), Sign::zero);
    ASSERT_EQ(t.in_sphere(p[0], p[1], p[2], p[3], p[4]), t.in_sphere(q[0], q[1], q[2], q[3], q[4]));
    ASSERT_EQ(t.in_circle(p[0], p[1], p[2], p[3], 2), t.in_circle(q[0], q[1], q[2], q[3], 2));
  }
}

TEST(ConstructedPredicates, RadialOrderIsThatOfExplicitPoints) {
  Random random(58);
  Thirds points(random, testing::grid3(2), 0, 9);
  int refused = 0;
  int zeros = 0;
  for (int i = 0; i < 5'000; ++i) {
    std::array<std::size_t, 5> k;
    for (std::size_t& index : k) index = random() % points.count();
    const auto target = [&](std::size_t j) { return points.target(k[j]); };
    const auto point = [&](std::size_t j) { return points[k[j]]; };
    const auto of_table = [&] {
      return compare_radially(points.table(), point(0), point(1), point(2), point(3), point(4));
    };
    try {
      const Sign expected = compare_radially(target(0), target(1), target(2), target(3), target(4));
      zeros += static_cast<int>(expected == Sign::zero);
      ASSERT_EQ(of_table(), expected) << k[0] << " " << k[1] << " " << k[2] << " " << k[3] << " " << k[4];
    } catch (const InputError&) {
      ++refused;
      ASSERT_THROW(of_table(), InputError);
    }
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(refused, 100);
}

// Segments of a common plane cross in one point, whichever is named first and whichever axis is used.
TEST(ConstructedPredicates, CrossingsOfSegmentsInAPlane) {
  Random random(59);
  int crossings = 0;
  for (int i = 0; i < 2'000; ++i) {
    std::vector<Point3> corners = testing::small_grid(random, 4, 3);
    for (unsigned k = 0; k < 3; ++k) corners[3][k] = 3 * corners[0][k] + corners[1][k] - 3 * corners[2][k];
    Model m(corners);
    const std::array<PointId, 4> p{PointId{0}, PointId{1}, PointId{2}, PointId{3}};
    m.make_plane(p[0], p[1], p[2]);
    if (m.planes.empty()) continue;
    for (unsigned axis = 0; axis < 3; ++axis) {
      m.make_crossing(p[0], p[1], p[2], p[3], axis);
      m.make_crossing(p[2], p[3], p[1], p[0], axis);
    }
    for (std::size_t k = 4; k < m.points.size(); ++k) {
      ++crossings;
      SCOPED_TRACE(m.reproduce());
      ASSERT_TRUE(m.table.equal(PointId{k}, PointId{4}));
      ASSERT_EQ(m.table.exact(PointId{k}), testing::point_of(m.points[k]));
      ASSERT_EQ(m.table.side(PointId{k}, PlaneId{0}), Sign::zero);
      for (unsigned axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(m.table.turn_any(p[0], p[1], PointId{k}, axis), Sign::zero);
        ASSERT_EQ(m.table.turn_any(PointId{k}, p[2], p[3], axis), Sign::zero);
      }
    }
  }
  EXPECT_GT(crossings, 4'000);
  Constructions table(std::vector<Point3>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}});
  table.resize_points(5);
  EXPECT_THROW(table.set_crossing(PointId{4}, PointId{0}, PointId{1}, PointId{2}, PointId{3}, 2), InternalError);
}

}  // namespace
}  // namespace quoin
