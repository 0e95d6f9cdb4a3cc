// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// Cells of VTK, by its numbers. A polygon has its corners in order; a polyhedron the number of its faces, then for
/// each of them the number of its corners and these.
enum class VtkCell : std::uint8_t {
  vertex = 1,
  line = 3,
  triangle = 5,
  polygon = 7,
  tetrahedron = 10,
  polyhedron = 42
};

/// An unstructured grid: cells over points, and numbers for each.
struct VtkGrid {
  static constexpr std::uint32_t none = 0xFFFFFFFF;  ///< of a whole number that is not there: written as -1

  std::vector<Point3> points;
  std::vector<std::uint32_t> cells;  ///< one after the other
  std::vector<std::size_t> cell_begin{0};
  std::vector<VtkCell> types;  ///< one per cell
  using Integers = std::pair<std::string, std::vector<std::uint32_t>>;
  using Doubles = std::pair<std::string, std::vector<double>>;
  std::vector<Integers> point_integers;  ///< names without blanks; a number per point
  std::vector<Integers> cell_integers;   ///< a number per cell
  std::vector<Doubles> point_doubles;
  std::vector<Doubles> cell_doubles;
  std::vector<Vector3> normals;  ///< empty, or one per point
  std::vector<Color> colors;     ///< empty, or one per point

  void add_cell(VtkCell type, std::span<const std::uint32_t> numbers) {
    cells.insert(cells.end(), numbers.begin(), numbers.end());
    cell_begin.push_back(cells.size());
    types.push_back(type);
  }
};

/// Writes VTK's legacy format, version 3.0, text; coordinates are the shortest decimals that read back to the same
/// doubles. O(size).
/// @throws InputError  a point, or a number of a point or cell, is not finite; Cancelled
void write_vtk(std::ostream& out, const VtkGrid& grid, const std::string& title, const Context& context);

}  // namespace quoin
