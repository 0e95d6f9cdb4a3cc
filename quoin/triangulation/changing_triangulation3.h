// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/changing_cells3.h"
#include "quoin/triangulation/changing_points3.h"
#include "quoin/triangulation/changing_weighted_points3.h"
#include "quoin/triangulation/delaunay_walks.h"

namespace quoin {

/// Cells with vertices numbered along a Hilbert curve, as those of Delaunay3 and Regular3 are.
struct NumberedCells {
  std::vector<std::uint32_t> ids;  ///< of each number
  CellArray cells;
};

/// What ChangingDelaunay3 and ChangingRegular3 have in common: triangulations of space, of any affine dimension, -1
/// without points, to which points are added and from which they are taken away.
///
/// Points are known by ids, which stay while they live, and are used again after; the one at infinity is
/// vertex_at_infinity. Cells are numbered without gaps, anew with each change. A change that ends with an exception,
/// for want of memory too, leaves points and cells as they were. One that was moved from may be destroyed or assigned
/// to, and no more. `Points` are ChangingPoints3 or ChangingWeightedPoints3, which say what a point is.
template <class Points>
class ChangingTriangulation3 {
 public:
  /// Takes away one of the points of an id, which goes with the last. The star of a vertex is filled anew (Devillers
  /// and Teillaud 2011): O(d log d) expected for d neighbours and hidden points of the star spread evenly, O(d^2) at
  /// worst; O(n) where the dimension is below 2, O(n log n) where it falls.
  /// @throws InputError  there is no such point
  /// @throws Cancelled   through `context`, where one is given
  void remove(std::uint32_t v);
  void remove(std::uint32_t v, const Context& context);

  int dimension() const { return dimension_; }
  /// Ids that live, of hidden points too.
  std::size_t vertex_count() const { return points_.count(); }
  /// One past the largest id.
  std::size_t id_count() const { return points_.id_count(); }
  bool lives(std::uint32_t v) const { return points_.multiplicity(v) > 0; }
  Point3 point(std::uint32_t v) const { return points_.original(v); }
  std::uint32_t multiplicity(std::uint32_t v) const { return points_.multiplicity(v); }

  /// In dimension 3, cells and ghosts; else none.
  std::span<const TriangulationCell> cells() const;
  /// In dimension 3, some cell of a living vertex; a ghost, of vertex_at_infinity; the cell that holds a hidden point.
  std::uint32_t cell_of(std::uint32_t v) const { return cells_.cell_of(v); }
  /// In dimension 3, all cells of a living vertex or of infinity, ghosts too, in no order. O(d) for d cells.
  /// @throws InputError if there is no such vertex, it is hidden, or the dimension is below 3
  std::vector<std::uint32_t> star(std::uint32_t v) const;
  /// In dimension 2 and 3, all living vertices that share an edge with one or with infinity, ascending. O(d log d)
  /// @throws InputError if there is no such vertex, it is hidden, or the dimension is below 2
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  /// The smallest face that a point is in: O(1) expected in dimension 3 for points spread evenly; below, of flat_cells,
  /// which are made anew: O(n). Who asks often there finds points in a Delaunay3 or Regular3 with a DelaunayLocator.
  /// @throws InputError if the point is not finite, or there is no vertex
  DelaunayLocation locate(const Point3& p) const;
  /// In dimension 0 and 1 the vertices in lexicographic order, but for hidden ones.
  std::span<const std::uint32_t> line() const;
  /// In dimension 0 to 2, cells of lower dimension as those of Delaunay3 and Regular3 are, of ids. Made anew: O(n).
  CellArray flat_cells() const;
  /// What Delaunay3 gives in canonical order, or Regular3 and sort_cells, for the points that are there, byte by byte:
  /// of equal points the heaviest. O(n log n)
  NumberedCells canonical_cells(const Context& context) const;

 protected:
  using Site = typename Points::Site;
  using Signs = typename Points::Signs;

  ChangingTriangulation3() = default;

  /// The id of a point, which is finite and without negative zeros: a new one, or the one that is there, once more.
  std::uint32_t insert_site(const Site& site, const Context& context);
  /// Finds the dimension of points whose ids are numbers of vertices, and in dimension 2 and 3 four that are not
  /// coplanar, of which the last may be the apex. `begin_line` must follow in dimension 0 and 1, cells in others.
  std::array<std::uint32_t, 4> begin(const Context& context);
  void begin_line(const Context& context);
  void require_vertex(std::uint32_t v) const;
  static const Context& no_context();

  Points points_;
  ChangingCells3<Signs> cells_;  ///< in dimension 2 of the apex, too
  int dimension_ = -1;

 private:
  /// In dimension 0 and 1, points in the order of `Points::is_before`, and those that are not hidden, where any may be.
  struct Line {
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> shown;
  };

  void set_line(Line line);
  Line line_of(std::vector<std::uint32_t> all, const Context& context) const;
  std::vector<std::uint32_t> sorted_without(std::uint32_t v) const;
  std::uint32_t insert_on_line(const Site& site, const Context& context);
  std::uint32_t insert_off_line(const Site& site, const Context& context);
  std::uint32_t insert_off_plane(const Site& site, bool is_beyond);
  std::uint32_t insert_among_cells(const Site& site, const Context& context);
  void remove_from_cells(std::uint32_t v, const Context& context);
  void fall_to_plane(std::uint32_t v, const Context& context);
  void fall_to_line(std::uint32_t v, const Context& context);
  int side_of_plane(const Point3& p) const;
  DelaunayLocation locate_among_flat(const Point3& p) const;

  Line line_;
};

}  // namespace quoin
