// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "quoin/arrangement/circular/circular_location.h"
#include "quoin/arrangement/geodesic/geodesic_location.h"
#include "quoin/arrangement/location/walk_locator.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

std::string name(Location l) {
  const char* kinds[] = {"vertex ", "edge ", "face "};
  return kinds[static_cast<int>(l.kind())] + std::to_string(l.index());
}

// Circles.

TEST(PointLocation, CirclesAndSegments) {
  for (unsigned seed = 0; seed < test_rounds(60U); ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](unsigned bound) { return static_cast<double>(random() % bound); };
    CircularFamily family;
    PieceList<CircularFamily> list;
    for (unsigned i = 0; i < 2 + seed % 12; ++i) {
      const Point2 a{pick(7), pick(7)};
      const Point2 b{random() % 3 == 0 ? a.x : pick(7), pick(7)};
      const auto kind = random() % 4;
      if (kind <= 1) {
        family.add_circle(list, a, 0.5 * (1 + pick(8)));
      } else if (kind == 2 && !(a == b)) {
        family.add_segment(list, a, b);
      } else {
        family.add_point(list, a);
      }
    }
    const CircularArrangement a = arrange(std::move(family), list, Context());
    std::vector<CircularPoint> queries;
    for (std::size_t i = 0; i < a.vertex_count(); ++i) {
      queries.push_back(a.point(dcel::VertexId(i)));
      const Point2 p = a.family().position(a.point(dcel::VertexId(i)));
      queries.push_back(CircularFamily::query(p));
      queries.push_back(CircularFamily::query(Point2{p.x, p.y + 0x1p-45}));
      queries.push_back(CircularFamily::query(Point2{p.x - 0x1p-45, p.y}));
    }
    for (double x = -2; x <= 9; x += 0.5) {
      for (double y = -2; y <= 9; y += 0.5) queries.push_back(CircularFamily::query(Point2{x, y}));
    }
    const NaiveLocator<CircularFamily> naive(a);
    const WalkLocator<CircularFamily> walk(a);
    const TrapezoidLocator<CircularFamily> trapezoids(a);
    const GridLocator<CircularFamily> grid(a);
    const std::vector<Location> batch = locate_batch(a, std::span<const CircularPoint>(queries), Context());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " (" << queries[i].x << ", " << queries[i].y << ")");
      const std::string expected = name(naive.locate(queries[i]));
      ASSERT_EQ(name(walk.locate(queries[i])), expected);
      ASSERT_EQ(name(trapezoids.locate(queries[i])), expected);
      ASSERT_EQ(name(grid.locate(queries[i])), expected);
      ASSERT_EQ(name(batch[i]), expected);
      for (const Direction direction : {Direction::down, Direction::up}) {
        const std::string hit = name(naive.shoot(queries[i], direction));
        ASSERT_EQ(name(trapezoids.shoot(queries[i], direction)), hit);
        ASSERT_EQ(name(walk.shoot(queries[i], direction)), hit);
      }
    }
  }
}

/// Circles in a cell of many columns and rows: grids that see turning points.
TEST(PointLocation, ManyCircles) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  CircularFamily family;
  PieceList<CircularFamily> list;
  for (int i = 0; i < 400; ++i) family.add_circle(list, Point2{unit(random), unit(random)}, 0.001 + 0.1 * unit(random));
  const CircularArrangement a = arrange(std::move(family), list, Context());
  std::vector<CircularPoint> queries;
  for (int i = 0; i < 20000; ++i) queries.push_back(CircularFamily::query(Point2{unit(random), unit(random)}));
  const GridLocator<CircularFamily> grid(a);
  const TrapezoidLocator<CircularFamily> trapezoids(a);
  const std::vector<Location> batch = locate_batch(a, std::span<const CircularPoint>(queries), Context());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ASSERT_EQ(name(grid.locate(queries[i])), name(batch[i])) << i;
    ASSERT_EQ(name(trapezoids.locate(queries[i])), name(batch[i])) << i;
  }
}

// Spheres.

using Triple = std::array<std::int64_t, 3>;

struct SphereInput {
  std::vector<std::pair<Triple, Triple>> arcs;  // ends
  std::vector<Triple> circles;                  // normals
  std::vector<Triple> points;
};

/// Coordinates exchanged in a cycle `turns` times: the poles and the identification lie elsewhere.
Triple turned(const Triple& v, int turns) {
  Triple result;
  for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>((i + turns) % 3)] = v[static_cast<std::size_t>(i)];
  return result;
}

bool is_parallel(const Triple& a, const Triple& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

SphereInput random_input(unsigned seed) {
  std::mt19937 random(seed);
  const auto pick = [&] {
    for (;;) {
      Triple v;
      for (auto& c : v) c = static_cast<std::int64_t>(random() % 5) - 2;
      if (v != Triple{}) return v;
    }
  };
  SphereInput input;
  for (unsigned i = 0; i < 1 + seed % 9; ++i) {
    const auto kind = random() % 6;
    const Triple a = pick();
    const Triple b = pick();
    if (kind == 0 && seed % 3 == 0) {
      input.circles.push_back(a);
    } else if (kind == 1 || is_parallel(a, b)) {
      input.points.push_back(a);
    } else {
      input.arcs.emplace_back(a, b);
    }
  }
  return input;
}

/// Where all directions with small integers lie, by each strategy the same.
std::vector<Location> locate_everywhere(const SphereInput& input, int turns) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (const auto& arc : input.arcs) family.add_arc(list, turned(arc.first, turns), turned(arc.second, turns));
  for (const Triple& normal : input.circles) family.add_great_circle(list, turned(normal, turns));
  for (const Triple& p : input.points) family.add_point(list, turned(p, turns));
  std::vector<GeodesicFamily::Point> queries;
  for (std::int64_t x = -3; x <= 3; ++x) {
    for (std::int64_t y = -3; y <= 3; ++y) {
      for (std::int64_t z = -3; z <= 3; ++z) {
        if (x != 0 || y != 0 || z != 0) queries.push_back(family.make_point(turned({x, y, z}, turns)));
      }
    }
  }
  const GeodesicArrangement a = arrange(std::move(family), list, Context());
  const std::size_t directions = queries.size();
  for (std::size_t i = 0; i < a.edge_count(); ++i) {  // both copies of points on the identification
    queries.push_back(a.left_point(dcel::EdgeId(i)));
    queries.push_back(a.right_point(dcel::EdgeId(i)));
  }
  const NaiveLocator<GeodesicFamily> naive(a);
  const WalkLocator<GeodesicFamily> walk(a);
  const TrapezoidLocator<GeodesicFamily> trapezoids(a);
  std::vector<Location> batch = locate_batch(a, std::span<const GeodesicFamily::Point>(queries), Context());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const std::string expected = name(naive.locate(queries[i]));
    EXPECT_EQ(name(walk.locate(queries[i])), expected) << "query " << i;
    EXPECT_EQ(name(trapezoids.locate(queries[i])), expected) << "query " << i;
    EXPECT_EQ(name(batch[i]), expected) << "query " << i;
    if (i >= directions) {
      const std::size_t end = i - directions;
      EXPECT_EQ(batch[i], end % 2 == 0 ? Location(a.left(dcel::EdgeId(end / 2))) : a.right(dcel::EdgeId(end / 2)));
    }
  }
  batch.resize(directions);
  return batch;
}

/// Turning the sphere over its poles and its identification keeps which directions share a face; edges are cut
/// elsewhere.
TEST(PointLocation, TurnedSpheresHaveTheSameFaces) {
  for (unsigned seed = 0; seed < test_rounds(150U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const SphereInput input = random_input(seed);
    const std::vector<Location> first = locate_everywhere(input, 0);
    for (const int turns : {1, 2}) {
      const std::vector<Location> other = locate_everywhere(input, turns);
      std::map<Location, Location> partner;
      std::map<Location, Location> back;
      for (std::size_t i = 0; i < first.size(); ++i) {
        SCOPED_TRACE(::testing::Message() << "turns " << turns << " query " << i);
        ASSERT_EQ(other[i].is_face(), first[i].is_face());
        if (!first[i].is_face()) continue;
        ASSERT_EQ(partner.emplace(first[i], other[i]).first->second, other[i]);
        ASSERT_EQ(back.emplace(other[i], first[i]).first->second, first[i]);
      }
    }
    if (HasFailure()) return;
  }
}

/// Every face of a sphere has cells, neighbours lie in one face and name each other.
TEST(VerticalDecomposition, OfSpheres) {
  for (unsigned seed = 0; seed < test_rounds(150U); ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const SphereInput input = random_input(seed);
    GeodesicFamily family;
    PieceList<GeodesicFamily> list;
    for (const auto& arc : input.arcs) family.add_arc(list, arc.first, arc.second);
    for (const Triple& normal : input.circles) family.add_great_circle(list, normal);
    for (const Triple& p : input.points) family.add_point(list, p);
    const GeodesicArrangement a = arrange(std::move(family), list, Context());
    const std::vector<PseudoTrapezoid> cells = decompose_vertically(a, {}, Context()).trapezoids;
    std::vector<bool> is_covered(a.face_count(), false);
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
      is_covered[cells[i].face.index()] = true;
      if (!cells[i].top.is_none()) {
        ASSERT_EQ(cells[i].face, a.cells().face(dcel::HalfedgeId(cells[i].top, true)));
      }
      if (cells[i].upper_right != PseudoTrapezoid::none) {
        ASSERT_EQ(cells[cells[i].upper_right].upper_left, i);
        ASSERT_EQ(cells[cells[i].upper_right].face, cells[i].face);
      }
      if (cells[i].lower_right != PseudoTrapezoid::none) {
        ASSERT_EQ(cells[cells[i].lower_right].lower_left, i);
        ASSERT_EQ(cells[cells[i].lower_right].face, cells[i].face);
      }
    }
    for (std::size_t f = 0; f < a.face_count(); ++f) ASSERT_TRUE(is_covered[f]) << "face " << f;
  }
}

}  // namespace
}  // namespace quoin
