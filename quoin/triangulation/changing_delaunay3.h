// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/changing_cells3.h"
#include "quoin/triangulation/changing_points3.h"
#include "quoin/triangulation/delaunay_walks.h"

namespace quoin {

/// Cells with vertices numbered along a Hilbert curve, as those of Delaunay3 are.
struct NumberedCells {
  std::vector<std::uint32_t> ids;  ///< of each number
  CellArray cells;
};

/// A Delaunay triangulation of space to which points are added and from which they are taken away; of any affine
/// dimension, -1 without points.
///
/// Exact; at any time its cells are those of Delaunay3 of the points that are there, ties included, whatever was done
/// before. Vertices are known by ids, which stay while they live, and are used again after; the one at infinity is
/// vertex_at_infinity. Cells are numbered without gaps, anew with each change. A change that ends with an exception,
/// for want of memory too, leaves points and cells as they were. One that was moved from may be destroyed or assigned
/// to, and no more.
class ChangingDelaunay3 {
 public:
  ChangingDelaunay3() = default;
  /// The id of a vertex is its number in Delaunay3. @throws as Delaunay3, but takes no points for none
  explicit ChangingDelaunay3(std::span<const Point3> points, const Context& context = Context());

  /// The vertex of the point: a new one, or the one that is there, once more. O(1) expected on average for points
  /// spread evenly; O(n) where the dimension is below 2 or grows.
  /// @throws InputError  the point is not finite, or there are more than 2^30 vertices or cells
  /// @throws Cancelled   through `context`, where one is given
  std::uint32_t insert(const Point3& p);
  std::uint32_t insert(const Point3& p, const Context& context);
  /// Takes away one of the points at a vertex; the vertex goes with the last. Its star is filled anew (Devillers and
  /// Teillaud 2011): O(d log d) expected for d neighbours spread evenly, O(d^2) at worst; O(n) where the dimension is
  /// below 2, O(n log n) where it falls.
  /// @throws InputError  there is no such vertex
  /// @throws Cancelled   through `context`, where one is given
  void remove(std::uint32_t v);
  void remove(std::uint32_t v, const Context& context);

  int dimension() const { return dimension_; }
  /// Vertices that live.
  std::size_t vertex_count() const { return points_.count(); }
  /// One past the largest id.
  std::size_t id_count() const { return points_.id_count(); }
  bool lives(std::uint32_t v) const { return points_.multiplicity(v) > 0; }
  Point3 point(std::uint32_t v) const { return points_.original(v); }
  std::uint32_t multiplicity(std::uint32_t v) const { return points_.multiplicity(v); }

  /// In dimension 3, cells and ghosts; else none.
  std::span<const TriangulationCell> cells() const;
  /// In dimension 3, some cell of a living vertex; a ghost, of vertex_at_infinity.
  std::uint32_t cell_of(std::uint32_t v) const { return cells_.cell_of(v); }
  /// In dimension 3, all cells of a living vertex or of infinity, ghosts too, in no order. O(d) for d cells.
  /// @throws InputError if there is no such vertex, or the dimension is below 3
  std::vector<std::uint32_t> star(std::uint32_t v) const;
  /// In dimension 2 and 3, all living vertices that share an edge with one or with infinity, ascending. O(d log d)
  /// @throws InputError if there is no such vertex, or the dimension is below 2
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  /// In dimension 3, the smallest face that a point is in. O(1) expected for points spread evenly.
  /// @throws InputError if the point is not finite, or the dimension below 3
  DelaunayLocation locate(const Point3& p) const;
  /// The living vertex of least distance, of equal ones the one of the smallest id; as `locate`, but O(n) where the
  /// dimension is below 2. @throws InputError if the point is not finite, or there is no vertex
  std::uint32_t nearest(const Point3& p) const;
  /// In dimension 0 and 1 the vertices in lexicographic order.
  std::span<const std::uint32_t> line() const { return line_; }
  /// In dimension 0 to 2, cells of lower dimension as those of Delaunay3 are, of ids. Made anew: O(n).
  CellArray flat_cells() const;
  /// What Delaunay3 gives in canonical order for the points that are there, byte by byte. O(n log n)
  NumberedCells canonical_cells(const Context& context) const;

 private:
  void require_vertex(std::uint32_t v) const;
  std::uint32_t insert_on_line(const Point3& p, const Context& context);
  std::uint32_t insert_off_line(const Point3& p, const Context& context);
  std::uint32_t insert_off_plane(const Point3& p, bool is_beyond);
  std::uint32_t insert_among_cells(const Point3& p, const Context& context);
  void fall_to_plane(std::uint32_t v, const Context& context);
  void fall_to_line(std::uint32_t v);
  int side_of_plane(const Point3& p) const;

  ChangingPoints3 points_;
  ChangingCells3 cells_;  ///< in dimension 2 of the apex, too
  std::vector<std::uint32_t> line_;
  int dimension_ = -1;
};

}  // namespace quoin
