// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/flat_location.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/delaunay_location.h"
#include "quoin/triangulation/test_flat_clouds.h"
#include "quoin/triangulation/test_power_cells.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::flat_clouds;
using testing::Random;
using Kind = DelaunayLocation::Kind;

const Context& alone() {
  static const Context context({.threads = 1});
  return context;
}

std::string text_of(const std::vector<Point3>& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Point3& p : points) out << "{" << p.x << ", " << p.y << ", " << p.z << "}, ";
  return out.str();
}

/// In and around the convex hull, exactly in the plane or on the line where the coordinates allow it, and beside it.
std::vector<Point3> queries_about(Random& random, const std::vector<Point3>& points, int rounds = 8) {
  std::vector<Point3> queries;
  const auto any = [&]() -> const Point3& { return points[random() % points.size()]; };
  for (int round = 0; round < test_rounds(rounds); ++round) {
    const Point3& a = any();
    const Point3& b = any();
    const Point3& c = any();
    queries.push_back(a);
    const auto combine = [&](double s, double t) {
      Point3 q;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        q[axis] = a[axis] + (b[axis] - a[axis]) * s + (c[axis] - a[axis]) * t;
        if (!std::isfinite(q[axis])) q[axis] = a[axis];
      }
      return q;
    };
    queries.push_back(combine(0.5, 0));
    queries.push_back(combine(0.25, 0.5));
    queries.push_back(combine(0.25, 0.25));
    queries.push_back(combine(2, -1));
    queries.push_back(combine(-1, static_cast<double>(random() % 3)));
    Point3 beside = queries[queries.size() - 1 - random() % 6];
    double& x = beside[random() % 3];
    x = std::nextafter(x, random() % 2 == 0 ? 1e308 : -1e308);
    queries.push_back(beside);
  }
  queries.push_back({0, 0, 0});
  return queries;
}

bool is_zero(const RationalPoint3& v) {
  return v == RationalPoint3{};
}

/// Of points of which some are given: whether a point is in their affine hull.
class AffineHull {
 public:
  explicit AffineHull(const std::vector<Point3>& points) : origin_(exact_point(points[0])) {
    for (const Point3& p : points) {
      const RationalPoint3 way = exact_point(p) - origin_;
      if (is_zero(way)) continue;
      if (is_zero(first_)) first_ = way;
      if (is_zero(normal_)) normal_ = cross(first_, way);
    }
  }
  bool holds(const Point3& p) const {
    const RationalPoint3 way = exact_point(p) - origin_;
    if (is_zero(first_)) return is_zero(way);
    if (is_zero(normal_)) return is_zero(cross(first_, way));
    return dot(normal_, way).sign() == Sign::zero;
  }

 private:
  RationalPoint3 origin_;
  RationalPoint3 first_;
  RationalPoint3 normal_;
};

/// Signs of the barycentric coordinates of a point of the affine hull of one to three points.
std::vector<Sign> coordinate_signs(const std::vector<RationalPoint3>& simplex, const RationalPoint3& p) {
  if (simplex.size() == 1) return {Sign::positive};
  if (simplex.size() == 2) {
    const RationalPoint3 way = simplex[1] - simplex[0];
    return {dot(simplex[1] - p, way).sign(), dot(p - simplex[0], way).sign()};
  }
  const RationalPoint3 normal = cross(simplex[1] - simplex[0], simplex[2] - simplex[0]);
  std::vector<Sign> signs;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint3& a = simplex[(i + 1) % 3];
    signs.push_back(dot(normal, cross(simplex[(i + 2) % 3] - a, p - a)).sign());
  }
  return signs;
}

template <class Triangulation>
std::vector<RationalPoint3> corners_of(const Triangulation& t, std::uint32_t cell) {
  std::vector<RationalPoint3> corners;
  for (int i = 0; i <= t.dimension(); ++i) {
    const std::uint32_t v = t.cells()[cell].vertices[static_cast<std::size_t>(i)];
    if (v != vertex_at_infinity) corners.push_back(exact_point(t.point(v)));
  }
  return corners;
}

/// The vertices of the face, by their points.
template <class Triangulation>
std::vector<Point3> face_points(const Triangulation& t, const DelaunayLocation& found) {
  std::vector<Point3> points;
  for (unsigned i = 0; i < 4; ++i) {
    if ((found.slots >> i & 1) != 0) points.push_back(t.point(t.cells()[found.cell].vertices[i]));
  }
  std::ranges::sort(points, [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); });
  return points;
}

/// The same by the numbers of points that are given, which are distinct.
std::set<std::uint32_t> face_inputs(const Delaunay3& t, const DelaunayLocation& found) {
  std::set<std::uint32_t> inputs;
  for (unsigned i = 0; i < 4; ++i) {
    if ((found.slots >> i & 1) != 0) inputs.insert(t.inputs(t.cells()[found.cell].vertices[i])[0]);
  }
  return inputs;
}

/// By the barycentric coordinates of all cells.
template <class Triangulation>
void expect_found(const Triangulation& t, const AffineHull& hull, const Point3& p, const DelaunayLocation& found) {
  const auto d = static_cast<unsigned>(t.dimension());
  ASSERT_EQ(found.kind == Kind::outside_affine_hull, !hull.holds(p));
  if (found.kind == Kind::outside_affine_hull) {
    ASSERT_EQ(found.slots, 0U);
    return;
  }
  const RationalPoint3 q = exact_point(p);
  bool is_in_cell = false;
  for (std::uint32_t c = 0; c < t.cells().size(); ++c) {
    if (t.is_ghost(c)) continue;
    const std::vector<Sign> signs = coordinate_signs(corners_of(t, c), q);
    if (std::ranges::count(signs, Sign::negative) > 0) continue;
    is_in_cell = true;
    unsigned slots = 0;
    for (unsigned i = 0; i < signs.size(); ++i) slots |= signs[i] == Sign::positive ? 1U << i : 0;
    ASSERT_EQ(face_points(t, found), face_points(t, {Kind::vertex, c, slots}));
    ASSERT_EQ(static_cast<int>(found.kind), std::ranges::count(signs, Sign::positive) - 1);
  }
  ASSERT_EQ(found.kind == Kind::outside, !is_in_cell);
  ASSERT_EQ(t.is_ghost(found.cell), !is_in_cell);
  if (is_in_cell) return;
  ASSERT_EQ(found.slots, (1U << d) - 1);
  const std::uint32_t mate = t.cells()[found.cell].neighbours[d];
  ASSERT_EQ(coordinate_signs(corners_of(t, mate >> 2), q)[mate & 3], Sign::negative);
}

template <class Triangulation>
double weight_of(const Triangulation& t, std::uint32_t v) {
  if constexpr (std::is_same_v<Triangulation, Regular3>) return t.weight(v);
  return 0;
}

template <class Triangulation>
std::uint32_t nearest_by_all(const Triangulation& t, const Point3& p) {
  std::uint32_t best = no_vertex;
  Rational least;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    if constexpr (std::is_same_v<Triangulation, Regular3>) {
      if (t.is_hidden(v)) continue;
    }
    const Rational power = testing::power(exact_point(p), t.point(v), weight_of(t, v));
    if (best != no_vertex && !(power < least)) continue;
    best = v;
    least = power;
  }
  return best;
}

template <class Triangulation>
void expect_all_found(Random& random, const Triangulation& t, const std::vector<Point3>& points) {
  const AffineHull hull(points);
  const DelaunayLocator locator(t);
  for (const Point3& p : queries_about(random, points)) {
    SCOPED_TRACE("query " + text_of({p}));
    const auto start = static_cast<std::uint32_t>(random() % t.cells().size());
    expect_found(t, hull, p, random() % 2 == 0 ? locator.locate(p) : locator.locate(p, start));
    ASSERT_EQ(locator.nearest(p), nearest_by_all(t, p));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(FlatLocation, FacesAndNearestOfFlatPoints) {
  Random random(61);
  std::array<int, 6> kinds{};
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const Cloud& cloud : flat_clouds(random, 14)) {
      SCOPED_TRACE(cloud.name + ": " + text_of(cloud.points));
      for (const bool is_canonical : {false, true}) {
        const Delaunay3 t(cloud.points, alone(), {.is_canonical = is_canonical});
        ASSERT_LT(t.dimension(), 3);
        expect_all_found(random, t, cloud.points);
        if (HasFatalFailure()) return;
        const DelaunayLocator locator(t);
        for (const Point3& p : queries_about(random, cloud.points))
          ++kinds[static_cast<unsigned>(locator.locate(p).kind)];
      }
    }
  }
  for (const Kind kind : {Kind::vertex, Kind::edge, Kind::facet, Kind::outside, Kind::outside_affine_hull})
    EXPECT_GT(kinds[static_cast<unsigned>(kind)], test_cases(50)) << static_cast<int>(kind);
}

TEST(FlatLocation, FacesAndNearestOfWeightedFlatPoints) {
  Random random(62);
  bool is_any_hidden = false;
  for (const Cloud& cloud : flat_clouds(random, 12)) {
    for (const testing::WeightFamily& family : testing::weight_families()) {
      std::vector<double> weights;
      for (const Point3& p : cloud.points) weights.push_back(family.weight(random, p.x * p.x + p.y * p.y + p.z * p.z));
      std::ostringstream trace;
      trace << cloud.name << ", " << family.name << ": " << text_of(cloud.points) << " weights " << std::hexfloat;
      for (const double w : weights) trace << w << ", ";
      SCOPED_TRACE(trace.str());
      const Regular3 t(cloud.points, weights, alone());
      expect_all_found(random, t, cloud.points);
      for (std::uint32_t v = 0; v < t.vertex_count(); ++v) is_any_hidden |= t.is_hidden(v);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_TRUE(is_any_hidden);
}

/// Answers follow from the set of points, whatever their order.
TEST(FlatLocation, OrderOfPointsIsNotSeen) {
  Random random(63);
  for (const Cloud& cloud : flat_clouds(random, 5)) {
    std::vector<Point3> points(cloud.points.begin(),
                               cloud.points.begin() + std::min<std::ptrdiff_t>(5, std::ssize(cloud.points)));
    SCOPED_TRACE(cloud.name + ": " + text_of(points));
    const std::vector<Point3> queries = queries_about(random, points, 4);
    const Delaunay3 expected(points, alone());
    const DelaunayLocator expected_locator(expected);
    std::ranges::sort(points, [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); });
    do {
      const Delaunay3 t(points, alone());
      const DelaunayLocator locator(t);
      for (const Point3& p : queries) {
        const DelaunayLocation one = expected_locator.locate(p);
        const DelaunayLocation other = locator.locate(p, static_cast<std::uint32_t>(random() % t.cells().size()));
        ASSERT_EQ(one.kind, other.kind);
        if (one.kind < Kind::outside) {
          ASSERT_EQ(face_points(expected, one), face_points(t, other));
        }
        ASSERT_EQ(t.point(locator.nearest(p)), expected.point(expected_locator.nearest(p)));
      }
    } while (std::next_permutation(points.begin(), points.end(),
                                   [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); }));
  }
}

/// Of points without ties, so that nothing depends on coordinates: what moves with them is found where it was.
TEST(FlatLocation, MovesWithThePoints) {
  Random random(64);
  int inside = 0;
  for (int round = 0; round < test_rounds(40); ++round) {
    // No four of a parabola's points with x > 0 are on one circle.
    std::vector<Point3> points;
    for (double x = 1; x < 9; ++x) points.push_back({x, x * x, round % 2 == 0 ? 0 : x + x * x});
    std::ranges::shuffle(points, random);
    const testing::IntegerMotion motion(random);
    std::vector<Point3> moved;
    for (const Point3& p : points) moved.push_back(motion(p));
    const Delaunay3 t(points, alone());
    const Delaunay3 u(moved, alone());
    ASSERT_EQ(u.dimension(), 2);
    const DelaunayLocator locator(t);
    const DelaunayLocator moved_locator(u);
    for (const Point3& p : queries_about(random, points)) {
      if (p.x * 4 != std::floor(p.x * 4) || p.y * 4 != std::floor(p.y * 4) || p.z * 4 != std::floor(p.z * 4)) continue;
      const DelaunayLocation found = locator.locate(p);
      const DelaunayLocation found_moved = moved_locator.locate(motion(p));
      ASSERT_EQ(found.kind, found_moved.kind) << text_of({p});
      if (found.kind >= Kind::outside) continue;  // several facets may see it
      ASSERT_EQ(face_inputs(t, found), face_inputs(u, found_moved)) << text_of({p});
      ++inside;
    }
  }
  EXPECT_GT(inside, test_cases(500));
}

/// One point by one unit in the last place off the plane of the others.
TEST(FlatLocation, AlmostFlatPointsAreOfDimensionThree) {
  Random random(65);
  int found_flat = 0;
  for (int round = 0; round < test_rounds(6); ++round) {
    for (const Cloud& cloud : flat_clouds(random, 10)) {
      if (Delaunay3(cloud.points, alone()).dimension() < 2) continue;
      std::vector<Point3> points = cloud.points;
      double& x = points[random() % points.size()][random() % 3];
      x = std::nextafter(x, random() % 2 == 0 ? 1e308 : -1e308);
      SCOPED_TRACE(cloud.name + ": " + text_of(points));
      const Delaunay3 t(points, alone());
      const DelaunayLocator locator(t);
      if (t.dimension() < 3) {
        ++found_flat;
        expect_all_found(random, t, points);
        if (HasFatalFailure()) return;
        continue;
      }
      for (const Point3& p : queries_about(random, points)) {
        ASSERT_EQ(locator.nearest(p), nearest_by_all(t, p));
        const DelaunayLocation found = locator.locate(p);
        ASSERT_NE(found.kind, Kind::outside_affine_hull);
        if (std::ranges::count(points, p) > 0) {
          ASSERT_EQ(found.kind, Kind::vertex);
        }
      }
    }
  }
  EXPECT_LT(found_flat, test_rounds(6) * 8);
}

/// Over a lattice of a plane, whose shortest steps are edges, and a line of as many points, from end to end.
TEST(FlatLocation, FindsTheWayThroughManyPoints) {
  for (const std::size_t length : {std::size_t{120}, std::size_t{14400}}) {
    const std::size_t width = 14400 / length;
    std::vector<Point3> points;
    for (std::size_t k = 0; k < 14400; ++k) {
      const auto i = static_cast<double>(k % length);
      const auto j = static_cast<double>(k / length);
      points.push_back({i + j, 2 * j - i, j + 3 * i});
    }
    const Delaunay3 t(points, alone());
    ASSERT_EQ(t.dimension(), width > 1 ? 2 : 1);
    const DelaunayLocator locator(t);
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < points.size(); i += 7) {
      const std::size_t k = i * 613 % points.size();
      const Point3& p = points[k];
      DelaunayLocation found = locator.locate(p, at);
      ASSERT_EQ(face_points(t, found), std::vector<Point3>{p});
      const Point3 beside{p.x + 0.25, p.y - 0.25, p.z + 0.75};  // a quarter of a step on
      ASSERT_EQ(t.point(locator.nearest(beside)), p);
      found = locator.locate(beside, at);
      at = found.cell;
      const bool is_last = k % length == length - 1;
      ASSERT_EQ(found.kind, is_last ? Kind::outside : Kind::edge);
      if (!is_last) {
        ASSERT_EQ(face_points(t, found), (std::vector<Point3>{p, points[k + 1]}));
      }
    }
  }
}

TEST(FlatLocation, OnePoint) {
  const std::vector<Point3> points(3, Point3{1, -2, 0.5});
  const Delaunay3 t(points, alone());
  const DelaunayLocator locator(t);
  const DelaunayLocation found = locator.locate(points[0], 1);
  EXPECT_EQ(found.kind, Kind::vertex);
  EXPECT_EQ(found.slots, 1U);
  EXPECT_EQ(t.cells()[found.cell].vertices[0], 0U);
  EXPECT_EQ(locator.locate({1, -2, std::nextafter(0.5, 1)}).kind, Kind::outside_affine_hull);
  EXPECT_EQ(locator.nearest({1e308, -1e308, 1e308}), 0U);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(locator.locate({0, bad, 0}), InputError);
    EXPECT_THROW(locator.nearest({0, 0, bad}), InputError);
  }
}

}  // namespace
}  // namespace quoin
