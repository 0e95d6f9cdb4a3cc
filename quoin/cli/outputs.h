// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/cli/topology_report.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/exit.h"

namespace quoin::cli {

/// What became of a result on its way to files.
struct OutputReport {
  Rounding rounding = Rounding::exact;  ///< the worst of all files
  double max_displacement = 0;
  unsigned rounds = 0;
  std::vector<TopologyChange> topology_changes;
  std::shared_ptr<const Brep> resolved;  ///< null, or what the first mesh file holds that needed rounds of snapping
  /// Outputs that were not written: rounding failed or changed the topology, and that was not accepted.
  std::vector<std::string> refusals;
  std::vector<std::string> notes;  ///< what else is to be known about the files
};

/// Writes the boundary to every output: meshes by their ending, .html as a page of the view, .qsolid exactly.
/// Meshes are certified, unless options.accept_rounding, and have maximal faces as polygons where that loses nothing.
/// @throws FileError; InputError for an unbounded solid as a mesh
OutputReport write_outputs(const Brep& boundary, const std::string& title, const Options& options,
                           const Context& context);

/// A triangulated boundary as a mesh, with polygons for the faces that may stand as such.
Mesh to_mesh(const Brep& boundary, const Triangulated& triangles, const std::string& name, bool with_polygons);

}  // namespace quoin::cli
