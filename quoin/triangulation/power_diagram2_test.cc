// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/delone.h"
#include "quoin/triangulation/location2.h"
#include "quoin/triangulation/test_points2.h"
#include "quoin/triangulation/test_power_cells.h"
#include "quoin/triangulation/voronoi2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;
using testing::WeightFamily;

using Weighted = std::vector<WeightedPoint2>;

std::string reproduce(const Weighted& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const auto& [p, w] : points) out << "{{" << p.x << ", " << p.y << "}, " << w << "}, ";
  return out.str();
}

Weighted weigh(Random& random, const std::vector<Point2>& points, const WeightFamily& family) {
  Weighted result;
  for (const Point2& p : points) result.push_back({p, family.weight(random, p.x * p.x + p.y * p.y)});
  return result;
}

/// Calls test(points, family of points) for all families of both.
template <class Test>
void for_all_families(Random& random, std::initializer_list<std::size_t> counts, const Test& test) {
  for (const auto& family : point_sets()) {
    for (const WeightFamily& weights : testing::weight_families()) {
      for (const std::size_t count : counts) {
        const Weighted points = weigh(random, family.make(random, count), weights);
        SCOPED_TRACE(std::string(family.name) + ", " + weights.name + ": " + reproduce(points));
        test(points, family);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

Rational power(const RationalPoint2& x, const WeightedPoint2& p) {
  return testing::power({x.x, x.y, Rational()}, {p.point.x, p.point.y, 0}, p.weight);
}
Rational power(const Point2& x, const WeightedPoint2& p) {
  return power(RationalPoint2{Rational(x.x), Rational(x.y)}, p);
}

TEST(RegularLocation2, NearestByBruteForce) {
  Random random(51);
  for_all_families(random, {1, 2, 3, 5, 30}, [&](const Weighted& points, const testing::PointSetFamily& family) {
    const Regular2 t(points);
    for (int k = 0; k < test_rounds(4); ++k) {
      const Point2& a = points[random() % points.size()].point;
      const Point2& b = points[random() % points.size()].point;
      const Point2 q = k % 2 == 0   ? Point2{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}
                       : k % 4 == 1 ? a
                                    : family.make(random, 1)[0];
      Rational least = power(q, points[0]);
      for (const WeightedPoint2& p : points) least = std::min(least, power(q, p));
      Vertex2 expected(0);
      while (power(q, t.point(expected)) != least) expected = Vertex2(expected.index() + 1);
      const Vertex2 near = k % 2 == 0 ? Vertex2() : Vertex2(random() % t.vertex_count());
      ASSERT_EQ(nearest_vertex(t, q, near), expected) << reproduce({{q, 0}});
    }
  });
}

TEST(RegularLocation2, ManyOfALineMayBeAsNear) {
  Random random(58);
  for (int round = 0; round < test_rounds(100); ++round) {
    const auto step = [&] { return testing::small_integer(random, 5); };
    const Point2 from{step(), step()};
    const Point2 way{step(), step()};
    Weighted points;
    for (int i = 0; i < 9; ++i) {
      const Point2 p{from.x + i * way.x, from.y + i * way.y};
      points.push_back({p, p.x * p.x + p.y * p.y + (i == 0 ? -1 : 0)});
    }
    std::shuffle(points.begin(), points.end(), random);
    const Regular2 t(points);
    // All but one have no power of the origin.
    Vertex2 expected(0);
    while (power(Point2{0, 0}, t.point(expected)) != Rational(0)) expected = Vertex2(expected.index() + 1);
    ASSERT_EQ(nearest_vertex(t, {0, 0}), expected) << reproduce(points);
  }
}

TEST(RegularLocation2, PowersAreComparedExactly) {
  Random random(52);
  for (const testing::Family& family : testing::families()) {
    for (int round = 0; round < test_rounds(300); ++round) {
      const auto p = testing::near_degenerate<Point2, 3>(random, family);
      const double v = round % 2 == 0 ? testing::small_integer(random, 4) : testing::any_finite(random);
      const double close = (power(p[0], {p[2], 0}) - power(p[0], {p[1], v})).to_double();
      const double w = round % 3 == 0 || !std::isfinite(close) ? v : std::nextafter(close, round % 4 - 1.5);
      const Sign expected = sign_of(power(p[0], {p[1], v}) - power(p[0], {p[2], w}));
      ASSERT_EQ(compare_powers(p[0], {p[1], v}, {p[2], w}), expected) << family.name << testing::reproduce(p);
      ASSERT_EQ(compare_powers(p[0], {p[2], w}, {p[1], v}), -expected);
    }
  }
}

TEST(RegularLocation2, FacesHoldTheQuery) {
  Random random(53);
  for_all_families(random, {1, 2, 4, 30}, [&](const Weighted& points, const testing::PointSetFamily&) {
    const Regular2 t(points);
    const Triangulation2& links = t.links();
    for (const WeightedPoint2& p : points) {
      const Location2 found = locate(t, p.point);
      const auto turn = [&](Edge2 e) {
        return orientation(t.point(links.source(e)).point, t.point(links.target(e)).point, p.point);
      };
      ASSERT_NE(found.place, Location2::Place::outside);
      if (found.place == Location2::Place::vertex) {
        ASSERT_EQ(t.point(found.vertex).point, p.point);
      } else if (found.place == Location2::Place::triangle) {
        for (unsigned slot = 0; slot < 3; ++slot) ASSERT_EQ(turn(Edge2(found.triangle, slot)), Sign::positive);
      } else if (t.dimension() == 2) {
        ASSERT_EQ(turn(found.edge), Sign::zero);
        ASSERT_EQ(turn(Triangulation2::next(found.edge)), Sign::positive);
        ASSERT_EQ(turn(Triangulation2::previous(found.edge)), Sign::positive);
      } else {
        const Point2& a = t.point(t.line()[found.on_line]).point;
        const Point2& b = t.point(t.line()[found.on_line + 1]).point;
        ASSERT_TRUE(lexicographically_less(a, p.point) && lexicographically_less(p.point, b));
      }
    }
  });
  EXPECT_TRUE(nearest_vertex(Regular2(Weighted{}), {0, 0}).is_none());
  EXPECT_THROW(nearest_vertex(Regular2(Weighted{{{0, 0}, 1}}), {std::numeric_limits<double>::infinity(), 0}),
               InputError);
}

// What of a polygon has less power of a than of b.
std::vector<RationalPoint2> clip(const std::vector<RationalPoint2>& polygon, const WeightedPoint2& a,
                                 const WeightedPoint2& b) {
  std::vector<RationalPoint2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint2& p = polygon[i];
    const RationalPoint2& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = power(p, b) - power(p, a);
    const Rational at_q = power(q, b) - power(q, a);
    if (at_p.sign() != Sign::negative) kept.push_back(p);
    if (at_p.sign() * at_q.sign() == Sign::negative) {
      const Rational t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

Rational area(const std::vector<RationalPoint2>& polygon) {
  Rational twice;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint2& p = polygon[i];
    const RationalPoint2& q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return twice / Rational(2);
}

// Half-planes cut a box that is far larger than any bounded cell of points of some grid; all cells fill it.
void expect_cells_of_boxes(const Weighted& points) {
  const Regular2 t(points);
  const Delone2 delone(t);
  const Voronoi2 voronoi(t, delone);
  const Rational far(1000000000);
  Rational sum;
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;  // sites side by side
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    std::vector<RationalPoint2> polygon{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    for (const WeightedPoint2& p : points) polygon = clip(polygon, t.point(Vertex2(v)), p);
    const bool has_cell = area(polygon).sign() == Sign::positive;
    ASSERT_EQ(voronoi.has_cell(Vertex2(v)), has_cell);
    const bool is_bounded = !has_cell || std::ranges::all_of(polygon, [&](const RationalPoint2& p) {
      return abs(p.x) < far && abs(p.y) < far;
    });
    const std::optional<Rational> found = voronoi.area(Vertex2(v));
    ASSERT_EQ(found.has_value(), is_bounded);
    sum += found ? *found : area(polygon);
    if (found && has_cell) {
      ASSERT_EQ(voronoi.cell(Vertex2(v)).corners.size(), polygon.size());
    }
    for (std::uint32_t w = 0; has_cell && w < t.vertex_count(); ++w) {
      const auto is_on = [&](const RationalPoint2& p) {
        return power(p, t.point(Vertex2(v))) == power(p, t.point(Vertex2(w)));
      };
      if (w != v && voronoi.has_cell(Vertex2(w)) && std::ranges::count_if(polygon, is_on) > 1)
        expected.emplace(std::min(v, w), std::max(v, w));
    }
  }
  EXPECT_EQ(sum, Rational(4) * far * far);
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const VoronoiEdge2& e : voronoi.edges())
    ASSERT_TRUE(sides.emplace(std::minmax(e.left.value, e.right.value)).second);
  EXPECT_EQ(sides, expected);
}

TEST(PowerDiagram2, CellsAreThoseOfHalfPlanes) {
  Random random(54);
  for (int round = 0; round < test_rounds(60); ++round) {
    std::vector<Point2> points;
    const int size = 1 + static_cast<int>(random() % 5);
    for (std::size_t i = 1 + random() % 14; i > 0; --i) {
      points.push_back({testing::small_integer(random, size), testing::small_integer(random, size)});
    }
    for (const WeightFamily& family : testing::weight_families()) {
      if (std::string(family.name) == "any doubles") continue;  // cells may end beyond the box
      const Weighted weighted = weigh(random, points, family);
      SCOPED_TRACE(std::string(family.name) + ": " + reproduce(weighted));
      expect_cells_of_boxes(weighted);
      if (HasFatalFailure()) return;
    }
  }
}

// Each corner ends as many edges as its cell of the complex has sides; ends have the same power of both sites, and the
// left one is on the left.
TEST(PowerDiagram2, EdgesJoinVertices) {
  Random random(55);
  for_all_families(random, {3, 6, 14}, [&](const Weighted& points, const testing::PointSetFamily&) {
    const Regular2 t(points);
    const Delone2 delone(t);
    const Voronoi2 voronoi(t, delone);
    std::vector<RationalPoint2> corners;
    for (std::size_t c = 0; c < delone.cell_count(); ++c) {
      corners.push_back(voronoi.vertex(DeloneCell2(c)));
      for (const WeightedPoint2& site : points)
        ASSERT_GE(power(corners[c], site), voronoi.squared_radius(DeloneCell2(c)));
    }
    std::map<DeloneCell2, std::size_t> degree;
    std::map<Vertex2, std::size_t> sides;
    for (const VoronoiEdge2& e : voronoi.edges()) {
      for (const DeloneCell2 end : {e.from, e.to}) {
        if (end.is_none()) continue;
        ++degree[end];
        const RationalPoint2& p = corners[end.index()];
        ASSERT_EQ(power(p, t.point(e.left)), voronoi.squared_radius(end));
        ASSERT_EQ(power(p, t.point(e.right)), voronoi.squared_radius(end));
      }
      if (!e.from.is_none() && !e.to.is_none()) {
        const RationalPoint2& p = corners[e.from.index()];
        const RationalPoint2& q = corners[e.to.index()];
        const Rational wx = Rational(t.point(e.left).point.x) - Rational(t.point(e.right).point.x);
        const Rational wy = Rational(t.point(e.left).point.y) - Rational(t.point(e.right).point.y);
        ASSERT_EQ(sign_of((q.x - p.x) * wy - (q.y - p.y) * wx), Sign::positive);
      }
      ++sides[e.left];
      ++sides[e.right];
    }
    for (std::size_t c = 0; c < delone.cell_count(); ++c) {
      ASSERT_EQ(degree[DeloneCell2(c)], delone.corners(DeloneCell2(c)).size());
      ASSERT_EQ(delone.cell(delone.triangle(DeloneCell2(c))), DeloneCell2(c));
    }
    for (std::uint32_t v = 0; v < t.vertex_count() && t.dimension() == 2; ++v) {
      const VoronoiCell2 cell = voronoi.cell(Vertex2(v));
      ASSERT_EQ(sides[Vertex2(v)], cell.corners.size() + (cell.is_bounded ? 0 : 1));
      ASSERT_EQ(sides[Vertex2(v)] > 0, voronoi.has_cell(Vertex2(v)));
    }
  });
}

TEST(PowerDiagram2, PointsInSidesOfCellsHaveNoCell) {
  // All lifted points of each half in one plane.
  Weighted points;
  for (const Point2& p : testing::grid2(4)) points.push_back({p, p.x * p.x + p.y * p.y - std::fabs(p.x - 2)});
  const Regular2 t(points);
  const Delone2 delone(t);
  const Voronoi2 voronoi(t, delone);
  EXPECT_EQ(delone.cell_count(), 2U);
  EXPECT_EQ(voronoi.edges().size(), 7U);
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
    const Point2& p = t.point(Vertex2(v)).point;
    const bool is_corner = (p.y == 0 || p.y == 4) && (p.x == 0 || p.x == 2 || p.x == 4);
    EXPECT_EQ(voronoi.has_cell(Vertex2(v)), is_corner);
    if (!is_corner) {
      EXPECT_EQ(*voronoi.area(Vertex2(v)), Rational(0));
    }
  }
  // Along a line.
  Weighted line;
  for (int i = 0; i < 6; ++i) line.push_back({{i * 1.0, 0}, i * i * 1.0});
  const Regular2 flat(line);
  const Delone2 none(flat);
  EXPECT_EQ(Voronoi2(flat, none).edges().size(), 1U);
}

template <class Triangulation>
std::vector<std::vector<Vertex2>> cells_of(const Triangulation& t) {
  const Delone2 delone(t);
  std::vector<std::vector<Vertex2>> cells;
  for (std::size_t c = 0; c < delone.cell_count(); ++c) {
    const auto corners = delone.corners(DeloneCell2(c));
    cells.emplace_back(corners.begin(), corners.end());
  }
  return cells;
}

TEST(PowerDiagram2, EqualWeightsGiveVoronoiDiagrams) {
  Random random(56);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> points = family.make(random, test_rounds(60));
    SCOPED_TRACE(std::string(family.name) + ": " + testing::reproduce(points));
    Weighted weighted;
    for (const Point2& p : points) weighted.push_back({p, 0.75});
    const Delaunay2 delaunay(points);
    const Regular2 regular(weighted);
    ASSERT_EQ(cells_of(regular), cells_of(delaunay));
    const Delone2 delone(delaunay);
    const Delone2 weighted_delone(regular);
    const Voronoi2 voronoi(delaunay, delone);
    const Voronoi2 power_diagram(regular, weighted_delone);
    for (std::uint32_t v = 0; v < delaunay.vertex_count(); ++v)
      ASSERT_EQ(power_diagram.area(Vertex2(v)), voronoi.area(Vertex2(v)));
    ASSERT_EQ(power_diagram.edges().size(), voronoi.edges().size());
  }
}

// Points of the plane in space: the same cells.
TEST(RegularDelone, OfPlanesInSpaceAreThoseOfThePlane) {
  Random random(57);
  for_all_families(random, {1, 2, 4, 9, 20}, [&](const Weighted& points, const testing::PointSetFamily&) {
    std::vector<Point3> in_space;
    std::vector<double> weights;
    for (const WeightedPoint2& p : points) {
      in_space.push_back({p.point.x, 0, p.point.y});
      weights.push_back(p.weight);
    }
    const Regular2 plane(points);
    const Regular3 space(in_space, weights, Context({.threads = 1}));
    using Place = std::pair<double, double>;
    std::set<std::set<Place>> expected;
    for (const std::vector<Vertex2>& cell : cells_of(plane)) {
      std::set<Place> places;
      for (const Vertex2 v : cell) places.emplace(plane.point(v).point.x, plane.point(v).point.y);
      expected.insert(places);
    }
    const Delone2 delone(plane);
    for (const VoronoiEdge2& e : Voronoi2(plane, delone).edges()) {
      if (plane.dimension() == 2) break;
      std::set<Place> places;
      for (const Vertex2 v : {e.left, e.right}) places.emplace(plane.point(v).point.x, plane.point(v).point.y);
      expected.insert(places);
    }
    const DeloneComplex complex(space, Context({.threads = 1}));
    if (complex.dimension() == 0) return;
    std::set<std::set<Place>> found;
    for (std::size_t c = 0; c < complex.cell_count(); ++c) {
      std::set<Place> places;
      for (const std::uint32_t v : complex.cell(c)) places.emplace(space.point(v).x, space.point(v).z);
      found.insert(places);
    }
    ASSERT_EQ(found, expected);
  });
}

}  // namespace
}  // namespace quoin
