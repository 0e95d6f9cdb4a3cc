// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/test_flat_clouds.h"
#include "quoin/triangulation/test_power_cells.h"
#include "quoin/triangulation/voronoi.h"
#include "quoin/triangulation/voronoi2.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::flat_clouds;
using testing::Random;

const Context& plain_context() {
  static const Context context({.threads = 1});
  return context;
}

/// An interval of a line; without an end it is infinite there.
struct Interval {
  std::optional<Rational> low;
  std::optional<Rational> high;
  bool is_empty = false;

  /// Where at_zero + x slope is not negative.
  void clip(const Rational& at_zero, const Rational& slope) {
    if (slope.sign() == Sign::zero) {
      is_empty = is_empty || at_zero.sign() == Sign::negative;
      return;
    }
    const Rational end = -at_zero / slope;
    if (slope.sign() == Sign::positive && (!low || *low < end)) low = end;
    if (slope.sign() == Sign::negative && (!high || end < *high)) high = end;
  }
  bool has_length() const { return !is_empty && (!low || !high || *low < *high); }
};

/// Sections of facets with the plane or line of the points, by their definition.
class FlatFacets {
 public:
  explicit FlatFacets(const TriangulationView3& t) : t_(t) {
    if (t.dimension() < 2) return;
    std::size_t cell = 0;
    while (t.is_ghost(cell)) ++cell;
    const auto& v = t.cells()[cell].vertices;
    normal_ = cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]));
  }

  /// What is as near to v as to w and to none nearer, and its ends in order counterclockwise about v, as triangles
  /// turn; nothing where it has no length, or of points of a line is not there.
  std::optional<std::vector<RationalPoint3>> ends(std::uint32_t v, std::uint32_t w) const {
    const RationalPoint3 way = at(w) - at(v);
    const Rational square = dot(way, way);
    const Rational lift = square - (Rational(t_.weight(w)) - Rational(t_.weight(v)));
    const RationalPoint3 middle = at(v) + way * (lift / (Rational(2) * square));
    const RationalPoint3 along = cross(normal_, way);
    Interval interval;
    for (std::uint32_t u = 0; u < t_.vertex_count(); ++u) {
      if (u == v || u == w) continue;
      const Rational at_zero = excess(u, v, middle);
      interval.clip(at_zero, excess(u, v, middle + along) - at_zero);
    }
    if (!interval.has_length()) return std::nullopt;
    if (t_.dimension() == 1) return std::vector{middle};
    std::vector<RationalPoint3> found;
    if (interval.low) found.push_back(middle + along * *interval.low);
    if (interval.high) found.push_back(middle + along * *interval.high);
    return found;
  }

 private:
  RationalPoint3 at(std::uint32_t v) const { return exact_point(t_.point(v)); }
  Rational excess(std::uint32_t u, std::uint32_t v, const RationalPoint3& x) const {
    return testing::power(x, t_.point(u), t_.weight(u)) - testing::power(x, t_.point(v), t_.weight(v));
  }

  TriangulationView3 t_;
  RationalPoint3 normal_;
};

/// The square of the area of a polygon about a point, or of a length, by the ends of its sides.
Rational square_of(int dimension, const RationalPoint3& apex, const std::vector<std::vector<RationalPoint3>>& sides) {
  if (dimension == 1) return dot(sides[1][0] - sides[0][0], sides[1][0] - sides[0][0]);
  RationalPoint3 twice;
  for (const auto& side : sides) twice = twice + cross(side[0] - apex, side[1] - apex);
  return dot(twice, twice) / Rational(4);
}

void expect_facets(const TriangulationView3& t, const Voronoi3& voronoi) {
  const FlatFacets expected(t);
  ASSERT_EQ(voronoi.dimension(), t.dimension());
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    const std::vector<VoronoiFacet> facets = voronoi.facets(v);
    ASSERT_EQ(voronoi.is_unbounded(v), voronoi.has_cell(v));
    ASSERT_EQ(voronoi.volume(v), voronoi.has_cell(v) ? std::nullopt : std::optional(Rational()));
    std::size_t next = 0;
    std::vector<std::vector<RationalPoint3>> sides;
    for (std::uint32_t w = 0; w < t.vertex_count(); ++w) {
      if (w == v || !voronoi.has_cell(v) || !voronoi.has_cell(w)) continue;
      const auto ends = expected.ends(v, w);
      if (!ends) continue;
      ASSERT_LT(next, facets.size());
      ASSERT_EQ(facets[next].neighbour, w) << "of " << v;
      ASSERT_FALSE(facets[next].is_bounded);
      ASSERT_EQ(facets[next].corners, *ends) << v << " and " << w;
      ASSERT_EQ(facets[next].cells.size(), ends->size());
      for (std::size_t i = 0; i < ends->size(); ++i) {
        ASSERT_EQ(voronoi.corner(facets[next].cells[i]), (*ends)[i]);
      }
      sides.push_back(*ends);
      ++next;
    }
    ASSERT_EQ(next, facets.size());
    if (!voronoi.has_cell(v) || t.dimension() == 0) {
      ASSERT_EQ(voronoi.squared_section(v), Rational(voronoi.has_cell(v) ? 1 : 0));
      continue;
    }
    const bool is_bounded = t.dimension() == 1
                                ? sides.size() == 2
                                : std::ranges::all_of(sides, [](const auto& side) { return side.size() == 2; });
    ASSERT_EQ(voronoi.squared_section(v).has_value(), is_bounded);
    if (is_bounded) {
      ASSERT_EQ(*voronoi.squared_section(v), square_of(t.dimension(), exact_point(t.point(v)), sides));
      ASSERT_EQ(voronoi.squared_section(v)->sign(), Sign::positive);
    }
  }
}

TEST(FlatVoronoi, FacetsAreThoseOfTheirDefinition) {
  Random random(71);
  for (const Cloud& cloud : flat_clouds(random, 12)) {
    for (const bool is_canonical : {false, true}) {
      const Delaunay3 t(cloud.points, plain_context(), {.is_canonical = is_canonical});
      std::ostringstream trace;
      trace << cloud.name << ":" << std::hexfloat;
      for (const Point3& p : cloud.points) trace << " {" << p.x << ", " << p.y << ", " << p.z << "},";
      SCOPED_TRACE(trace.str());
      Voronoi3 voronoi(t);
      if (is_canonical) voronoi.keep_corners(plain_context());
      expect_facets(t, voronoi);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(FlatVoronoi, WeightedFacetsAreThoseOfTheirDefinition) {
  Random random(72);
  std::size_t without_cell = 0;
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const Cloud& cloud : flat_clouds(random, 10)) {
      if (cloud.name.find("times 2^-1074") != std::string::npos && round > 0) continue;
      const testing::WeightFamily& family = testing::weight_families()[random() % testing::weight_families().size()];
      std::vector<double> weights;
      for (const Point3& p : cloud.points) weights.push_back(family.weight(random, p.x * p.x + p.y * p.y + p.z * p.z));
      std::ostringstream trace;
      trace << cloud.name << ", " << family.name << ":" << std::hexfloat;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const Point3& p = cloud.points[i];
        trace << " {{" << p.x << ", " << p.y << ", " << p.z << "}, " << weights[i] << "},";
      }
      SCOPED_TRACE(trace.str());
      const Regular3 t(cloud.points, weights, plain_context());
      const DeloneLabels labels = delone_labels(t, plain_context());
      const Voronoi3 voronoi(t, labels);
      expect_facets(t, voronoi);
      if (HasFatalFailure()) return;
      for (std::uint32_t v = 0; v < t.vertex_count(); ++v) without_cell += voronoi.has_cell(v) ? 0 : 1;
    }
  }
  EXPECT_GT(without_cell, test_cases(std::size_t{50}));
}

/// Points of the plane, moved to another one: their cells there are the sections, a factor as large.
TEST(FlatVoronoi, SectionsAreCellsOfThePlane) {
  Random random(73);
  int bounded = 0;
  for (int round = 0; round < test_rounds(40); ++round) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < 16; ++i)
      points.push_back({testing::small_integer(random, 5), testing::small_integer(random, 5)});
    const testing::IntegerMotion motion(random);
    std::vector<Point3> moved;
    for (const Point2& p : points) moved.push_back(motion({p.x, p.y, 0}));
    const Delaunay2 plane(points, {}, plain_context());
    const Delone2 delone(plane, plain_context());
    const Voronoi2 expected(plane, delone);
    const Delaunay3 t(moved, plain_context());
    const Voronoi3 voronoi(t);
    const Rational factor(motion.factor());
    std::vector<std::optional<Rational>> squares(points.size());
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) squares[t.inputs(v)[0]] = voronoi.squared_section(v);
    for (std::uint32_t v = 0; v < plane.vertex_count(); ++v) {
      const std::optional<Rational> area = expected.area(Vertex2(v));
      const std::optional<Rational>& square = squares[plane.inputs(Vertex2(v))[0]];
      ASSERT_EQ(square.has_value(), area.has_value());
      if (!area) continue;
      ++bounded;
      ASSERT_EQ(*square, *area * *area * factor * factor * factor * factor);
    }
  }
  EXPECT_GT(bounded, test_cases(50));
}

TEST(FlatVoronoi, SquaresOfAGrid) {
  std::vector<Point3> points;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) points.push_back({3.0 * i, 4.0 * i, 5.0 * j});
  }
  const Delaunay3 t(points, plain_context());
  const Voronoi3 voronoi(t);
  int inner = 0;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    const Point3 p = t.point(v);
    const bool is_inner = p.x > 0 && p.x < 9 && p.z > 0 && p.z < 15;
    const std::optional<Rational> square = voronoi.squared_section(v);
    ASSERT_EQ(square.has_value(), is_inner);
    ASSERT_EQ(voronoi.facets(v).size(), (p.x > 0 && p.x < 9 ? 2U : 1U) + (p.z > 0 && p.z < 15 ? 2U : 1U));
    if (!is_inner) continue;
    ++inner;
    EXPECT_EQ(*square, Rational(625));
  }
  EXPECT_EQ(inner, 4);
}

}  // namespace
}  // namespace quoin
