// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/cell_outputs.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/io/cells_text.h"
#include "quoin/view/layered_page.h"

namespace quoin::cli {

namespace {

void require_finite(const Mesh& mesh) {
  for (const Point3& p : mesh.vertices) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError("a corner is beyond the largest double: meshes cannot hold it");
  }
}

void write_cell_mesh(const Target& target, const CellMesh& made, std::vector<std::string>& warnings,
                     const Context& context) {
  require_finite(made.mesh);
  if (made.mesh.face_count() == 0) warnings.push_back(target.name + ": there are no faces to write");
  WriteReport report;
  write_target(target,
               [&](std::ostream& out) { report = write_mesh(out, target.format, made.mesh, context, made.data); });
  for (const std::string& what : report.dropped_vertex_data)
    warnings.push_back(target.name + ": the format holds no " + what + " of vertices");
}

void write_one(const Target& target, const CellOutputs& outputs, const Options& options,
               std::vector<std::string>& warnings, const Context& context) {
  if (target.kind == Target::Kind::grid) {
    const VtkGrid made = outputs.grid();
    const std::string title = "quoin " + options.command + " of " + planar_title(options);
    write_target(target, [&](std::ostream& out) { write_vtk(out, made, title, context); });
  } else if (target.kind == Target::Kind::simplices) {
    write_target(target, outputs.text);
  } else if (target.kind == Target::Kind::cells) {
    const ExactCells made = outputs.cells();
    context.progress("writing", 0);
    write_target(target, [&](std::ostream& out) { write_cells_text(out, made, context); });
  } else if (target.kind == Target::Kind::drawing) {
    write_target(target, outputs.drawing);
  } else if (target.kind == Target::Kind::page) {
    if (!outputs.page) throw InputError("there is no page of this: vtk, ply, obj and off hold it");
    LayeredScene made = outputs.page();
    made.title = title_of(options.inputs[0]);
    context.progress("writing", 0);
    write_target(target, [&](std::ostream& out) { write_layered_page(out, made); });
  } else {
    write_cell_mesh(target, outputs.mesh(), warnings, context);
  }
}

}  // namespace

void CellMesh::add_vertex(const PointFile& file, std::uint32_t input) {
  mesh.vertices.push_back(file.points[input]);
  if (!file.normals.empty()) data.normals.push_back(file.normals[input]);
  if (!file.colors.empty()) data.colors.push_back(file.colors[input]);
  if (!file.intensities.empty()) data.intensities.push_back(file.intensities[input]);
  if (!file.weights.empty()) data.weights.push_back(file.weights[input]);
}

void write_cells(const CellOutputs& outputs, const Options& options, std::vector<std::string>& warnings,
                 const Context& context) {
  for (const Target& target : targets_of(options)) {
    const bool is_picture = target.kind == Target::Kind::picture || target.kind == Target::Kind::planar_page;
    if (is_picture) continue;  // of the plane: by `write_picture`
    context.progress("writing", 0);
    try {
      write_one(target, outputs, options, warnings, context);
    } catch (const InputError& error) {
      throw InputError(target.name + ": " + error.what());
    }
  }
}

}  // namespace quoin::cli
