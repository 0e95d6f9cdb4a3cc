// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/test_weights2.h"

namespace quoin {
namespace {

using testing::PlaneWeightFamily;
using testing::point_sets;
using testing::Random;
using testing::reproduce;
using testing::weigh;
using testing::Weighted;

Sign brute_power(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c, const WeightedPoint2& d) {
  testing::Matrix m;
  for (const WeightedPoint2& p : {a, b, c, d}) {
    std::vector<Rational> row = testing::affine_row(p.point, true);
    row[2] -= Rational(p.weight);
    m.push_back(row);
  }
  return testing::determinant(m).sign();
}

TEST(Regular2, PowerCirclesAreDeterminants) {
  Random random(1);
  for (const testing::Family& family : testing::families()) {
    for (int round = 0; round < test_rounds(300); ++round) {
      const auto p = testing::near_degenerate<Point2, 4>(random, family);
      const Weighted w = weigh(random, {p.begin(), p.end()},
                               testing::plane_weight_families()[random() % testing::plane_weight_families().size()]);
      const Sign expected = brute_power(w[0], w[1], w[2], w[3]);
      ASSERT_EQ(in_power_circle(w[0], w[1], w[2], w[3]), expected) << reproduce(w);
      ASSERT_EQ(in_power_circle(w[1], w[0], w[2], w[3]), -expected) << reproduce(w);
    }
  }
}

// No lifted point is below the plane of a triangle or, beyond it, of a hull edge; hidden points are not below their
// own.
void expect_regular(const Weighted& points) {
  const Regular2 regular(points);
  const Triangulation2& links = regular.links();
  ASSERT_EQ(links.defect(), nullptr);
  std::set<std::uint32_t> inputs(regular.hidden().begin(), regular.hidden().end());
  for (std::size_t v = 0; v < regular.vertex_count(); ++v) {
    ASSERT_FALSE(regular.inputs(Vertex2(v)).empty());
    for (const std::uint32_t i : regular.inputs(Vertex2(v))) {
      EXPECT_TRUE(inputs.insert(i).second);
      EXPECT_EQ(points[i].point, regular.point(Vertex2(v)).point);
      EXPECT_EQ(points[i].weight, regular.point(Vertex2(v)).weight);
    }
  }
  EXPECT_EQ(inputs.size(), points.size());
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    const auto v = links.corners(Triangle2(t));
    if (links.is_infinite(Triangle2(t))) {
      unsigned slot = 0;
      while (!links.is_infinite(v[slot])) ++slot;
      const auto& a = regular.point(links.source(Edge2(Triangle2(t), slot)));
      const auto& b = regular.point(links.target(Edge2(Triangle2(t), slot)));
      for (const WeightedPoint2& p : points) ASSERT_NE(orientation(a.point, b.point, p.point), Sign::positive);
      continue;
    }
    const auto& a = regular.point(v[0]);
    const auto& b = regular.point(v[1]);
    const auto& c = regular.point(v[2]);
    ASSERT_EQ(orientation(a.point, b.point, c.point), Sign::positive);
    for (const WeightedPoint2& p : points) ASSERT_NE(in_power_circle(a, b, c, p), Sign::positive);
  }
  // On a line: no point is below the segments between vertices, and the ends are the extreme points.
  for (std::size_t i = 1; i < regular.line().size(); ++i) {
    const auto& a = regular.point(regular.line()[i - 1]);
    const auto& b = regular.point(regular.line()[i]);
    ASSERT_TRUE(lexicographically_less(a.point, b.point));
    for (const WeightedPoint2& p : points) {
      if (p.point == a.point || p.point == b.point) continue;
      ASSERT_NE(in_power_segment(a, b, p), Sign::positive);
    }
  }
}

TEST(Regular2, NothingLiesBelow) {
  Random random(2);
  for (const auto& family : point_sets()) {
    for (const PlaneWeightFamily& weight : testing::plane_weight_families()) {
      for (const std::size_t count : {1, 2, 3, 4, 6, 9, 15, 30}) {
        if (tests_take_fewer_rounds && count > 6) continue;
        const Weighted points = weigh(random, family.make(random, count), weight);
        SCOPED_TRACE(std::string(family.name) + ", " + weight.name + ": " + reproduce(points));
        expect_regular(points);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

using Corners = std::array<std::pair<double, double>, 3>;

template <class Triangulation, class Place>
std::set<Corners> triangles_of(const Triangulation& triangulation, const Place& place) {
  std::set<Corners> found;
  const Triangulation2& links = triangulation.links();
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    if (links.is_infinite(Triangle2(t))) continue;
    Corners corners;
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Point2 p = place(links.corner(Triangle2(t), slot));
      corners[slot] = {p.x, p.y};
    }
    std::sort(corners.begin(), corners.end());
    found.insert(corners);
  }
  return found;
}

std::set<Corners> triangles_of(const Regular2& regular) {
  return triangles_of(regular, [&](Vertex2 v) { return regular.point(v).point; });
}

TEST(Regular2, WithEqualWeightsIsDelaunay) {
  Random random(3);
  for (const auto& family : point_sets()) {
    const std::vector<Point2> points = family.make(random, test_rounds(150));
    Weighted weighted;
    for (const Point2& p : points) weighted.push_back({p, 2.5});
    const Delaunay2 delaunay(points);
    EXPECT_EQ(triangles_of(Regular2(weighted)), triangles_of(delaunay, [&](Vertex2 v) { return delaunay.point(v); }))
        << family.name;
  }
}

TEST(Regular2, OrderDoesNotMatter) {
  Random random(4);
  for (const auto& family : point_sets()) {
    for (const PlaneWeightFamily& weight : testing::plane_weight_families()) {
      Weighted points = weigh(random, family.make(random, test_rounds(30)), weight);
      SCOPED_TRACE(std::string(family.name) + ", " + weight.name + ": " + reproduce(points));
      const auto expected = triangles_of(Regular2(points));
      for (int round = 0; round < 3; ++round) {
        std::shuffle(points.begin(), points.end(), random);
        ASSERT_EQ(triangles_of(Regular2(points)), expected);
      }
    }
  }
}

TEST(Regular2, HiddenPointsAndEqualOnes) {
  const Regular2 regular(Weighted{{{0, 0}, 0}, {{4, 0}, 0}, {{0, 4}, 0}, {{1, 1}, -20}, {{0, 0}, -1}, {{4, 0}, 0}});
  EXPECT_EQ(regular.vertex_count(), 3U);
  EXPECT_EQ((std::vector<std::uint32_t>(regular.hidden().begin(), regular.hidden().end())),
            (std::vector<std::uint32_t>{3, 4}));
  // One heavy point hides all of a lattice but the corners of its hull.
  Weighted lattice;
  for (const Point2& p : testing::grid2(8)) lattice.push_back({p, p == Point2{4, 4} ? 1e6 : 0.0});
  EXPECT_EQ(Regular2(lattice).vertex_count(), 5U + 4 * 7U);
}

TEST(Regular2, BadInputIsNamed) {
  const auto message = [](const Weighted& points) -> std::string {
    try {
      const Regular2 regular(points);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({{{0, 0}, 0}, {{0, nan}, 0}}), "point 1 is not finite");
  EXPECT_EQ(message({{{0, 0}, 0}, {{0, 1}, nan}}), "the weight of point 1 is not finite");
  EXPECT_EQ(message({}), "");
}

}  // namespace
}  // namespace quoin
