// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/cell_array.h"
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

  std::span<const TriangulationCell> cells() const { return cells_; }
  bool is_ghost(std::size_t cell) const {
    return cells_[cell].vertices[static_cast<std::size_t>(dimension_)] == vertex_at_infinity;
  }

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
