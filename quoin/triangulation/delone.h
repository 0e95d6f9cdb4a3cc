// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// For each simplex of the triangulation the number of its Delone cell: neighbours of one sphere, of weighted points of
/// one sphere orthogonal to theirs, are of one cell. Ghosts have numbers from `cell_count` on: those of one hull facet
/// of one Delone cell share a number.
struct DeloneLabels {
  std::vector<std::uint32_t> cell_of;  ///< by simplex
  std::uint32_t cell_count = 0;
  /// Weighted points may be in a Delone cell, or in a side or edge of one, without being a corner: ties make them
  /// vertices of the triangulation or hide them, but no point has less power of them alone. By vertex; empty without
  /// weights, where all are corners.
  std::vector<bool> corners;

  bool is_corner(std::uint32_t vertex) const { return corners.empty() || corners[vertex]; }
  std::size_t corner_count(std::size_t vertices) const {
    return corners.empty() ? vertices : static_cast<std::size_t>(std::count(corners.begin(), corners.end(), true));
  }
};

/// O(n) sphere tests. @throws Cancelled
DeloneLabels delone_labels(const Delaunay3& triangulation, const Context& context);
DeloneLabels delone_labels(const Regular3& triangulation, const Context& context);

/// How many faces a Delone complex has, by their dimension; zero above its own.
struct DeloneCounts {
  std::array<std::size_t, 4> faces{};
};

/// O(n), a fraction of the time that making the complex takes: facets of cells by their pairs, edges by Euler's
/// relation.
/// @throws Cancelled
DeloneCounts count_faces(const TriangulationView3& triangulation, const DeloneLabels& labels, const Context& context);

/// The Delone complex: convex cells with all their vertices on an empty sphere, and their facets. It does not depend on
/// any choice among diagonals. Vertices are those of the triangulation; the same points give the same bytes. Of
/// weighted points, the projection of the lower hull of the lifted ones; vertices of the triangulation that are corners
/// of no cell are in no list.
///
/// Of dimension 3 cells are polytopes and facets cocircular polygons; of dimension 2 polygons and edges; of dimension 1
/// edges and points; of dimension 0 one point without facets.
class DeloneComplex {
 public:
  static constexpr std::uint32_t outside = 0xFFFFFFFF;

  /// O(n log n). @throws Cancelled
  DeloneComplex(const Delaunay3& triangulation, const Context& context);
  DeloneComplex(const Regular3& triangulation, const Context& context);

  int dimension() const { return dimension_; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t cell_count() const { return cell_begin_.size() - 1; }
  std::size_t facet_count() const { return facet_begin_.size() - 1; }

  /// Vertices, ascending. Cells ascend by them.
  std::span<const std::uint32_t> cell(std::size_t c) const { return part(cell_vertices_, cell_begin_, c); }
  /// Vertices from the smallest one; of dimension 3 counterclockwise seen from outside the first of its cells.
  std::span<const std::uint32_t> facet(std::size_t f) const { return part(facet_vertices_, facet_begin_, f); }
  /// The cells on both sides, ascending; `outside` is the second one of facets of the hull. Facets ascend by them.
  std::array<std::uint32_t, 2> cells_of_facet(std::size_t f) const { return facet_cells_[f]; }
  /// Of dimension 3 the sides of facets, else facets or cells; each once, the smaller vertex first, ascending.
  std::span<const std::array<std::uint32_t, 2>> edges() const { return edges_; }

 private:
  static std::span<const std::uint32_t> part(const std::vector<std::uint32_t>& list,
                                             const std::vector<std::size_t>& begin, std::size_t i) {
    return {list.data() + begin[i], begin[i + 1] - begin[i]};
  }
  DeloneComplex(const TriangulationView3& triangulation, DeloneLabels labels, const Context& context);
  void collect_cells(const TriangulationView3& triangulation, DeloneLabels& labels);
  void collect_facets(const TriangulationView3& triangulation, const DeloneLabels& labels, const Context& context);
  void collect_edges();

  int dimension_;
  std::size_t vertex_count_;
  std::vector<std::uint32_t> cell_vertices_;
  std::vector<std::size_t> cell_begin_{0};
  std::vector<std::uint32_t> facet_vertices_;
  std::vector<std::size_t> facet_begin_{0};
  std::vector<std::array<std::uint32_t, 2>> facet_cells_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
};

}  // namespace quoin
