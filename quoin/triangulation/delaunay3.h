// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/delaunay_signs.h"
#include "quoin/triangulation/vertex_points.h"

namespace quoin {

struct AffineBasis;
struct InsertionSplit;

struct DelaunayOptions {
  /// Cells in canonical order: then the same points give the same bytes in all versions. Takes about half as long as
  /// the triangulation.
  bool is_canonical = false;
};

/// The Delaunay triangulation of points of space, of any affine dimension from 0 to 3.
///
/// Exact for all finite doubles in any position. Equal points are one vertex, which knows all of them. Vertices are
/// numbered along a Hilbert curve, whatever the order in which points are given. Where more than dimension + 2 points
/// lie on one sphere, the triangulation is the one in which lexicographically larger points are lifted infinitely
/// higher; that depends on the points alone, too, but has no meaning: see DeloneComplex for what has.
///
/// Simplices of dimension d use the first d + 1 slots of a TriangulationCell; a ghost has the vertex at infinity in
/// slot d. Of dimension 3, see there; of dimension 2, triangles are all oriented alike.
/// Expected O(n log n) for points that are not on few curves; at most 250 bytes per point for large inputs that are not
/// too thin. Source: Bowyer 1981; Watson 1981; Amenta, Choi and Rote 2003; Devillers and Teillaud 2011.
class Delaunay3 {
 public:
  /// @throws InputError without points, naming a point that is not finite, or when there is too little memory
  /// @throws Cancelled
  Delaunay3(std::span<const Point3> points, const Context& context, const DelaunayOptions& options = {});

  int dimension() const { return dimension_; }
  /// Distinct points.
  std::size_t vertex_count() const { return vertex_count_; }
  /// As it was given, but for the sign of zero.
  Point3 point(std::uint32_t vertex) const { return points_.original(vertex); }
  /// The points of all vertices times one power of two, in the order of their numbers; where all lie in a plane, a
  /// point off it at the end.
  std::span<const Point3> scaled_points() const { return points_.all(); }
  /// What gives the points back from the scaled ones.
  double unscale() const { return points_.unscale; }
  /// Numbers of the given points that are this vertex, ascending.
  std::span<const std::uint32_t> inputs(std::uint32_t vertex) const { return points_.inputs_of(vertex); }

  /// Ghosts among them.
  std::span<const TriangulationCell> cells() const { return cells_; }
  bool is_ghost(std::size_t cell) const {
    return cells_[cell].vertices[static_cast<std::size_t>(dimension_)] == vertex_at_infinity;
  }
  std::size_t finite_cell_count() const;

  /// Sign of the test of the sphere, circle or segment of a finite cell with a vertex of the same flat: positive
  /// inside. `signs` is what `signs()` gave.
  int in_sphere(const DelaunaySigns& signs, std::size_t cell, std::uint32_t vertex) const;
  /// Predicates on the vertices, by their numbers, while this object lives and does not move. O(n) to make.
  DelaunaySigns signs() const { return {points_.all(), dimension_ == 2}; }

 private:
  void triangulate(const AffineBasis& basis, const InsertionSplit& split, const Context& context);
  std::vector<std::uint32_t> chain() const;

  VertexPoints points_;  ///< in a plane, with a point off it at the end
  CellArray cells_;
  std::size_t vertex_count_;
  int dimension_ = 0;
};

}  // namespace quoin
