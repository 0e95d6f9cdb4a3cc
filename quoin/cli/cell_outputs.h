// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/vtk_grid.h"

namespace quoin::cli {

/// Writes the outputs of a command about cells of points: VTK from `grid`, meshes from `mesh`, which are made only if
/// they are asked for. What meshes do not hold goes to `warnings`.
void write_cells(const std::function<VtkGrid()>& grid, const std::function<Mesh()>& mesh, const Options& options,
                 std::vector<std::string>& warnings, const Context& context);

}  // namespace quoin::cli
