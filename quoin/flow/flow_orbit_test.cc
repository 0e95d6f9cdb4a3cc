// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_orbit.h"

#include <gtest/gtest.h>

#include <string>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/test_flow.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::flow_complex;
using Counts = std::array<std::size_t, 4>;

/// A point by its coordinates as fractions, "x y z".
std::string text(const RationalPoint3& p) {
  return p.x.to_string() + " " + p.y.to_string() + " " + p.z.to_string();
}

RationalPoint3 place(const std::string& x, const std::string& y, const std::string& z) {
  return {Rational::parse(x), Rational::parse(y), Rational::parse(z)};
}

/// Names of Voronoi faces by their dimension: vertex, edge, facet, cell.
char letter(DeloneFace face) {
  return "CFEV"[face.dimension];
}

/// The orbit as "E-F-V 0 1 2" and so on, and what it ends in.
std::string story(const FlowComplex& flow, const RationalPoint3& start) {
  const Context context({.threads = 1});
  FlowOrbit orbit = flow_orbit(flow, start, context);
  std::string all;
  for (std::size_t i = 0; i < orbit.segments.size(); ++i) {
    const FlowSegment& s = orbit.segments[i];
    all += std::string{letter(s.start), '-', letter(s.crossed), '-'};
    if (!s.reached) return all + "infinity";
    all += letter(*s.reached);
    all += " " + text(orbit.points.exact(static_cast<std::uint32_t>(i + 1))) + "; ";
  }
  if (flow.is_critical(orbit.end)) return all + "index " + std::to_string(orbit.end.dimension);
  return all + "regular";
}

// Known answers with exact coordinates: segments of each kind, generic and degenerate.
TEST(FlowOrbit, FromVerticesToInfinity) {
  const FlowComplex along = flow_complex({{5, 4, 8}, {0, 5, 5}, {5, 2, 3}, {6, 8, 6}});
  EXPECT_EQ(along.counts(), (Counts{4, 6, 3, 0}));
  EXPECT_EQ(story(along, along.centre({3, 0})), "V-E-infinity");
  const FlowComplex through = flow_complex({{8, 6, 4}, {8, 4, 0}, {3, 2, 7}, {2, 3, 2}});
  EXPECT_EQ(through.counts(), (Counts{4, 5, 2, 0}));
  EXPECT_EQ(story(through, through.centre({3, 0})), "V-F-infinity");
  // A corner of three right angles: across the face that is opposite to it.
  const FlowComplex corner = flow_complex({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(corner.counts(), (Counts{4, 3, 0, 0}));
  EXPECT_EQ(text(corner.centre({3, 0})), "1/2 1/2 1/2");
  EXPECT_EQ(story(corner, place("1/2", "1/2", "1/2")), "V-E-infinity");
  EXPECT_EQ(corner.faces().vertices(corner.crossed({3, 0})).size(), 3U);
  for (const std::uint32_t v : corner.faces().vertices(corner.crossed({3, 0}))) {
    EXPECT_NE(corner.point(v), (Point3{0, 0, 0}));
  }
}

// The nearest point of the hull is the midpoint of an edge, but a third point sees the edge under a right angle.
TEST(FlowOrbit, AlongABoundary) {
  std::vector<Point3> points{{-5, 0, 0}, {5, 0, 0}, {3, 4, 0}, {0, 1, -2}};
  const FlowComplex four = flow_complex(points);
  EXPECT_EQ(four.counts(), (Counts{4, 4, 1, 0}));
  EXPECT_EQ(story(four, place("0", "0", "5")), "V-E-infinity");
  points.push_back({0, -1, 20});
  const FlowComplex stopped = flow_complex(points);
  EXPECT_EQ(stopped.counts(), (Counts{5, 7, 4, 1}));
  EXPECT_EQ(story(stopped, place("0", "0", "5")), "V-E-V 0 0 47/5; index 3");
  points.back() = {0, 0, 20};
  const FlowComplex regular = flow_complex(points);
  EXPECT_EQ(regular.counts(), (Counts{5, 7, 3, 0}));
  EXPECT_EQ(story(regular, place("0", "0", "5")), "V-E-V 0 0 75/8; regular");
}

TEST(FlowOrbit, FromEdgesThroughFacets) {
  const FlowComplex plane = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 3, 0}});
  EXPECT_EQ(plane.counts(), (Counts{3, 2, 0, 0}));
  EXPECT_EQ(story(plane, place("0", "-7/6", "0")), "E-F-infinity");
  const FlowComplex five = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, -10, 3}, {0, -10, -3}});
  EXPECT_EQ(five.counts(), (Counts{5, 7, 4, 1}));
  EXPECT_EQ(story(five, place("0", "-3", "0")), "E-F-V 0 -93/20 0; index 3");
  EXPECT_EQ(story(five, place("0", "-3", "1")), "E-F-E 0 -93/22 31/22; E-E-V 0 -3 11/2; V-F-infinity");
  const FlowComplex four = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, -10, 0}});
  EXPECT_EQ(story(four, place("0", "-3", "1")), "E-F-E 0 -21/5 7/5; E-E-infinity");
}

TEST(FlowOrbit, FromVerticesThroughFacets) {
  const FlowComplex six = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 1}, {0, 2, -1}, {0, -10, 3}, {0, -10, -3}});
  EXPECT_EQ(six.counts(), (Counts{6, 10, 6, 1}));
  EXPECT_EQ(story(six, place("0", "-11/4", "0")), "V-F-V 0 -93/20 0; index 3");
  // It ends in a saddle.
  const FlowComplex five = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 1}, {0, 2, -1}, {0, -10, 0}});
  EXPECT_EQ(five.counts(), (Counts{5, 7, 3, 0}));
  EXPECT_EQ(story(five, place("0", "-11/4", "0")), "V-F-E 0 -21/5 0; index 2");
}

TEST(FlowOrbit, FromCells) {
  std::vector<Point3> cube = testing::lattice(2, 2, 2);
  for (Point3& p : cube) p = {2 * p.x, 2 * p.y, 2 * p.z};
  EXPECT_EQ(story(flow_complex(cube), place("1/2", "1/3", "1/4")),
            "C-C-F 1 2/3 1/2; F-F-E 1 1 3/4; E-E-V 1 1 1; index 3");
  cube.push_back({1, 1, 1});
  EXPECT_EQ(story(flow_complex(cube), place("1", "1", "-1/2")), "V-E-infinity");
  const FlowComplex right = flow_complex({{5, 0, 0}, {-5, 0, 0}, {3, 4, 0}});
  EXPECT_EQ(story(right, place("0", "1", "0")), "C-C-F -1/3 2/3 0; F-F-E 0 0 0; regular");
}

TEST(FlowOrbit, FromCospherical) {
  const RationalPoint3 origin = place("0", "0", "0");
  const FlowComplex square = flow_complex({{4, 0, -3}, {-4, 0, -3}, {0, 4, -3}, {0, -4, -3}, {0, 0, -5}});
  EXPECT_EQ(square.counts(), (Counts{5, 8, 4, 0}));
  EXPECT_EQ(story(square, origin), "V-E-infinity");
  const FlowComplex edge = flow_complex({{4, 0, -3}, {-4, 0, -3}, {0, 3, -4}, {0, -3, -4}, {0, 0, -5}});
  EXPECT_EQ(edge.counts(), (Counts{5, 8, 4, 0}));
  EXPECT_EQ(story(edge, origin), "V-F-infinity");
  const FlowComplex stationary = flow_complex({{5, 0, 0}, {-5, 0, 0}, {0, 3, -4}, {0, -3, -4}, {0, 0, -5}});
  EXPECT_EQ(stationary.counts(), (Counts{5, 8, 4, 0}));
  EXPECT_EQ(story(stationary, origin), "regular");
}

TEST(FlowOrbit, InputPointsAndMidpointsStay) {
  const FlowComplex flow = flow_complex({{0, 0, 0}, {2, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(story(flow, place("2", "0", "0")), "index 0");
  EXPECT_EQ(story(flow, place("1", "0", "0")), "index 1");
  EXPECT_EQ(story(flow, place("1", "1", "0")), "F-F-infinity");
  EXPECT_EQ(story(flow, place("1/2", "0", "0")), "C-C-F 1 0 0; index 1");
  EXPECT_EQ(story(flow_complex({{1, 1, 1}}), place("1", "0", "0")), "C-C-infinity");
}

}  // namespace
}  // namespace quoin
