// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/cli/options.h"
#include "quoin/io/drawing.h"
#include "quoin/io/mesh_file.h"

namespace quoin::cli {

/// What an output is to hold.
struct Target {
  enum class Kind {
    mesh,
    grid,
    simplices,
    cells,
    page,
    exact,
    drawing,
    planar,
    planar_exact,
    picture,
    planar_page,
    report
  };
  std::string name;
  Kind kind = Kind::mesh;
  MeshFormat format = MeshFormat::off;               ///< of Kind::mesh
  DrawingFormat planar_format = DrawingFormat::wkt;  ///< of Kind::planar

  bool is_stream() const { return name == standard_stream; }
};

/// Whether a command is about curves and regions of the plane.
bool is_planar(const std::string& command);

/// The outputs by their endings, in any case; "-" by options.format, OFF without one (SVG for `section`).
/// @throws UsageError  an ending or format that the command does not write
std::vector<Target> targets_of(const Options& options);

/// Whether some output is to hold this.
bool writes(const Options& options, Target::Kind kind);

/// Refuses what targets_of refuses, a format that no output takes, and pages where the view is not built in.
void require_known_targets(const Options& options);

/// Standard input can be read once and standard output hold one file. @throws UsageError
void require_single_use_of_streams(const Options& options);

/// An operand of `csg`.
struct NamedInput {
  std::string name;
  std::string file;
};

/// The inputs of `csg`. @throws UsageError  an input is not NAME=FILE, or a name is given twice
std::vector<NamedInput> named_inputs(const Options& options);

}  // namespace quoin::cli
