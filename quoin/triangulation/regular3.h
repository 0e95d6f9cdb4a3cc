// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/regular_signs.h"
#include "quoin/triangulation/vertex_points.h"

namespace quoin {

struct AffineBasis;

/// The regular triangulation (weighted Delaunay triangulation) of points of space, of any affine dimension.
///
/// Each point has a weight, the square of a radius; with equal weights this is the Delaunay triangulation. A point is
/// hidden, and no vertex of any cell, if it is above the lower hull of all points lifted by their square less their
/// weight. Of equal points the heaviest counts. Exact, cells and their numbers as of Delaunay3; ties are broken alike,
/// so that a point on the lower hull is hidden only where the perturbation lifts it above.
class Regular3 {
 public:
  /// As many weights as points. @throws InputError without points, with another number of weights, naming a point or
  /// weight that is not finite, or when there is too little memory; Cancelled
  Regular3(std::span<const Point3> points, std::span<const double> weights, const Context& context);

  int dimension() const { return dimension_; }
  /// Distinct points, hidden ones among them.
  std::size_t vertex_count() const { return vertex_count_; }
  Point3 point(std::uint32_t vertex) const { return points_.original(vertex); }
  double weight(std::uint32_t vertex) const { return weights_[vertex]; }
  std::span<const std::uint32_t> inputs(std::uint32_t vertex) const { return points_.inputs_of(vertex); }
  bool is_hidden(std::uint32_t vertex) const { return is_hidden_[vertex]; }
  /// Of all vertices, in the order of their numbers; where all lie in a plane, a point off it at the end.
  std::span<const Point3> points() const { return points_.all(); }
  /// Of these points.
  std::span<const double> weights() const { return weights_; }

  std::span<const TriangulationCell> cells() const { return cells_; }
  bool is_ghost(std::size_t cell) const {
    return cells_[cell].vertices[static_cast<std::size_t>(dimension_)] == vertex_at_infinity;
  }

  /// Where a vertex of the same flat, lifted by its square less its weight, is: positive below the lifted cell, a
  /// finite one, zero beside it in one flat. `signs` is what `signs()` gave.
  int power_side(const RegularSigns& signs, std::size_t cell, std::uint32_t vertex) const;
  /// Predicates on the vertices, by their numbers, while this object lives and does not move. O(n) to make.
  RegularSigns signs() const { return {points_.all(), weights_, dimension_ == 2}; }

 private:
  void take_weights(std::span<const double> weights);
  void triangulate(const AffineBasis& basis, const Context& context);
  std::vector<std::uint32_t> visible_chain(const Context& context);

  VertexPoints points_;
  std::vector<double> weights_;
  std::vector<bool> is_hidden_;
  CellArray cells_;
  std::size_t vertex_count_;
  int dimension_ = 0;
};

}  // namespace quoin
