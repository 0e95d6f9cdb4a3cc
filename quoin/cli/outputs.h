// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/exit.h"

namespace quoin::cli {

/// What became of a result on its way to files.
struct OutputReport {
  Rounding rounding = Rounding::exact;  ///< the worst of all files
  double max_displacement = 0;
  unsigned rounds = 0;
  std::vector<std::string> refusals;  ///< outputs that were not written: rounding failed and was not accepted
  std::vector<std::string> notes;     ///< what else is to be known about the files
};

/// Writes the boundary to every output: meshes by their ending, .html as a page of the view, .qsolid exactly.
/// Certified, unless options.accept_rounding. @throws FileError; InputError for an unbounded solid as a mesh
OutputReport write_outputs(const Brep& boundary, const std::string& title, const Options& options,
                           const Context& context);

/// A triangulated boundary as a mesh.
Mesh to_mesh(const Brep& boundary, const Triangulated& triangles, const std::string& name);

}  // namespace quoin::cli
