// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/saddle_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/critical_values.h"
#include "quoin/flow/facet_formulas.h"
#include "quoin/flow/test_flow_names.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/unstable_sheet.h"

namespace quoin {
namespace {

using testing::FlowNames;
using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// Parts of Voronoi edges of Delone polygons; nothing at an end stands for infinity.
using Part = std::pair<std::optional<Rational>, std::optional<Rational>>;
using Parts = std::map<std::uint32_t, std::vector<Part>>;

bool is_lower(const Part& a, const Part& b) {
  if (!a.first || !b.first) return !a.first && b.first;
  return *a.first < *b.first;
}

/// Joins parts that touch, since how they are cut depends on the order in which they are followed.
void join(Parts& parts) {
  for (auto& [polygon, list] : parts) {
    std::sort(list.begin(), list.end(), is_lower);
    std::vector<Part> joined;
    for (const Part& part : list) {
      const bool touches =
          !joined.empty() && (!joined.back().second || !part.first || *part.first <= *joined.back().second);
      if (!touches) {
        joined.push_back(part);
      } else if (joined.back().second && (!part.second || *part.second > *joined.back().second)) {
        joined.back().second = part.second;
      }
    }
    list = joined;
  }
}

/// Sheets of both descriptions, as parts of Voronoi edges of the same polygons.
class Comparison {
 public:
  Comparison(const Delaunay3& triangulation, const FlowComplex& flow, SaddleSheets& sheets)
      : triangulation_(triangulation),
        flow_(flow),
        faces_(flow.faces()),
        names_(triangulation, flow),
        sheets_(sheets) {}

  void check(const FlowCells& cells, std::uint32_t cell, unsigned edge) {
    const auto& v = triangulation_.cells()[cell].vertices;
    const DeloneFace face = names_.of(1, {v[edge_slots[edge][0]], v[edge_slots[edge][1]]});
    const UnstableSheet expected = unstable_sheet(flow_, face.index, context());
    const CellSheet& found = sheets_.follow(cell, edge, context());
    ASSERT_EQ(found.is_infinite, expected.is_infinite);
    ASSERT_EQ(found.is_ordinary(), expected.is_ordinary);
    ASSERT_EQ(named(found.cells), std::set<std::uint32_t>(expected.cells.begin(), expected.cells.end()));
    std::set<std::uint32_t> saddles;
    for (const CellFacet& saddle : found.saddles) {
      ASSERT_TRUE(cells.is_critical_facet(saddle.cell, saddle.slot));
      saddles.insert(names_.of(saddle).index);
    }
    ASSERT_EQ(saddles, std::set<std::uint32_t>(expected.saddles.begin(), expected.saddles.end()));
    Parts a;
    Parts b;
    for (const VoronoiInterval& part : expected.along) a[part.polygon].push_back({part.low, part.high});
    for (const SheetPart& part : found.along) add(part, b);
    join(a);
    join(b);
    ASSERT_EQ(a, b);
    const std::size_t along = count(b);
    a.clear();
    b.clear();
    for (std::size_t i = 1; i < expected.pieces.size(); ++i) {
      const VoronoiInterval& part = *expected.pieces[i].entry;
      a[part.polygon].push_back({part.low, part.high});
    }
    for (std::size_t i = 1; i < found.pieces.size(); ++i) add(found.pieces[i].entry, b);
    join(a);
    join(b);
    ASSERT_EQ(a, b);
    ASSERT_EQ(found.parts, along + count(b));
    pieces += found.pieces.size();
  }

  std::size_t pieces = 0;

 private:
  static std::size_t count(const Parts& parts) {
    std::size_t sum = 0;
    for (const auto& [polygon, list] : parts) sum += list.size();
    return sum;
  }
  std::set<std::uint32_t> named(const std::vector<std::uint32_t>& cells) const {
    std::set<std::uint32_t> found;
    for (const std::uint32_t c : cells) found.insert(names_.of_cell(c).index);
    return found;
  }
  std::optional<Rational> place_of_cell(std::uint32_t polygon, std::uint32_t cell) const {
    if (cell == DeloneFaces::outside) return std::nullopt;
    const std::span<const std::uint32_t> corners = faces_.polygon(polygon);
    for (const std::uint32_t v : faces_.cell(cell)) {
      if (std::find(corners.begin(), corners.end(), v) == corners.end())
        return flow::place_of_cell<Rational>(flow_, polygon, v);
    }
    return std::nullopt;
  }
  void add(const SheetPart& part, Parts& parts) {
    const std::uint32_t polygon = names_.of(part.polygon).index;
    const std::array<std::uint32_t, 2> around = faces_.cells_of_polygon(polygon);
    const bool is_up = around[1] == names_.of_cell(part.polygon.cell).index;
    const auto place = [&](const SheetEnd& end) -> std::optional<Rational> {
      if (end.side != 0) return place_of_cell(polygon, around[(end.side > 0) == is_up ? 1 : 0]);
      const std::span<const std::uint32_t> corners = faces_.polygon(polygon);
      return sheets_.chain().exact_place(end.point, {corners[0], corners[1], corners[2]}) /
             Rational(triangulation_.unscale());
    };
    Part found{place(part.low), place(part.high)};
    if (!is_up) std::swap(found.first, found.second);
    parts[polygon].push_back(found);
  }

  const Delaunay3& triangulation_;
  const FlowComplex& flow_;
  const DeloneFaces& faces_;
  FlowNames names_;
  SaddleSheets& sheets_;
};

struct Seen {
  std::size_t sheets = 0;
  std::size_t pieces = 0;
  std::size_t undecided = 0;
  std::size_t not_ordinary = 0;
};

void check(const std::vector<Point3>& points, Seen& seen) {
  const Delaunay3 triangulation(points, context());
  if (triangulation.dimension() < 3) return;
  const FlowComplex flow(triangulation, context());
  const FlowCells cells(triangulation, context());
  SaddleSheets sheets(cells);
  Comparison comparison(triangulation, flow, sheets);
  const std::size_t step = 1 + cells.counts()[1] / 4;
  std::size_t number = 0;
  cells.for_each_critical_edge(context(), [&](std::uint32_t cell, unsigned edge) {
    if (number++ % step != 0) return;
    ASSERT_NO_FATAL_FAILURE(comparison.check(cells, cell, edge));
    ++seen.sheets;
    seen.not_ordinary += sheets.follow(cell, edge, context()).is_ordinary() ? 0 : 1;
  });
  seen.pieces += comparison.pieces;
  seen.undecided += sheets.crosser().undecided_count();
}

TEST(SaddleSheets, AreThoseOfDeloneFaces) {
  Random random(131);
  Seen seen;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 12)) {
    SCOPED_TRACE(cloud.name);
    ASSERT_NO_FATAL_FAILURE(check(cloud.points, seen));
  }
  for (int round = 0; round < test_rounds(6); ++round) {
    ASSERT_NO_FATAL_FAILURE(
        check(testing::random_points(random, 25, [](Random& r) { return testing::small_integer(r, 3); }), seen));
    ASSERT_NO_FATAL_FAILURE(
        check(testing::random_points(random, 20, [](Random& r) { return testing::small_integer(r, 8); }), seen));
    ASSERT_NO_FATAL_FAILURE(check(testing::random_points(random, 30, testing::unit), seen));
  }
  EXPECT_GT(seen.undecided, 0U);
  EXPECT_GT(seen.not_ordinary, 0U);
  EXPECT_GT(seen.pieces, 2 * seen.sheets);
}

// Fresh parts of all sheets are those of any of them, each once.
TEST(SaddleSheets, TogetherHaveEachPartOnce) {
  Random random(132);
  for (int round = 0; round < test_rounds(6); ++round) {
    const auto coordinate = round % 2 == 0 ? +[](Random& r) { return testing::unit(r); }
                                           : +[](Random& r) { return testing::small_integer(r, 4); };
    const Delaunay3 triangulation(testing::random_points(random, 30, coordinate), context());
    if (triangulation.dimension() < 3) continue;
    const FlowCells cells(triangulation, context());
    SaddleSheets each(cells);
    SaddleSheets fresh(cells, SheetParts::fresh);
    std::set<std::uint32_t> polygons;
    std::set<std::uint32_t> vertices;
    std::set<std::uint32_t> fresh_polygons;
    std::set<std::uint32_t> fresh_vertices;
    std::size_t sum = 0;
    std::size_t parts = 0;
    std::size_t pieces = 0;
    std::size_t fresh_pieces = 0;
    const auto note = [](const CellSheet& sheet, std::set<std::uint32_t>& polygons_seen,
                         std::set<std::uint32_t>& vertices_seen) {
      for (std::size_t i = 1; i < sheet.pieces.size(); ++i)
        polygons_seen.insert(sheet.pieces[i].entry.polygon.number());
      for (const SheetPart& part : sheet.along) polygons_seen.insert(part.polygon.number());
      vertices_seen.insert(sheet.cells.begin(), sheet.cells.end());
    };
    cells.for_each_critical_edge(context(), [&](std::uint32_t cell, unsigned edge) {
      const CellSheet& whole = each.follow(cell, edge, context());
      note(whole, polygons, vertices);
      pieces += whole.pieces.size();
      sum += whole.parts;
      const CellSheet& rest = fresh.follow(cell, edge, context());
      note(rest, fresh_polygons, fresh_vertices);
      fresh_pieces += rest.pieces.size();
      parts = rest.parts;
    });
    ASSERT_EQ(polygons, fresh_polygons);
    ASSERT_EQ(vertices, fresh_vertices);
    ASSERT_LE(parts, sum);
    ASSERT_LE(fresh_pieces, pieces);
  }
}

// Corners of pieces go around convex polygons in planes across their edges.
TEST(SaddleSheets, PiecesAreConvexPolygons) {
  Random random(133);
  const Delaunay3 triangulation(testing::near_sphere(random, 60), context());
  const FlowCells cells(triangulation, context());
  const CriticalValues values(triangulation);
  const Rational unscale(triangulation.unscale());
  SaddleSheets sheets(cells);
  std::size_t checked = 0;
  std::size_t number = 0;
  cells.for_each_critical_edge(context(), [&](std::uint32_t cell, unsigned edge) {
    if (number++ % 3 != 0) return;
    const CellSheet& sheet = sheets.follow(cell, edge, context());
    for (std::size_t i = 0; i < sheet.pieces.size(); i += 3) {
      const CellSheetPiece& piece = sheet.pieces[i];
      if (!piece.is_bounded) continue;
      const std::size_t end = i + 1 < sheet.pieces.size() ? sheet.pieces[i + 1].first_corner : sheet.corners.size();
      std::vector<RationalPoint3> corners;
      for (std::size_t j = piece.first_corner; j < end; ++j) {
        const SheetCorner& corner = sheet.corners[j];
        corners.push_back(corner.is_constructed ? sheets.chain().exact_point(corner.place) * unscale
                                                : values.centre(corner.place));
      }
      ASSERT_GE(corners.size(), 3U);
      const RationalPoint3 p0 = exact_point(triangulation.point(piece.edge[0]));
      const RationalPoint3 along = exact_point(triangulation.point(piece.edge[1])) - p0;
      const RationalPoint3 middle = p0 + along * (Rational(1) / Rational(2));
      std::set<Sign> turns;
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const RationalPoint3& a = corners[j];
        const RationalPoint3& b = corners[(j + 1) % corners.size()];
        const RationalPoint3& c = corners[(j + 2) % corners.size()];
        ASSERT_EQ(dot(a - middle, along), Rational(0));
        turns.insert(dot(cross(b - a, c - b), along).sign());
      }
      ASSERT_EQ(turns.size(), 1U);
      ASSERT_NE(*turns.begin(), Sign::zero);
      ++checked;
    }
  });
  EXPECT_GT(checked, 20U);
}

}  // namespace
}  // namespace quoin
