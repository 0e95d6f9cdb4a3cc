// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/radial_order.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/kernel/test_points.h"

namespace quoin {
namespace {

using testing::Random;

// Eight directions about the z axis, counterclockwise from the x axis.
const std::vector<Point2> directions{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

Point3 point_at(std::size_t eighth, double distance, double height) {
  const Point2& d = directions[eighth % 8];
  return {d.x * distance, d.y * distance, height};
}

// p -> Q p + t with Q three times a rotation, so that integers stay integers.
Point3 moved(const Point3& p) {
  return {2 * p.x - p.y + 2 * p.z + 1e6, 2 * p.x + 2 * p.y - p.z - 5, -p.x + 2 * p.y + 2 * p.z + 77};
}

TEST(RadialOrder, IsTheOrderOfAnglesFromEveryReference) {
  const Point3 p{0, 0, -1};
  const Point3 q{0, 0, 2};
  for (std::size_t r = 0; r < 8; ++r) {
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t b = 0; b < 8; ++b) {
        const Point3 reference = point_at(r, 2, 5);
        const Point3 first = point_at(r + a, 1, 3);
        const Point3 second = point_at(r + b, 4, -2);
        const Sign expected = sign_of(static_cast<int>(a) - static_cast<int>(b));
        ASSERT_EQ(compare_radially(p, q, reference, first, second), expected) << r << " " << a << " " << b;
        ASSERT_EQ(compare_radially(moved(p), moved(q), moved(reference), moved(first), moved(second)), expected);
      }
    }
  }
}

TEST(RadialOrder, HoldsAtTheEndsOfTheRange) {
  const Point3 p{1e-300, 0, 0};
  const Point3 q{1e-300, 0, 1e-300};
  EXPECT_EQ(compare_radially(p, q, {1e300, 0, 0}, {1e-300, 1e-300, 5}, {-1e300, 0, 0}), Sign::negative);
  EXPECT_EQ(compare_radially(p, q, {1e300, 0, 0}, {-1e300, -5e-324, 0}, {-1e300, 0, 0}), Sign::positive);
  EXPECT_EQ(compare_radially(p, q, {1e300, 0, 0}, {2e-300, 0, 1e300}, {1e300, 0, 7}), Sign::zero);
}

TEST(RadialOrder, RefusesPointsOnTheEdge) {
  const Point3 p{0, 0, 0};
  const Point3 q{1, 1, 1};
  const Point3 off{1, 0, 0};
  EXPECT_THROW(compare_radially(p, q, {2, 2, 2}, off, off), InputError);
  EXPECT_THROW(compare_radially(p, q, off, {-1, -1, -1}, off), InputError);
  EXPECT_THROW(compare_radially(p, p, off, off, off), InputError);
}

TEST(RadialOrder, IsATotalPreorder) {
  Random random(41);
  for (int i = 0; i < 20'000; ++i) {
    const auto coordinate = [](Random& r) { return testing::small_integer(r, 2); };
    std::array<Point3, 6> p;
    for (Point3& point : p) point = testing::make_point(&point, random, coordinate);
    const auto order = [&](int a, int b) { return compare_radially(p[0], p[1], p[2], p[a], p[b]); };
    try {
      ASSERT_EQ(order(3, 4), -order(4, 3)) << testing::reproduce(p);
      ASSERT_NE(order(2, 3), Sign::positive) << testing::reproduce(p);
      if (order(3, 4) != Sign::positive && order(4, 5) != Sign::positive) {
        ASSERT_NE(order(3, 5), Sign::positive) << testing::reproduce(p);
      }
    } catch (const InputError&) {  // a point on the edge
    }
  }
}

// Planes through the line from 0 to 1 and one point of each direction; the normals keep the angles.
TEST(RadialOrder, OfPlanesIsThatOfTheirNormals) {
  std::vector<Point3> points{moved({0, 0, 0}), moved({0, 0, 1})};
  for (std::size_t k = 0; k < 8; ++k) points.push_back(moved(point_at(k, 3, 1)));
  Constructions table(points);
  table.resize_planes(8);
  table.resize_lines(1);
  const LineId line{0};
  table.set_line(line, PointId{0}, PointId{1});
  for (std::size_t k = 0; k < 8; ++k) table.set_plane(PlaneId{k}, PointId{0}, PointId{1}, PointId{k + 2});
  for (std::size_t r = 0; r < 8; ++r) {
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t b = 0; b < 8; ++b) {
        const Sign expected = sign_of(static_cast<int>(a) - static_cast<int>(b));
        ASSERT_EQ(compare_radially(table, line, PlaneId{r}, PlaneId{(r + a) % 8}, PlaneId{(r + b) % 8}), expected);
      }
    }
  }
}

// Where two segments of one plane cross: on the line of the first and the plane through the second parallel to an axis
// that is not parallel to their common plane.
TEST(RadialOrder, TwoSegmentsInAPlaneCrossInAConstructedPoint) {
  Constructions table(std::vector<Point3>{{0, 0, 0}, {3, 3, 3}, {1, 0, 2}, {2, 3, 1}});
  table.resize_planes(2);
  table.resize_points(5);
  table.set_plane(PlaneId{0}, PointId{0}, PointId{1}, PointId{2});
  const unsigned axis = table.main_axis(PlaneId{0});
  ASSERT_EQ(table.side(PointId{3}, PlaneId{0}), Sign::zero);
  table.set_axis_plane(PlaneId{1}, PointId{2}, PointId{3}, axis);
  table.set_point(PointId{4}, PointId{0}, PointId{1}, PlaneId{1});
  EXPECT_EQ(table.side(PointId{4}, PlaneId{0}), Sign::zero);
  EXPECT_EQ(table.turn_any(PointId{2}, PointId{3}, PointId{4}, axis), Sign::zero);
  EXPECT_EQ(table.turn_any(PointId{0}, PointId{1}, PointId{4}, axis), Sign::zero);
}

}  // namespace
}  // namespace quoin
