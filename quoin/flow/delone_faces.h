// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/delone.h"

namespace quoin {

/// A face of the Delone complex, and its dual: the open face of the Voronoi diagram of the points that are nearest to
/// the vertices of the face and to no others. The dual has dimension 3 - dimension.
struct DeloneFace {
  unsigned dimension = 0;   ///< 0 vertex, 1 edge, 2 polygon, 3 cell
  std::uint32_t index = 0;  ///< among the faces of its dimension
  friend bool operator==(const DeloneFace&, const DeloneFace&) = default;
  friend auto operator<=>(const DeloneFace&, const DeloneFace&) = default;
};

/// A polygon around an edge, with a vertex of it that is off the edge.
struct RingPolygon {
  std::uint32_t polygon;
  std::uint32_t apex;
  std::uint32_t side;  ///< place of the edge among the sides of the polygon
};

/// Vertices, edges, polygons and cells of the Delone complex of points of any affine dimension, and which is a face of
/// which. In a plane the polygons are the largest faces, on a line the edges. Copies what it needs of the
/// triangulation.
class DeloneFaces {
 public:
  static constexpr std::uint32_t outside = DeloneComplex::outside;

  /// O(n log n) for n faces. @throws Cancelled
  DeloneFaces(const Delaunay3& triangulation, const Context& context);

  int dimension() const { return dimension_; }
  std::size_t count(unsigned dimension) const;

  std::array<std::uint32_t, 2> edge(std::uint32_t e) const { return edges_[e]; }
  /// Corners in cyclic order; in space counterclockwise seen from outside the first of its cells.
  std::span<const std::uint32_t> polygon(std::uint32_t f) const { return part(corners_, polygon_begin_, f); }
  /// Edges of a polygon: the one at place i goes from corner i to the next.
  std::span<const std::uint32_t> sides(std::uint32_t f) const { return part(sides_, polygon_begin_, f); }
  /// Where the corners of polygon f begin in a list of the corners of all polygons.
  std::size_t first_corner(std::uint32_t f) const { return polygon_begin_[f]; }
  std::array<std::uint32_t, 2> cells_of_polygon(std::uint32_t f) const { return polygon_cells_[f]; }
  /// Vertices of a cell, ascending.
  std::span<const std::uint32_t> cell(std::uint32_t c) const { return part(cell_vertices_, cell_begin_, c); }
  std::span<const std::uint32_t> polygons_of_cell(std::uint32_t c) const {
    return part(cell_polygons_, cell_polygons_begin_, c);
  }
  /// Polygons around an edge, in ascending order of their numbers.
  std::span<const RingPolygon> ring(std::uint32_t e) const {
    return {ring_.data() + ring_begin_[e], ring_begin_[e + 1] - ring_begin_[e]};
  }
  std::span<const std::uint32_t> edges_of_vertex(std::uint32_t v) const {
    return part(vertex_edges_, vertex_edges_begin_, v);
  }
  /// Vertices of a face of any dimension.
  std::span<const std::uint32_t> vertices(DeloneFace face) const;

  /// Place of an edge among the sides of a polygon that has it.
  std::size_t side_of(std::uint32_t f, std::uint32_t edge) const;
  /// A corner of the polygon that is not on its side at this place.
  std::uint32_t apex(std::uint32_t f, std::size_t side) const;
  /// The two polygons of a cell that share an edge of it.
  std::array<std::uint32_t, 2> polygons_at_edge(std::uint32_t cell, std::uint32_t edge) const;
  /// The cell of two polygons that share an edge; `outside` if there is none.
  std::uint32_t common_cell(std::uint32_t f, std::uint32_t g) const;

 private:
  template <class List>
  static std::span<const std::uint32_t> part(const List& list, const std::vector<std::size_t>& begin, std::size_t i) {
    return {list.data() + begin[i], begin[i + 1] - begin[i]};
  }
  void take_space(const DeloneComplex& complex);
  void take_plane(const DeloneComplex& complex);
  void find_sides(const Context& context);
  void find_incidences();

  int dimension_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> sides_;
  std::vector<std::size_t> polygon_begin_{0};
  std::vector<std::array<std::uint32_t, 2>> polygon_cells_;
  std::vector<std::uint32_t> cell_vertices_;
  std::vector<std::size_t> cell_begin_{0};
  std::vector<std::uint32_t> cell_polygons_;
  std::vector<std::size_t> cell_polygons_begin_{0};
  std::vector<RingPolygon> ring_;
  std::vector<std::size_t> ring_begin_{0};
  std::vector<std::uint32_t> vertex_edges_;
  std::vector<std::size_t> vertex_edges_begin_{0};
};

}  // namespace quoin
