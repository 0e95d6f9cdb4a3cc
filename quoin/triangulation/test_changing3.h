// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "quoin/triangulation/changing_delaunay3.h"
#include "quoin/triangulation/check3.h"
#include "quoin/triangulation/delaunay3.h"

/// Triangulations of space that change, beside those that do not.
namespace quoin::testing {

inline std::string reproduce(const std::vector<Point3>& points) {
  std::string text;
  char buffer[120];
  for (const Point3& p : points) {
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a}, ", p.x, p.y, p.z);
    text += buffer;
  }
  return text;
}

using Corner = std::array<double, 3>;

/// Coordinates of the corners of all cells, sorted; infinity at a place of its own.
template <class PointOf>
std::vector<std::array<Corner, 4>> corners_of(std::span<const TriangulationCell> cells, const PointOf& point_of) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  std::vector<std::array<Corner, 4>> found;
  for (const TriangulationCell& cell : cells) {
    std::array<Corner, 4> corners;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t v = cell.vertices[i];
      if (v >= vertex_at_infinity) {
        corners[i] = {beyond, v == vertex_at_infinity ? 0.0 : 1.0, 0};
      } else {
        const Point3 p = point_of(v);
        corners[i] = {p.x, p.y, p.z};
      }
    }
    std::ranges::sort(corners);
    found.push_back(corners);
  }
  std::ranges::sort(found);
  return found;
}

/// Byte by byte.
inline bool are_same_cells(std::span<const TriangulationCell> one, std::span<const TriangulationCell> other) {
  return std::ranges::equal(one, other, [](const auto& a, const auto& b) {
    return a.vertices == b.vertices && a.neighbours == b.neighbours;
  });
}

/// The cells are those of the points, vertices know their cells, and nothing is counted wrong.
inline void expect_same(const ChangingDelaunay3& changing, const std::vector<Point3>& points) {
  std::size_t living = 0;
  std::size_t given = 0;
  for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
    if (!changing.lives(v)) continue;
    ++living;
    given += changing.multiplicity(v);
    if (changing.dimension() < 3) continue;
    const auto& corners = changing.cells()[changing.cell_of(v)].vertices;
    ASSERT_NE(std::ranges::find(corners, v), corners.end());
  }
  ASSERT_EQ(given, points.size());
  ASSERT_EQ(living, changing.vertex_count());
  const Context context({.threads = 1});
  if (points.empty()) {
    ASSERT_EQ(changing.dimension(), -1);
    ASSERT_TRUE(changing.cells().empty() && changing.flat_cells().empty() && changing.line().empty());
    return;
  }
  const Delaunay3 delaunay(points, context, {.is_canonical = true});
  ASSERT_EQ(changing.dimension(), delaunay.dimension());
  ASSERT_EQ(changing.vertex_count(), delaunay.vertex_count());
  const CellArray flat = changing.flat_cells();
  ASSERT_EQ(flat.empty(), changing.dimension() == 3);
  const std::span<const TriangulationCell> cells = flat.empty() ? changing.cells() : flat;
  ASSERT_EQ(corners_of(cells, [&](std::uint32_t v) { return changing.point(v); }),
            corners_of(delaunay.cells(), [&](std::uint32_t v) { return delaunay.point(v); }));
  // So are their links: byte by byte, in canonical order.
  const NumberedCells numbered = changing.canonical_cells(context);
  std::vector<Point3> along_curve;
  for (const std::uint32_t v : numbered.ids) along_curve.push_back(changing.point(v));
  for (std::uint32_t v = 0; v < along_curve.size(); ++v) ASSERT_EQ(along_curve[v], delaunay.point(v));
  ASSERT_TRUE(are_same_cells(numbered.cells, delaunay.cells()));
  ASSERT_EQ(defect_of_cells(numbered.cells, changing.dimension(), along_curve, context), "");
  if (changing.dimension() == 3) {
    ASSERT_TRUE(std::ranges::count(cells[changing.cell_of(vertex_at_infinity)].vertices, vertex_at_infinity) == 1);
  }
}

/// Points that are there, and the vertex of each.
template <class Site>
struct PresentSites {
  std::vector<Site> points;
  std::vector<std::uint32_t> vertices;

  void add(const Site& p, std::uint32_t v) {
    points.push_back(p);
    vertices.push_back(v);
  }
  void erase(std::size_t which) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(which));
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(which));
  }
};
using Present = PresentSites<Point3>;

}  // namespace quoin::testing
