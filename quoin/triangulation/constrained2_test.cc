// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/constrained2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/regions2.h"
#include "quoin/triangulation/test_points2.h"

namespace quoin {
namespace {

using testing::point_sets;
using testing::Random;

using Exact = std::pair<Rational, Rational>;

Exact exact(const Point2& p) {
  return {Rational(p.x), Rational(p.y)};
}
Rational cross(const Exact& o, const Exact& a, const Exact& b) {
  return (a.first - o.first) * (b.second - o.second) - (a.second - o.second) * (b.first - o.first);
}

std::string reproduce(const std::vector<Point2>& points, const std::vector<Segment2>& segments) {
  std::string out = testing::reproduce(points);
  for (const Segment2& s : segments) out += " " + std::to_string(s[0]) + "-" + std::to_string(s[1]);
  return out;
}

std::vector<Segment2> random_segments(Random& random, std::size_t points, std::size_t count) {
  std::vector<Segment2> segments;
  while (segments.size() < count) {
    segments.push_back({static_cast<std::uint32_t>(random() % points), static_cast<std::uint32_t>(random() % points)});
  }
  return segments;
}

// All points, and where two segments that are not parallel meet.
std::set<Exact> expected_vertices(const std::vector<Point2>& points, const std::vector<Segment2>& segments) {
  std::set<Exact> found;
  for (const Point2& p : points) found.insert(exact(p));
  for (const Segment2& s : segments) {
    for (const Segment2& t : segments) {
      const Exact a = exact(points[s[0]]);
      const Exact b = exact(points[s[1]]);
      const Rational from = cross(exact(points[t[0]]), exact(points[t[1]]), a);
      const Rational to = cross(exact(points[t[0]]), exact(points[t[1]]), b);
      const Rational c = cross(a, b, exact(points[t[0]]));
      const Rational d = cross(a, b, exact(points[t[1]]));
      if (from == to || from.sign() * to.sign() == Sign::positive || c.sign() * d.sign() == Sign::positive) continue;
      const Rational along = from / (from - to);
      found.insert({a.first + along * (b.first - a.first), a.second + along * (b.second - a.second)});
    }
  }
  return found;
}

// Each segment is a chain of pieces between its ends, in its direction.
void expect_chains(const ConstrainedDelaunay2& d, const std::vector<Point2>& points,
                   const std::vector<Segment2>& segments) {
  std::vector<std::map<Exact, int>> balance(segments.size());
  for (std::size_t p = 0; p < d.pieces().size(); ++p) {
    const RationalPoint2 a = d.exact(d.pieces()[p].source);
    const RationalPoint2 b = d.exact(d.pieces()[p].target);
    ASSERT_FALSE(d.uses(p).empty());
    for (const SegmentUse2& use : d.uses(p)) {
      const Exact from = exact(points[segments[use.segment][0]]);
      const Exact to = exact(points[segments[use.segment][1]]);
      EXPECT_EQ(cross(from, to, {a.x, a.y}).sign(), Sign::zero);
      EXPECT_EQ(cross(from, to, {b.x, b.y}).sign(), Sign::zero);
      EXPECT_EQ(use.reversed, to < from);
      --balance[use.segment][use.reversed ? Exact{b.x, b.y} : Exact{a.x, a.y}];
      ++balance[use.segment][use.reversed ? Exact{a.x, a.y} : Exact{b.x, b.y}];
    }
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    ++balance[s][exact(points[segments[s][0]])];
    --balance[s][exact(points[segments[s][1]])];
    for (const auto& [at, sum] : balance[s]) EXPECT_EQ(sum, 0) << "segment " << s;
  }
}

void expect_constrained_delaunay(const ConstrainedDelaunay2& d) {
  const Triangulation2& links = d.links();
  ASSERT_EQ(links.defect(), nullptr);
  std::set<std::size_t> pieces;
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    const auto v = links.corners(Triangle2(t));
    if (!links.is_infinite(Triangle2(t))) {
      ASSERT_EQ(d.turn(v[0], v[1], v[2]), Sign::positive);
    }
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(Triangle2(t), slot);
      ASSERT_EQ(d.piece(e), d.piece(links.twin(e)));
      if (d.is_constrained(e)) pieces.insert(*d.piece(e));
      const Vertex2 beyond = links.apex(links.twin(e));
      if (links.is_infinite(Triangle2(t)) || links.is_infinite(beyond)) continue;
      if (!d.is_constrained(e)) {
        ASSERT_NE(d.circle_side(v[0], v[1], v[2], beyond), Sign::positive);
      }
    }
  }
  if (d.dimension() == 2) {
    ASSERT_EQ(pieces.size(), d.pieces().size());
  }
}

TEST(Constrained2, SegmentsAreChainsOfEdgesAndTheRestIsDelaunay) {
  Random random(1);
  for (const auto& family : point_sets()) {
    for (int round = 0; round < test_rounds(12); ++round) {
      const std::vector<Point2> points = family.make(random, 1 + random() % 20);
      const std::vector<Segment2> segments = random_segments(random, points.size(), random() % 12);
      SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points, segments));
      const ConstrainedDelaunay2 delaunay(points, segments);
      expect_constrained_delaunay(delaunay);
      expect_chains(delaunay, points, segments);
      std::set<Exact> vertices;
      std::size_t inputs = 0;
      for (std::size_t v = 0; v < delaunay.vertex_count(); ++v) {
        const RationalPoint2 p = delaunay.exact(Vertex2(v));
        EXPECT_TRUE(vertices.insert({p.x, p.y}).second);
        inputs += delaunay.inputs(Vertex2(v)).size();
        EXPECT_EQ(delaunay.inputs(Vertex2(v)).empty(), v >= delaunay.given_count());
        for (const std::uint32_t i : delaunay.inputs(Vertex2(v))) EXPECT_EQ(exact(points[i]), Exact(p.x, p.y));
      }
      EXPECT_EQ(inputs, points.size());
      ASSERT_EQ(vertices, expected_vertices(points, segments));
    }
  }
}

std::set<std::array<Exact, 3>> triangles_of(const ConstrainedDelaunay2& d) {
  std::set<std::array<Exact, 3>> found;
  for (std::uint32_t t = 0; t < d.links().triangle_count(); ++t) {
    if (d.links().is_infinite(Triangle2(t))) continue;
    std::array<Exact, 3> corners;
    for (unsigned slot = 0; slot < 3; ++slot) {
      const RationalPoint2 p = d.exact(d.links().corner(Triangle2(t), slot));
      corners[slot] = {p.x, p.y};
    }
    std::sort(corners.begin(), corners.end());
    found.insert(corners);
  }
  return found;
}

TEST(Constrained2, OrderOfSegmentsDoesNotMatter) {
  Random random(2);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> points = family.make(random, 25);
    std::vector<Segment2> segments = random_segments(random, points.size(), 15);
    SCOPED_TRACE(std::string(family.name) + ": " + reproduce(points, segments));
    const auto expected = triangles_of(ConstrainedDelaunay2(points, segments));
    for (int round = 0; round < test_rounds(3); ++round) {
      std::shuffle(segments.begin(), segments.end(), random);
      for (Segment2& s : segments) {
        if (random() % 2 == 0) std::swap(s[0], s[1]);
      }
      ASSERT_EQ(triangles_of(ConstrainedDelaunay2(points, segments)), expected);
    }
  }
}

TEST(Constrained2, LongSegmentsThroughManyTriangles) {
  Random random(3);
  std::vector<Point2> points = point_sets()[0].make(random, 1500);
  std::vector<Segment2> segments;
  for (std::uint32_t i = 0; i < 8; ++i) segments.push_back({i, i + 8});
  const ConstrainedDelaunay2 delaunay(points, segments);
  EXPECT_GT(delaunay.pieces().size(), 8U);
  expect_constrained_delaunay(delaunay);
  expect_chains(delaunay, points, segments);
}

// Winding number of closed chains about a point on none of them, by upward and downward crossings of a ray to the
// right.
std::int64_t winding(const std::vector<Point2>& points, const std::vector<Segment2>& segments, const Exact& at) {
  std::int64_t sum = 0;
  for (const Segment2& s : segments) {
    const Exact a = exact(points[s[0]]);
    const Exact b = exact(points[s[1]]);
    const bool from_above = at.second < a.second;
    const bool to_above = at.second < b.second;
    if (from_above == to_above) continue;
    const Sign side = cross(a, b, at).sign();
    if (to_above && side == Sign::positive) ++sum;
    if (from_above && side == Sign::negative) --sum;
  }
  return sum;
}

TEST(Regions2, WindingNumbersAreThoseOfTheChains) {
  Random random(4);
  for (int round = 0; round < test_rounds(60); ++round) {
    std::vector<Point2> points;
    std::vector<Segment2> segments;
    for (std::size_t chain = 1 + random() % 3; chain > 0; --chain) {
      const auto first = static_cast<std::uint32_t>(points.size());
      const auto length = static_cast<std::uint32_t>(3 + random() % 6);
      for (std::uint32_t i = 0; i < length; ++i) {
        segments.push_back({first + i, first + (i + 1) % length});
        points.push_back({testing::small_integer(random, 5), testing::small_integer(random, 5)});
      }
    }
    SCOPED_TRACE(reproduce(points, segments));
    const ConstrainedDelaunay2 delaunay(points, segments);
    const Regions2 regions(delaunay);
    EXPECT_TRUE(regions.has_windings());
    for (std::uint32_t t = 0; t < delaunay.links().triangle_count(); ++t) {
      const std::uint32_t region = regions.region(Triangle2(t));
      ASSERT_LT(region, regions.count());
      if (delaunay.links().is_infinite(Triangle2(t))) {
        EXPECT_EQ(region, 0U);
        continue;
      }
      Exact centre;
      for (const Vertex2 v : delaunay.links().corners(Triangle2(t))) {
        centre.first += delaunay.exact(v).x / Rational(3);
        centre.second += delaunay.exact(v).y / Rational(3);
      }
      EXPECT_EQ(regions.winding(region), winding(points, segments, centre));
    }
  }
}

TEST(Regions2, HolesAndIslandsByDepth) {
  // Three nested squares, and a segment that hangs free in the outermost.
  std::vector<Point2> points;
  std::vector<Segment2> segments;
  for (const double size : {9.0, 6.0, 3.0}) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point2& p : {Point2{-size, -size}, Point2{size, -size}, Point2{size, size}, Point2{-size, size}}) {
      points.push_back(p);
    }
    for (std::uint32_t i = 0; i < 4; ++i) segments.push_back({first + i, first + (i + 1) % 4});
  }
  points.push_back({7, 0});
  points.push_back({8, 1});
  segments.push_back({12, 13});
  const ConstrainedDelaunay2 delaunay(points, segments);
  const Regions2 regions(delaunay);
  ASSERT_EQ(regions.count(), 4U);
  EXPECT_FALSE(regions.has_windings());
  const auto depth_at = [&](const Point2& p) { return regions.depth(regions.region(delaunay.find_triangle(p))); };
  EXPECT_EQ(depth_at({7.5, 5}), 1U);
  EXPECT_EQ(depth_at({-5, 1}), 2U);
  EXPECT_EQ(depth_at({0.5, 1}), 3U);
  EXPECT_TRUE(delaunay.find_triangle({10, 0}).is_none());
  Rational twice_area;
  for (std::uint32_t t = 0; t < delaunay.links().triangle_count(); ++t) {
    if (regions.depth(regions.region(Triangle2(t))) % 2 == 0) continue;
    const auto v = delaunay.links().corners(Triangle2(t));
    twice_area += cross(exact(delaunay.rounded(v[0])), exact(delaunay.rounded(v[1])), exact(delaunay.rounded(v[2])));
  }
  EXPECT_EQ(twice_area, Rational(2 * (18 * 18 - 12 * 12 + 6 * 6)));
}

TEST(Constrained2, BadInputIsNamed) {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, std::numeric_limits<double>::infinity()}};
  const auto message = [](const std::vector<Point2>& p, const std::vector<Segment2>& s) -> std::string {
    try {
      const ConstrainedDelaunay2 delaunay(p, s);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(message(points, {}), "point 2 is not finite");
  EXPECT_EQ(message({{0, 0}, {1, 0}}, {{0, 1}, {1, 2}}), "segment 1 ends at point 2 of 2");
  EXPECT_EQ(ConstrainedDelaunay2(std::vector<Point2>{}, std::vector<Segment2>{}).dimension(), -1);
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(ConstrainedDelaunay2(testing::grid2(20), std::vector<Segment2>{{0, 9}}, cancelled), Cancelled);
  const ConstrainedDelaunay2 grid(testing::grid2(3), std::vector<Segment2>{{0, 9}});
  EXPECT_THROW(grid.find_triangle({0.5, 0.5}, cancelled), Cancelled);
}

TEST(Constrained2, OfADisc) {
  // All segments between the corners of a square and its centre: no crossing is new.
  const std::vector<Point2> points{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}};
  const ConstrainedDelaunay2 delaunay(points, std::vector<Segment2>{{0, 2}, {1, 3}, {2, 0}});
  EXPECT_EQ(delaunay.vertex_count(), 5U);
  EXPECT_EQ(delaunay.given_count(), 5U);
  EXPECT_EQ(delaunay.pieces().size(), 4U);
  // Without the point, the centre is a crossing.
  const std::vector<Point2> corners(points.begin(), points.end() - 1);
  const ConstrainedDelaunay2 crossing(corners, std::vector<Segment2>{{0, 2}, {1, 3}});
  EXPECT_EQ(crossing.vertex_count(), 5U);
  EXPECT_EQ(crossing.given_count(), 4U);
  EXPECT_EQ(crossing.rounded(Vertex2(4)), (Point2{0, 0}));
}

}  // namespace
}  // namespace quoin
