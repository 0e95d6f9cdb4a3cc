// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/triangulation_view2.h"

namespace quoin {

/// A Delone cell: a convex polygon, all corners of which lie on one empty circle, with all points on that circle. Of
/// weighted points, all corners of which have the same power of its centre, and no point has less.
using DeloneCell2 = Id<struct DeloneCell2Tag>;

/// The Delone complex of the plane: triangles of a Delaunay triangulation merged where they share their circle. Nothing
/// here depends on which diagonals the triangulation chose. Cells are numbered by their smallest corner and the one
/// after it. In dimension 0 and 1 there are no cells.
///
/// Weighted points may be in a cell, or in a side of one, without being a corner: ties make them vertices of the
/// triangulation or hide them, but no point has less power of them alone.
/// Source: Delone 1934; the merging as in the analysis of degenerate flow, Cazals, Parameswaran and Pion 2008.
class Delone2 {
 public:
  /// One exact circle test for each finite edge. O(n log n) at worst, O(n) for bounded degrees.
  /// @throws Cancelled
  explicit Delone2(const Delaunay2& delaunay, const Context& context = Context());
  explicit Delone2(const Regular2& regular, const Context& context = Context());

  std::size_t cell_count() const { return begin_.size() - 1; }
  /// Counterclockwise, the smallest first; three or more.
  std::span<const Vertex2> corners(DeloneCell2 cell) const {
    return std::span(corners_).subspan(begin_[cell.index()], begin_[cell.index() + 1] - begin_[cell.index()]);
  }
  /// Whether a vertex is a corner of cells, in dimension 1 an end of the edges of the complex: without weights all are.
  bool is_corner(Vertex2 v) const { return is_corner_.empty() || is_corner_[v.index()]; }
  /// Of a finite triangle; none of an infinite one.
  DeloneCell2 cell(Triangle2 t) const { return cell_of_[t.index()]; }
  /// Some triangle in a cell.
  Triangle2 triangle(DeloneCell2 cell) const { return triangle_[cell.index()]; }
  /// Whether the edge lies inside a cell, so that other choices of diagonals would not have it.
  bool is_inner(const Triangulation2& links, Edge2 e) const {
    const DeloneCell2 left = cell(e.triangle());
    return !left.is_none() && left == cell(links.twin(e).triangle());
  }

 private:
  class Builder;

  std::vector<std::uint32_t> begin_;
  std::vector<Vertex2> corners_;
  std::vector<DeloneCell2> cell_of_;
  std::vector<Triangle2> triangle_;
  std::vector<bool> is_corner_;  ///< of weighted points
};

}  // namespace quoin
