// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/number/rational.h"

namespace quoin::cli {

/// A Voronoi diagram as the command reports it, or a power diagram of weighted points: of the plane, or of space where
/// points may lie in a plane or on a line, so that all cells are infinite. Sites are the distinct points that have a
/// cell, by some numbers.
class NearestCells {
 public:
  NearestCells() = default;
  NearestCells(const NearestCells&) = delete;
  NearestCells& operator=(const NearestCells&) = delete;
  virtual ~NearestCells() = default;

  /// Numbers of vertices, edges, and of space facets; dimension.
  virtual nlohmann::ordered_json counts() const = 0;
  /// Distinct points: more than sites where weights hide some.
  virtual std::size_t place_count() const = 0;
  virtual std::size_t site_count() const = 0;
  /// Numbers of the points at a site that have its weight, ascending.
  virtual std::span<const std::uint32_t> inputs(std::uint32_t site) const = 0;
  virtual bool is_bounded(std::uint32_t site) const = 0;
  std::size_t bounded_count() const;
  /// Volume or area of a bounded cell, exact. May be asked by several threads.
  virtual Rational size(std::uint32_t site) const = 0;
  /// Pairs of sites whose cells share a facet, of the plane an edge.
  virtual std::vector<std::array<std::uint32_t, 2>> neighbours(const Context& context) const = 0;

  /// Adds a bounded cell to a grid, with the corners that it has not yet. Corners are rounded to nearest.
  virtual void add_cell(std::uint32_t site, VtkGrid& grid) = 0;
  /// All bounded faces: corners, edges, of space facets, then the bounded cells in an order of sites; corners are
  /// exact. Cells have the number `input` of their site, what lies between two of them also `neighbour`.
  virtual ExactCells bounded_faces(std::span<const std::uint32_t> order, const Context& context) const = 0;
  /// The bounded facets, each once, or the bounded cells of the plane.
  virtual Mesh mesh(const Context& context) = 0;
};

/// Of the plane if `of_plane`; prepared for the corners of all cells if `is_written`. @throws what triangulations throw
std::unique_ptr<NearestCells> nearest_cells(const PointFile& file, bool of_plane, bool is_written,
                                            const Context& context);

/// What is made of cells: a list in the report, outputs, some of them exact.
struct MemoryUse {
  bool is_weighted = false;
  bool is_listed = false;
  bool is_written = false;
  bool is_exact = false;
};

/// About the most memory that it takes at a time, in bytes.
std::uint64_t memory_of_nearest_cells(std::size_t points, bool of_plane, const MemoryUse& use);

}  // namespace quoin::cli
