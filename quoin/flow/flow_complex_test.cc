// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::lattice;
using testing::Random;
using Counts = std::array<std::size_t, 4>;
/// Critical points of index 1 and higher by squared value: index, value, how many.
using Values = std::map<std::pair<unsigned, std::string>, std::size_t>;

Values values(const FlowComplex& flow) {
  Values all;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    if (face.dimension > 0) ++all[{face.dimension, flow.square_radius(face).to_string()}];
  }
  return all;
}

/// Where orbits stop at what is no critical point: dimension of the hull of the nearest points, place.
using Places = std::multiset<std::pair<unsigned, std::string>>;

Places regular_places(const FlowComplex& flow) {
  Places all;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::regular)) {
    const RationalPoint3 z = flow.centre(face);
    all.insert({face.dimension, z.x.to_string() + " " + z.y.to_string() + " " + z.z.to_string()});
  }
  return all;
}

std::vector<Point3> scaled(std::vector<Point3> points, double factor) {
  for (Point3& p : points) p = {p.x * factor, p.y * factor, p.z * factor};
  return points;
}

std::vector<Point3> with(std::vector<Point3> points, const std::vector<Point3>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

std::vector<Point3> permutations_of_0_1_1() {
  std::vector<Point3> points;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      points.push_back({0, a, b});
      points.push_back({a, 0, b});
      points.push_back({a, b, 0});
    }
  }
  return points;
}

const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Point3> face_centres{{1, 1, 0}, {1, 1, 2}, {1, 0, 1}, {1, 2, 1}, {0, 1, 1}, {2, 1, 1}};

// Known answers: critical points of the distance to points, counted and with exact squared values.
TEST(FlowComplex, RegularPolytopes) {
  const FlowComplex tetrahedron = flow_complex({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  EXPECT_EQ(tetrahedron.counts(), (Counts{4, 6, 4, 1}));
  EXPECT_EQ(values(tetrahedron), (Values{{{1, "2"}, 6}, {{2, "8/3"}, 4}, {{3, "3"}, 1}}));
  const FlowComplex cube = flow_complex(scaled(lattice(2, 2, 2), 2));
  EXPECT_EQ(cube.counts(), (Counts{8, 12, 6, 1}));
  EXPECT_EQ(values(cube), (Values{{{1, "1"}, 12}, {{2, "2"}, 6}, {{3, "3"}, 1}}));
  const FlowComplex eight = flow_complex(octahedron);
  EXPECT_EQ(eight.counts(), (Counts{6, 12, 8, 1}));
  EXPECT_EQ(values(eight), (Values{{{1, "1/2"}, 12}, {{2, "2/3"}, 8}, {{3, "1"}, 1}}));
}

TEST(FlowComplex, ArchimedeanPolytopes) {
  const FlowComplex cuboctahedron = flow_complex(permutations_of_0_1_1());
  EXPECT_EQ(cuboctahedron.counts(), (Counts{12, 24, 14, 1}));
  EXPECT_EQ(values(cuboctahedron), (Values{{{1, "1/2"}, 24}, {{2, "2/3"}, 8}, {{2, "1"}, 6}, {{3, "2"}, 1}}));
  const FlowComplex truncated = flow_complex(testing::cospherical());
  EXPECT_EQ(truncated.counts(), (Counts{24, 36, 14, 1}));
  EXPECT_EQ(values(truncated), (Values{{{1, "1/2"}, 36}, {{2, "1"}, 6}, {{2, "2"}, 8}, {{3, "5"}, 1}}));
}

TEST(FlowComplex, Lattices) {
  const FlowComplex grid = flow_complex(lattice(3, 3, 3));
  EXPECT_EQ(grid.counts(), (Counts{27, 54, 36, 8}));
  EXPECT_EQ(values(grid), (Values{{{1, "1/4"}, 54}, {{2, "1/2"}, 36}, {{3, "3/4"}, 8}}));
  EXPECT_EQ(flow_complex(lattice(2, 3, 4)).counts(), (Counts{24, 46, 29, 6}));
  for (std::size_t k = 4; k < 7; ++k) {
    const auto side = static_cast<int>(k);
    const Counts expected{k * k * k, 3 * k * k * (k - 1), 3 * k * (k - 1) * (k - 1), (k - 1) * (k - 1) * (k - 1)};
    EXPECT_EQ(flow_complex(lattice(side, side, side)).counts(), expected);
  }
}

TEST(FlowComplex, CubesWithCentres) {
  const std::vector<Point3> cube = scaled(lattice(2, 2, 2), 2);
  const FlowComplex centred = flow_complex(with(cube, {{1, 1, 1}}));
  EXPECT_EQ(centred.counts(), (Counts{9, 20, 12, 0}));
  EXPECT_EQ(values(centred), (Values{{{1, "3/4"}, 8}, {{1, "1"}, 12}, {{2, "9/8"}, 12}}));
  const FlowComplex faces = flow_complex(with(cube, face_centres));
  EXPECT_EQ(faces.counts(), (Counts{14, 36, 32, 9}));
  EXPECT_EQ(values(faces), (Values{{{1, "1/2"}, 36}, {{2, "2/3"}, 32}, {{3, "3/4"}, 8}, {{3, "1"}, 1}}));
  // The middles of the cube's edges, as near to the centres of both faces as to the ends.
  Places middles;
  for (const char* a : {"0", "2"}) {
    for (const char* b : {"0", "2"}) {
      const std::string x(a);
      const std::string y(b);
      for (const std::string& place : {"1 " + x + " " + y, x + " 1 " + y, x + " " + y + " 1"})
        middles.insert({3, place});
    }
  }
  EXPECT_EQ(regular_places(faces), middles);
}

TEST(FlowComplex, PointsOfAPlaneOrALine) {
  EXPECT_EQ(flow_complex({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}).counts(), (Counts{4, 4, 1, 0}));
  const FlowComplex right = flow_complex({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  EXPECT_EQ(right.counts(), (Counts{3, 2, 0, 0}));
  EXPECT_EQ(regular_places(right), (Places{{2, "3/2 2 0"}}));
  EXPECT_EQ(flow_complex({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}).counts(), (Counts{3, 3, 1, 0}));
  EXPECT_EQ(flow_complex({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}}).counts(), (Counts{3, 2, 0, 0}));
  EXPECT_EQ(flow_complex({{0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {-1, -2, -3}, {7, 14, 21}}).counts(), (Counts{5, 4, 0, 0}));
  EXPECT_EQ(flow_complex(lattice(4, 4, 1)).counts(), (Counts{16, 24, 9, 0}));
  EXPECT_EQ(flow_complex({{1, 2, 3}, {1, 2, 3}}).counts(), (Counts{1, 0, 0, 0}));
}

TEST(FlowComplex, TwoRowsOfPoints) {
  for (const double shift : {0.0, 1.0}) {
    std::vector<Point3> points{{-6, 3, 0}, {30, 3, 0}};
    for (int i = 0; i < 9; ++i) {
      points.push_back({3.0 * i, 0, 0});
      points.push_back({3.0 * i + shift, 6, 0});
    }
    const FlowComplex flow = flow_complex(points);
    EXPECT_EQ(flow.counts(), shift == 0 ? (Counts{20, 29, 10, 0}) : (Counts{20, 37, 18, 0}));
    if (shift == 0) {  // along the rows, across, at both ends
      EXPECT_EQ(values(flow),
                (Values{{{1, "9/4"}, 16}, {{1, "9"}, 9}, {{1, "45/4"}, 4}, {{2, "45/4"}, 8}, {{2, "225/16"}, 2}}));
    } else {  // across in a zigzag
      Values edges = values(flow);
      std::erase_if(edges, [](const auto& entry) { return entry.first.first != 1; });
      EXPECT_EQ(edges, (Values{{{1, "9/4"}, 16},
                               {{1, "37/4"}, 9},
                               {{1, "10"}, 8},
                               {{1, "17/2"}, 1},
                               {{1, "29/2"}, 1},
                               {{1, "45/4"}, 2}}));
    }
  }
}

TEST(FlowComplex, RightAngles) {
  const FlowComplex corner = flow_complex({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(corner.counts(), (Counts{4, 3, 0, 0}));
  EXPECT_EQ(regular_places(corner), (Places{{2, "1/2 1/2 0"}, {2, "1/2 0 1/2"}, {2, "0 1/2 1/2"}}));
  const FlowComplex prism = flow_complex({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 2}, {3, 0, 2}, {0, 4, 2}});
  EXPECT_EQ(prism.counts(), (Counts{6, 7, 2, 0}));
  // On both hypotenuses, and between them in the middle of a side.
  EXPECT_EQ(regular_places(prism), (Places{{2, "3/2 2 0"}, {2, "3/2 2 2"}, {3, "3/2 2 1"}}));
  // The centre of the sphere is on a face, and that of the face: neither a maximum nor a saddle.
  const FlowComplex merged = flow_complex({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, -5}});
  EXPECT_EQ(merged.counts(), (Counts{4, 6, 3, 0}));
  EXPECT_EQ(regular_places(merged), (Places{{3, "0 0 0"}}));
}

TEST(FlowComplex, SingleTetrahedraHaveSevenSignatures) {
  const std::set<Counts> known{{4, 3, 0, 0}, {4, 4, 1, 0}, {4, 5, 2, 0}, {4, 6, 3, 0},
                               {4, 4, 2, 1}, {4, 5, 3, 1}, {4, 6, 4, 1}};
  std::set<Counts> seen;
  Random random(71);
  for (int round = 0; round < test_rounds(1500); ++round) {
    const std::vector<Point3> points =
        testing::random_points(random, 4, [](Random& r) { return testing::small_integer(r, 9); });
    const FlowComplex flow = flow_complex(points);
    if (flow.faces().dimension() < 3) continue;
    ASSERT_TRUE(known.contains(flow.counts()));
    seen.insert(flow.counts());
  }
  EXPECT_GE(seen.size(), test_cases(6U));
}

long alternating_sum(const Counts& c) {
  return static_cast<long>(c[0]) - static_cast<long>(c[1]) + static_cast<long>(c[2]) - static_cast<long>(c[3]);
}

TEST(FlowComplex, AlternatingSumIsOne) {
  Random random(72);
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 60)) {
    SCOPED_TRACE(cloud.name);
    EXPECT_EQ(alternating_sum(flow_complex(cloud.points).counts()), 1);
  }
  for (int round = 0; round < test_rounds(100); ++round) {
    std::vector<Point3> points = lattice(4, 4, 4);
    std::shuffle(points.begin(), points.end(), random);
    points.resize(12);
    EXPECT_EQ(alternating_sum(flow_complex(points).counts()), 1);
  }
}

// Axes exchanged, moved, scaled, in another order: the same numbers.
TEST(FlowComplex, CountsDoNotDependOnThePlacement) {
  Random random(73);
  for (int round = 0; round < test_rounds(40); ++round) {
    std::vector<Point3> points =
        round % 4 == 0 ? testing::rounded_scan(random, 30, testing::scanned_bumps)
                       : testing::random_points(random, 14, [](Random& r) { return testing::small_integer(r, 2); });
    const FlowComplex flow = flow_complex(points);
    std::shuffle(points.begin(), points.end(), random);
    for (Point3& p : points) p = {4 * p.y + 40, -4 * p.z - 12, 4 * p.x};
    const FlowComplex moved = flow_complex(points);
    ASSERT_EQ(flow.counts(), moved.counts());
    ASSERT_EQ(regular_places(flow).size(), regular_places(moved).size());
  }
}

}  // namespace
}  // namespace quoin
