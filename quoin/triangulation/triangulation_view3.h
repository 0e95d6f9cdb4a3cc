// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/regular3.h"

namespace quoin {

/// What a Delaunay triangulation of space and a regular one have in common, for what is read from either: cells, points
/// and weights, which are zero of points that have none. The triangulation must outlive it and not move.
class TriangulationView3 {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): either is meant wherever the view is asked for.
  TriangulationView3(const Delaunay3& t)
      : cells_(t.cells()),
        points_(t.scaled_points()),
        unscale_(t.unscale()),
        vertex_count_(t.vertex_count()),
        dimension_(t.dimension()) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  TriangulationView3(const Regular3& t)
      : cells_(t.cells()),
        points_(t.points()),
        weights_(t.weights()),
        vertex_count_(t.vertex_count()),
        dimension_(t.dimension()) {}
  /// Cells with vertices of such numbers, of which there may be more; without weights.
  TriangulationView3(std::span<const TriangulationCell> cells, std::span<const Point3> points, int dimension)
      : cells_(cells), points_(points), vertex_count_(points.size()), dimension_(dimension) {}

  int dimension() const { return dimension_; }
  /// Distinct points, hidden ones among them.
  std::size_t vertex_count() const { return vertex_count_; }
  Point3 point(std::uint32_t vertex) const {
    const Point3& p = points_[vertex];
    return {p.x * unscale_, p.y * unscale_, p.z * unscale_};
  }
  bool is_weighted() const { return !weights_.empty(); }
  double weight(std::uint32_t vertex) const { return weights_.empty() ? 0 : weights_[vertex]; }

  std::span<const TriangulationCell> cells() const { return cells_; }
  bool is_ghost(std::size_t cell) const {
    return cells_[cell].vertices[static_cast<std::size_t>(dimension_)] == vertex_at_infinity;
  }

 private:
  std::span<const TriangulationCell> cells_;
  std::span<const Point3> points_;
  std::span<const double> weights_;
  double unscale_ = 1;
  std::size_t vertex_count_;
  int dimension_;
};

}  // namespace quoin
