// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/flow/flow_reconstruction.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"

namespace quoin::cli {

/// For each point of an output which given points it comes from: the one that it is, or those around it that it was
/// made of.
class PointOrigins {
 public:
  static constexpr std::uint32_t none = ExactColumns::none;

  void add_given(std::uint32_t input) {
    inputs_.push_back(input);
    close(input);
  }
  void add_made(std::span<const std::uint32_t> inputs) {
    inputs_.insert(inputs_.end(), inputs.begin(), inputs.end());
    close(none);
  }
  /// The same from vertices, by the first points there.
  void add_made(std::span<const std::uint32_t> vertices, const Delaunay3& triangulation) {
    for (const std::uint32_t v : vertices) inputs_.push_back(triangulation.inputs(v)[0]);
    close(none);
  }

  /// As one of the others.
  void add(const PointOrigins& others, std::size_t point) {
    const std::span<const std::uint32_t> inputs = others.of(point);
    inputs_.insert(inputs_.end(), inputs.begin(), inputs.end());
    close(others.given_[point]);
  }
  /// All others behind these.
  void add(const PointOrigins& others) {
    for (std::size_t i = 0; i < others.size(); ++i) add(others, i);
  }

  std::size_t size() const { return given_.size(); }
  /// By point: the number of the given point, or none.
  const std::vector<std::uint32_t>& given() const { return given_; }
  std::span<const std::uint32_t> of(std::size_t point) const {
    return std::span(inputs_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
  }

 private:
  void close(std::uint32_t given) {
    given_.push_back(given);
    begin_.push_back(inputs_.size());
  }

  std::vector<std::uint32_t> inputs_;
  std::vector<std::size_t> begin_{0};
  std::vector<std::uint32_t> given_;
};

/// Of vertices, midpoints and constructed points of stable surfaces. Those on a surface are as far from the points of
/// the triangles around them as from any. O(n log n).
PointOrigins origins_of(const FlowMesh& mesh, const Delaunay3& triangulation);

/// What the file says of points: of given ones as it is there, of made ones the exact mean of those they come from,
/// rounded to nearest.
VertexData data_of(const PointFile& file, const PointOrigins& origins);
VertexData data_of(const PointFile& file, std::span<const std::uint32_t> inputs);

/// Normals, colours, `intensity` and `weight` of points.
void add_data(VtkGrid& grid, VertexData data);
/// `red green blue alpha`, `weight`, `intensity`, `nx ny nz`.
void add_data(ExactColumns& columns, const VertexData& data);

}  // namespace quoin::cli
