// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// A mesh over points of a file, and what this says of its vertices.
struct CellMesh {
  CellMesh() = default;
  CellMesh(Mesh of_cells) : mesh(std::move(of_cells)) {}  // NOLINT(google-explicit-constructor): nothing is known

  Mesh mesh;
  VertexData data;

  /// Adds a point of the file as a vertex.
  void add_vertex(const PointFile& file, std::uint32_t input);
};

/// What goes to outputs, made only if it is asked for.
struct CellOutputs {
  std::function<VtkGrid()> grid;
  std::function<CellMesh()> mesh;
  std::function<ExactCells()> cells;             ///< of .qcells
  std::function<void(std::ostream&)> text{};     ///< of commands that write .txt
  std::function<LayeredScene()> page{};          ///< of commands that write .html; the title is set here
  std::function<void(std::ostream&)> drawing{};  ///< of commands that write .svg beside cells
};

/// Writes the outputs of a command about cells of points. What meshes do not hold goes to `warnings`.
void write_cells(const CellOutputs& outputs, const Options& options, std::vector<std::string>& warnings,
                 const Context& context);

}  // namespace quoin::cli
