// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/critical_values.h"
#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_surfaces.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/test_flow_names.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/unstable_arcs.h"

namespace quoin {
namespace {

using testing::Random;
using Names = testing::FlowNames;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

using Piece = std::tuple<std::uint32_t, std::uint32_t, RationalPoint3, RationalPoint3, bool>;

bool less(const RationalPoint3& a, const RationalPoint3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Pieces with exact points, in an order of their own.
void sort(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    if (std::get<0>(a) != std::get<0>(b)) return std::get<0>(a) < std::get<0>(b);
    if (std::get<1>(a) != std::get<1>(b)) return std::get<1>(a) < std::get<1>(b);
    if (std::get<2>(a) != std::get<2>(b)) return less(std::get<2>(a), std::get<2>(b));
    return less(std::get<3>(a), std::get<3>(b));
  });
}

void check_surface(const FlowComplex& flow, SaddleSurfaces& surfaces, const Delaunay3& triangulation, CellFacet saddle,
                   std::uint32_t polygon) {
  StableSurface expected = stable_surface(flow, polygon, context());
  const SurfacePieces& found = surfaces.follow(saddle, context());
  ASSERT_EQ(found.has_voronoi_vertex, expected.has_voronoi_vertex);
  ASSERT_EQ(found.has_solid_part, expected.has_solid_part);
  ASSERT_EQ(found.has_regular_point, expected.has_regular_point);
  std::multiset<std::pair<std::array<std::uint32_t, 2>, unsigned>> sides;
  for (const StableSide& side : expected.sides) sides.insert({flow.faces().edge(side.edge), side.depth});
  std::vector<Piece> a;
  std::vector<Piece> b;
  for (std::size_t i = 0; i + 1 < expected.triangles.size(); i += 2) {
    const StableTriangle& t = expected.triangles[i];
    const std::uint32_t other = expected.triangles[i + 1].vertex;
    a.emplace_back(std::min(t.vertex, other), std::max(t.vertex, other), expected.points.exact(t.towards),
                   expected.points.exact(t.from), false);
  }
  const Rational unscale(triangulation.unscale());
  const RationalPoint3 origin{};
  for (const SurfacePiece& piece : found.pieces) {
    const std::array<std::uint32_t, 2> edge{std::min(piece.edge[0], piece.edge[1]),
                                            std::max(piece.edge[0], piece.edge[1])};
    const RationalPoint3 middle =
        (exact_point(triangulation.point(edge[0])) + exact_point(triangulation.point(edge[1]))) *
        (Rational(1) / Rational(2));
    const auto place = [&](std::uint32_t node) {
      return node == CrossingChain::none ? middle : surfaces.chain().exact_point(node) * unscale;
    };
    b.emplace_back(edge[0], edge[1], place(piece.towards), place(piece.from), false);
    if (piece.is_side) {
      const auto at = sides.find({edge, piece.depth});
      ASSERT_NE(at, sides.end());
      sides.erase(at);
    }
  }
  ASSERT_TRUE(sides.empty());
  sort(a);
  sort(b);
  ASSERT_TRUE(a == b);
}

void check_arcs(const FlowComplex& flow, const Names& names, ArcTracer& tracer, SaddleArcs& arcs, CellFacet saddle,
                std::uint32_t polygon) {
  std::vector<std::tuple<bool, DeloneFace, std::size_t, bool>> a;
  std::vector<std::tuple<bool, DeloneFace, std::size_t, bool>> b;
  for (const UnstableArc& arc : tracer.trace(polygon, context()).arcs) {
    const bool is_maximum = !arc.is_infinite && arc.end.dimension == 3;
    a.emplace_back(arc.is_infinite, is_maximum ? arc.end : DeloneFace{}, arc.segments, arc.has_passed_regular);
  }
  for (const SaddleEnd& end : arcs.ends(saddle, context())) {
    const bool is_maximum = end.kind == SaddleEnd::Kind::maximum;
    b.emplace_back(end.kind == SaddleEnd::Kind::infinity, is_maximum ? names.of_cell(end.cell) : DeloneFace{},
                   end.segments, end.has_passed_regular);
    ASSERT_TRUE(!is_maximum || flow.is_critical(names.of_cell(end.cell)));
  }
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  ASSERT_EQ(a, b);
}

struct Seen {
  std::size_t undecided = 0;
  std::size_t large_cells = 0;
  std::size_t not_ordinary = 0;
  std::size_t regular = 0;
};

/// The survey of simplices says what the complex of Delone faces says.
void check(const std::vector<Point3>& points, Seen& seen) {
  const Delaunay3 triangulation(points, context());
  if (triangulation.dimension() < 3) {
    ASSERT_THROW(FlowCells(triangulation, context()), InputError);
    return;
  }
  const FlowComplex flow(triangulation, context());
  const FlowCells cells(triangulation, context());
  ASSERT_EQ(cells.counts(), flow.counts());
  const Names names(triangulation, flow);
  std::set<DeloneFace> saddles;
  for (std::uint32_t c = 0; c < triangulation.cells().size(); ++c) {
    if (triangulation.is_ghost(c)) continue;
    const DeloneFace face = names.of_cell(c);
    seen.large_cells += cells.first_of(c) != c ? 1 : 0;
    ASSERT_EQ(names.of_cell(cells.first_of(c)), face);
    const CellWay way = cells.way(c);
    const DeloneFace crossed = flow.crossed(face);
    ASSERT_EQ(way.kind == CellWay::Kind::facet, crossed.dimension == 2);
    ASSERT_EQ(way.kind == CellWay::Kind::edge, crossed.dimension == 1);
    ASSERT_EQ(way.kind == CellWay::Kind::maximum, flow.is_critical(face));
    ASSERT_TRUE(way.kind != CellWay::Kind::facet || names.of(CellFacet{way.cell, way.place}) == crossed);
  }
  std::set<DeloneFace> regular;
  for (const CellFacet& f : cells.regular_polygons(context())) ASSERT_TRUE(regular.insert(names.of(f)).second);
  for (const std::uint32_t c : cells.regular_cells(context())) ASSERT_TRUE(regular.insert(names.of_cell(c)).second);
  const std::vector<DeloneFace> expected = flow.faces_of_kind(FlowKind::regular);
  ASSERT_EQ(regular, std::set<DeloneFace>(expected.begin(), expected.end()));
  seen.regular += regular.size();
  SaddleSurfaces surfaces(cells);
  SaddleArcs arcs(cells);
  ArcTracer tracer(flow);
  cells.for_each_saddle(context(), [&](CellFacet saddle) {
    const DeloneFace polygon = names.of(saddle);
    ASSERT_TRUE(saddles.insert(polygon).second);
    ASSERT_TRUE(flow.is_critical(polygon));
    ASSERT_NO_FATAL_FAILURE(check_surface(flow, surfaces, triangulation, saddle, polygon.index));
    ASSERT_NO_FATAL_FAILURE(check_arcs(flow, names, tracer, arcs, saddle, polygon.index));
    seen.not_ordinary += surfaces.follow(saddle, context()).is_ordinary() ? 0 : 1;
  });
  seen.undecided += arcs.crosser().undecided_count() + surfaces.crosser().undecided_count();
}

TEST(FlowCells, SayWhatDeloneFacesSay) {
  Random random(101);
  Seen seen;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 25)) {
    SCOPED_TRACE(cloud.name);
    ASSERT_NO_FATAL_FAILURE(check(cloud.points, seen));
  }
  for (int round = 0; round < test_rounds(10); ++round) {
    ASSERT_NO_FATAL_FAILURE(
        check(testing::random_points(random, 30, [](Random& r) { return testing::small_integer(r, 3); }), seen));
    ASSERT_NO_FATAL_FAILURE(
        check(testing::random_points(random, 20, [](Random& r) { return testing::small_integer(r, 8); }), seen));
    ASSERT_NO_FATAL_FAILURE(check(testing::random_points(random, 40, testing::unit), seen));
  }
  EXPECT_GT(seen.undecided, 0U);
  EXPECT_GT(seen.large_cells, 0U);
  EXPECT_GT(seen.not_ordinary, 0U);
  EXPECT_GT(seen.regular, 0U);
}

TEST(FlowCells, NearPointsAreNear) {
  Random random(103);
  std::size_t compared = 0;
  for (double (*coordinate)(Random&) :
       {+[](Random& r) { return testing::unit(r); }, +[](Random& r) { return testing::small_integer(r, 40); }}) {
    const Delaunay3 triangulation(testing::random_points(random, 200, coordinate), context());
    const FlowCells cells(triangulation, context());
    SaddleSurfaces surfaces(cells);
    cells.for_each_saddle(context(), [&](CellFacet saddle) {
      surfaces.follow(saddle, context());
      for (std::uint32_t i = surfaces.chain().size(); i-- > 0;) {
        const Point3 first = triangulation.point(surfaces.chain().triangle(i)[0]);
        const RationalPoint3 near = exact_point(surfaces.chain().near_point(i));
        const RationalPoint3 exact = surfaces.chain().exact_point(i);
        const RationalPoint3 off = exact - near;
        const Rational most =
            std::max({Rational(std::max({std::fabs(first.x), std::fabs(first.y), std::fabs(first.z)})), abs(exact.x),
                      abs(exact.y), abs(exact.z)});
        for (unsigned axis = 0; axis < 3; ++axis) {
          ASSERT_LE(abs(off[axis]), most * Rational(0x1p-30));
        }
        ++compared;
      }
    });
  }
  EXPECT_GT(compared, 1000U);
}

// Along the ways the distance to the points grows, up to roundings; they lead from each Voronoi vertex to the next.
TEST(FlowCells, WaysLeadAway) {
  Random random(102);
  const std::vector<Point3> points = testing::near_sphere(random, 150);
  const Delaunay3 triangulation(points, context());
  const FlowCells cells(triangulation, context());
  const CriticalValues values(triangulation);
  SaddleArcs arcs(cells);
  cells.for_each_saddle(context(), [&](CellFacet saddle) { arcs.ends(saddle, context()); });
  const auto distance = [&](const Point3& p) {
    double least = HUGE_VAL;
    for (const Point3& q : points) least = std::min(least, std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
    return least;
  };
  std::size_t constructed = 0;
  for (std::uint32_t c = 0; c < cells.cells().size(); ++c) {
    if (cells.is_ghost(c)) continue;
    const std::optional<ArcLeg> leg = arcs.way_on(c, context());
    if (!leg) continue;
    double before = distance(to_nearest_doubles(values.centre(c)));
    constructed += leg->points.size();
    for (const Point3& p : leg->points) {
      ASSERT_GT(distance(p), before * (1 - 1e-12));
      before = distance(p);
    }
    const double last = leg->next ? distance(to_nearest_doubles(values.centre(*leg->next))) : before;
    ASSERT_GE(last, before * (1 - 1e-12));
  }
  EXPECT_GT(constructed, 10U);
}

// The closed formula of lattices: all their faces are critical.
TEST(FlowCells, Lattices) {
  for (const auto& [x, y, z] : {std::array{2, 2, 2}, {3, 3, 3}, {2, 3, 4}, {10, 10, 10}}) {
    const Delaunay3 triangulation(testing::lattice(x, y, z), context());
    const auto n = [](int a, int b, int c) { return static_cast<std::size_t>(a) * b * c; };
    EXPECT_EQ(FlowCells(triangulation, context()).counts(),
              (std::array{n(x, y, z), n(x - 1, y, z) + n(x, y - 1, z) + n(x, y, z - 1),
                          n(x - 1, y - 1, z) + n(x - 1, y, z - 1) + n(x, y - 1, z - 1), n(x - 1, y - 1, z - 1)}));
  }
}

}  // namespace
}  // namespace quoin
