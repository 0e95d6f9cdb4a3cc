// SPDX-License-Identifier: Apache-2.0
//
// Counts of published maps; what every map promises, checked cell by cell against the polytope; and the way back. The
// map on the sphere, which is made by other code, must give the same facets.
#include "quoin/polytope/cubical_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/polytope/gaussian_map.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;
using Counts = CubicalMap::Counts;
using Location = CubicalMap::Location;
using Place = CubicalMap::Place;

/// Vertices, halfedges, faces, as tables have them.
using Row = std::array<std::size_t, 3>;
Row row(const Counts& counts) {
  return {counts.vertices, 2 * counts.edges, counts.faces};
}

RationalPoint3 on_cube(std::size_t square, const RationalPoint2& p) {
  std::array<Rational, 3> at;
  at[cube::axis(square)] = cube::sign(square);
  at[cube::x_axis(square)] = p.x;
  at[cube::y_axis(square)] = p.y;
  return {at[0], at[1], at[2]};
}

RationalPoint3 point_of(const CubicalMap& map, const Place& place) {
  const LinearArrangement& a = map.squares[place.square].arrangement;
  return on_cube(place.square, a.family().exact(a.point(place.vertex)));
}

/// All vertices of squares.
std::vector<Place> places_of(const CubicalMap& map) {
  std::vector<Place> places;
  for (std::uint32_t s = 0; s < cube::square_count; ++s) {
    const dcel::Dcel& cells = map.squares[s].arrangement.cells();
    for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
      if (cells.is_real(dcel::VertexId(v))) places.push_back({s, dcel::VertexId(v)});
    }
  }
  return places;
}

/// The middle of a face's corners is inside it: its label alone is extreme there.
void check_label(const CubicalMap& map, std::uint32_t s, dcel::FaceId face, const std::vector<RationalPoint3>& points) {
  const CubicalMap::Square& square = map.squares[s];
  const dcel::Dcel& cells = square.arrangement.cells();
  const std::uint32_t label = square.vertex_of_face[face.index()];
  if (cells[face].is_unbounded) {
    EXPECT_EQ(label, CubicalMap::none);
    return;
  }
  ASSERT_LT(label, points.size());
  RationalPoint3 sum;
  const dcel::HalfedgeId first = cells[cells[face].first_boundary].halfedge;
  dcel::HalfedgeId h = first;
  do {
    sum = sum + point_of(map, {s, cells.origin(h)});
    h = cells.next(h);
  } while (h != first);
  const Rational best = dot(points[label], sum);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (v == label) continue;
    ASSERT_LT(dot(points[v], sum), best) << "square " << s << ", face " << face.value;
  }
}

void check_faces(const CubicalMap& map, const std::vector<RationalPoint3>& points) {
  std::map<std::uint32_t, std::size_t> uses;
  for (std::uint32_t s = 0; s < cube::square_count; ++s) {
    const CubicalMap::Square& square = map.squares[s];
    dcel::check_links(square.arrangement.cells());
    for (std::size_t f = 0; f < square.vertex_of_face.size(); ++f) {
      if (!square.arrangement.cells().is_real(dcel::FaceId(f))) continue;
      check_label(map, s, dcel::FaceId(f), points);
      if (square.vertex_of_face[f] != CubicalMap::none) ++uses[square.vertex_of_face[f]];
    }
  }
  EXPECT_EQ(uses.size(), points.size());
}

/// Links lead to the same point; a vertex is real where a normal is, and nowhere else.
void check_vertices(const CubicalMap& map, const MapArcs& arcs) {
  std::vector<std::size_t> uses(arcs.normals.size(), 0);
  for (const Place& place : places_of(map)) {
    const RationalPoint3 at = point_of(map, place);
    Place p = place;
    std::size_t round = 0;
    do {
      ASSERT_EQ(point_of(map, p), at);
      ASSERT_EQ(map[p].facet, map[place].facet);
      p = map[p].next;
      ++round;
    } while (!(p == place) && round < 4);
    const Location location = map[place].location;
    ASSERT_EQ(round, location == Location::corner ? 3U : location == Location::side ? 2U : 1U);
    if (!map[place].is_real()) continue;
    const SphereDirection normal = arcs.normals[map[place].facet];
    const SphereDirection here(std::array<Rational, 3>{at.x, at.y, at.z});
    ASSERT_FALSE(cross(normal, here).is_valid());
    ASSERT_EQ(dot_sign(normal, here), Sign::positive);
    uses[map[place].facet] += 6 / round;
  }
  EXPECT_EQ(uses, std::vector<std::size_t>(arcs.normals.size(), 6));
}

/// Where no normal lies on a side and no arc meets a corner: V = facets + 2 X + 24 and bounded faces = vertices + 4 + X
/// with X crossings of arcs and sides.
void check_generic_counts(const CubicalMap& map, const MapArcs& arcs) {
  if (arcs.arcs.empty()) return;  // a point has no map that hangs together
  std::size_t crossings = 0;
  for (const Place& place : places_of(map)) {
    const std::size_t degree = map.squares[place.square].arrangement.cells().degree(place.vertex);
    if (map[place].location == Location::interior) continue;
    if (map[place].is_real() || degree != (map[place].location == Location::corner ? 2U : 3U)) return;
    if (map[place].location == Location::side) ++crossings;
  }
  const Counts counts = map.counts();
  EXPECT_EQ(counts.vertices, arcs.normals.size() + crossings + 24);
  EXPECT_EQ(counts.faces - 6, arcs.vertex_count + 4 + crossings / 2);
}

CubicalMap checked(const MapArcs& arcs, const std::vector<RationalPoint3>& points) {
  CubicalMap map = cubical_map(arcs, one_thread);
  check_vertices(map, arcs);
  check_faces(map, points);
  check_generic_counts(map, arcs);
  EXPECT_EQ(rings_of(facets_of_map(map)), rings_of(facets_of_map(gaussian_map(arcs, one_thread))));
  EXPECT_EQ(facets_of_map(map).size(), arcs.normals.size());
  return map;
}

CubicalMap checked(const Points& points) {
  const Polytope p = Polytope::hull_of(points, one_thread);
  std::vector<RationalPoint3> vertices;
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) vertices.push_back(exact_point(p.vertex(v)));
  CubicalMap map = checked(map_arcs(p), vertices);
  EXPECT_EQ(rings_of(facets_of_map(map)), rings_of(p));
  return map;
}

// Minkowski thesis, table 3.1.
TEST(CubicalMap, SquaresMeetAtCornersClockwise) {
  for (std::uint8_t s = 0; s < cube::square_count; ++s) {
    for (std::uint8_t c = 0; c < cube::corner_count; ++c) {
      const cube::Corner corner{s, c};
      const cube::Corner next = cube::clockwise(corner);
      EXPECT_EQ(cube::position(next), cube::position(corner));
      EXPECT_EQ(cube::clockwise(cube::clockwise(next)), corner);
      // Clockwise, seen from outside: the outward normals turn the other way about the corner.
      const std::array<int, 3> at = cube::position(corner);
      std::array<std::array<int, 3>, 3> normals{};
      for (const auto& [i, square] : {std::pair{0U, s}, {1U, next.square}, {2U, cube::clockwise(next).square}}) {
        normals[i][cube::axis(square)] = cube::sign(square);
      }
      const auto& [a, b, d] = normals;
      const int determinant =
          a[0] * (b[1] * d[2] - b[2] * d[1]) - a[1] * (b[0] * d[2] - b[2] * d[0]) + a[2] * (b[0] * d[1] - b[1] * d[0]);
      EXPECT_EQ(determinant, -1) << at[0] << at[1] << at[2];
    }
  }
}

// Tables 3.2 and 3.3.
TEST(CubicalMap, PublishedCounts) {
  EXPECT_EQ(row(checked({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}).counts()),
            (Row{24, 48, 12}));
  EXPECT_EQ(row(checked({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).counts()), (Row{24, 60, 18}));
  EXPECT_EQ(row(checked({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).counts()), (Row{33, 78, 18}));
  EXPECT_EQ(row(checked(icosahedron_on_its_pole()).counts()), (Row{72, 192, 36}));
  EXPECT_EQ(row(checked(icosahedron()).counts()), (Row{36, 108, 30}));
  const CubicalMap map = checked(pyramid());
  EXPECT_EQ(row(map.counts()), (Row{97, 280, 55}));
  const Row side{12, 32, 6};
  EXPECT_EQ(row(map.counts(0)), side);
  EXPECT_EQ(row(map.counts(1)), (Row{28, 80, 14}));
  EXPECT_EQ(row(map.counts(2)), side);
  EXPECT_EQ(row(map.counts(3)), side);
  EXPECT_EQ(row(map.counts(4)), (Row{21, 72, 17}));
  EXPECT_EQ(row(map.counts(5)), side);
}

/// An ellipsoid of 16 rings of quadrilaterals: all rings are one polygon of few bits times few bits, so that their
/// quadrilaterals are flat.
Points ellipsoid() {
  constexpr double pi = 3.14159265358979323846;
  const auto rounded = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
  Points points{{0, 0, 2}, {0, 0, -2}};
  for (int j = 1; j < 16; ++j) {
    const double radius = rounded(std::sin(pi * j / 16));
    const double z = j == 8 ? 0 : rounded(2 * std::cos(pi * j / 16));
    for (int i = 0; i < 32; ++i) {
      const double x = rounded(std::cos(pi * i / 16));
      const double y = rounded(std::sin(pi * i / 16));
      points.push_back({radius * x, radius * y, z});
    }
  }
  return points;
}

TEST(CubicalMap, OfTheEllipsoid) {
  const Polytope p = Polytope::hull_of(ellipsoid(), one_thread);
  ASSERT_EQ(p.vertex_count(), 482U);
  ASSERT_EQ(p.edge_count(), 992U);
  const CubicalMap map = cubical_map(p, one_thread);
  EXPECT_EQ(row(map.counts()), (Row{776, 2752, 612}));
  EXPECT_EQ(rings_of(facets_of_map(map)), rings_of(p));
}

// Table 3.4.
TEST(CubicalMap, OfASumOfEqualsIsThatOfOne) {
  const Polytope p = Polytope::hull_of(icosahedron_on_its_pole(), one_thread);
  const PolytopeSum sum = minkowski_sum(p, p, one_thread);
  const CubicalMap map = checked(map_arcs(sum, p, p), exact_vertices(sum, p, p));
  EXPECT_EQ(row(map.counts()), (Row{72, 192, 36}));
}

TEST(CubicalMap, OfRandomSums) {
  for (std::uint64_t seed = 0; seed < test_rounds(30U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points a = on_a_small_grid(random, 4, 6);
    const Points b = on_a_small_grid(random, 4, 6);
    if (convex_hull(a, one_thread).dimension < 3 || convex_hull(b, one_thread).dimension < 2) continue;
    const Polytope p = Polytope::hull_of(a, one_thread);
    const Polytope q = Polytope::hull_of(b, one_thread);
    const PolytopeSum sum = minkowski_sum(p, q, one_thread);
    const CubicalMap map = checked(map_arcs(sum, p, q), exact_vertices(sum, p, q));
    std::vector<std::vector<std::uint32_t>> facets;
    for (std::size_t f = 0; f < sum.facet_count(); ++f) facets.emplace_back(sum.facet(f).begin(), sum.facet(f).end());
    EXPECT_EQ(rings_of(facets_of_map(map)), rings_of(facets));
    if (HasFailure()) return;
  }
}

// Small grids: many normals lie on sides and corners of squares, and arcs along sides.
TEST(CubicalMap, OfRandomPolytopesAndBack) {
  std::size_t on_sides = 0;
  std::size_t on_corners = 0;
  std::size_t along_sides = 0;
  for (std::uint64_t seed = 0; seed < test_rounds(120U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Points points = on_a_small_grid(random, 4, 16);
    if (convex_hull(points, one_thread).dimension < 2) continue;
    const CubicalMap map = checked(points);
    for (const Place& place : places_of(map)) {
      on_sides += map[place].is_real() && map[place].location == Location::side ? 1 : 0;
      on_corners += map[place].is_real() && map[place].location == Location::corner ? 1 : 0;
    }
    for (const CubicalMap::Square& square : map.squares) {
      for (std::size_t e = 0; e < square.arc_of_edge.size(); ++e) {
        const dcel::EdgeId edge(e);
        along_sides += square.arrangement.cells().is_real(edge) && square.arrangement.curves(edge).size() > 1 ? 1 : 0;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GE(on_sides, test_cases(1U));
  EXPECT_GE(on_corners, test_cases(1U));
  EXPECT_GE(along_sides, test_cases(1U));
}

TEST(CubicalMap, OfFlatOnes) {
  checked({{0, 0, 0}, {4, 0, 1}, {0, 4, 2}, {4, 4, 3}});
  checked({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  checked({{0, 0, 0}, {0, 1, 1}, {1, 0, 1}});
  checked({{1, 0, 0}, {-1, 0, 0}, {0, 1, -1}, {0, -1, 1}});
}

TEST(CubicalMap, OfCoordinatesOfAllSizes) {
  checked({{1e300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1}, {0, 0, 0}});
  checked({{0x1p-1074, 0, 0}, {0, 1e308, 0}, {-1e308, 0, 0x1p-1074}, {0, -1, 0x1p-1074}});
}

TEST(CubicalMap, CanBeCancelled) {
  const Polytope p = Polytope::hull_of(pyramid(), one_thread);
  Context context({.threads = 1});
  context.cancel();
  EXPECT_THROW(cubical_map(p, context), Cancelled);
}

// All directions are those of its only vertex, as on the sphere.
TEST(CubicalMap, OfAPoint) {
  for (const Points& points : {Points{{1, 2, 3}}, Points{{0, 0, 0}, {0, 0, 0}}}) {
    const CubicalMap map = checked(points);
    EXPECT_EQ(row(map.counts()), (Row{24, 48, 12}));
    EXPECT_TRUE(facets_of_map(map).empty());
    for (const CubicalMap::Square& square : map.squares) {
      EXPECT_EQ(std::ranges::count(square.vertex_of_face, 0U), 1);
    }
  }
}

// Arcs are needed to tell several vertices apart.
TEST(CubicalMap, RefusesVerticesWithoutArcs) {
  MapArcs arcs;
  arcs.vertex_count = 2;
  EXPECT_THROW(cubical_map(arcs, one_thread), InternalError);
}

TEST(CubicalMap, OfNothingIsSixEmptySquares) {
  const CubicalMap map = cubical_map(MapArcs{}, one_thread);
  EXPECT_EQ(row(map.counts()), (Row{24, 48, 12}));
  EXPECT_TRUE(facets_of_map(map).empty());
}

}  // namespace
}  // namespace quoin
