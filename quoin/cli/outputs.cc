// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "quoin/base/error.h"
#include "quoin/cli/scene_of_solid.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/io/exact_text.h"
#include "quoin/io/mesh_file.h"
#include "quoin/view/page.h"

namespace quoin::cli {

namespace {

class OutputWriter {
 public:
  OutputWriter(const Brep& boundary, std::string title, const Options& options, const Context& context)
      : boundary_(boundary), title_(std::move(title)), options_(options), context_(context) {}

  OutputReport run() {
    for (const Target& target : targets_of(options_)) write(target);
    return std::move(report_);
  }

 private:
  const Triangulated& triangles(Precision precision) {
    std::optional<Triangulated>& result = precision == Precision::binary64 ? doubles_ : floats_;
    if (!result) {
      ExitOptions exit;
      exit.precision = precision;
      result = triangulate_boundary(boundary_, exit, context_);
      report_.rounding = std::max(report_.rounding, result->rounding);
      report_.max_displacement = std::max(report_.max_displacement, result->max_displacement);
      report_.rounds = std::max(report_.rounds, result->rounds);
    }
    return *result;
  }

  bool is_acceptable(const Triangulated& t, const std::string& name) {
    if (t.rounding != Rounding::failed) return true;
    std::string note =
        name + ": rounding makes " + std::to_string(t.crossings.size()) + " or more pairs of triangles cross";
    for (std::size_t i = 0; i < std::min<std::size_t>(t.crossings.size(), 4); ++i) {
      note += " " + std::to_string(t.crossings[i].a) + "/" + std::to_string(t.crossings[i].b);
    }
    (options_.accept_rounding ? report_.notes : report_.refusals).push_back(note);
    return options_.accept_rounding;
  }

  void write(const Target& target) {
    switch (target.kind) {
      case Target::Kind::exact:
        if (!target.is_stream()) return write_exact_text(std::filesystem::path(target.name), boundary_);
        return to_stream([&](std::ostream& out) { write_exact_text(out, boundary_); });
      case Target::Kind::page:
        return write_html(target);
      case Target::Kind::mesh:
        return write_triangles(target);
      case Target::Kind::drawing:
        break;
    }
    throw InternalError(target.name + ": solids are not written as drawings");
  }

  template <class Write>
  static void to_stream(const Write& write) {
    write(data_stream());
    flush_standard_output();
  }

  void write_triangles(const Target& target) {
    if (boundary_.is_unbounded)
      throw InputError(target.name + ": the solid is unbounded; only .html and .qsolid hold such");
    const Triangulated& t = triangles(is_single_precision(target.format) ? Precision::binary32 : Precision::binary64);
    if (!is_acceptable(t, target.name)) return;
    const Mesh mesh = to_mesh(boundary_, t, title_);
    WriteReport written;
    if (target.is_stream()) {
      to_stream([&](std::ostream& out) { written = write_mesh(out, target.format, mesh, context_); });
    } else {
      written = write_mesh(std::filesystem::path(target.name), target.format, mesh, context_);
    }
    if (written.dropped_colors) report_.notes.push_back(target.name + ": the format holds no colours");
  }

  // A picture may show rounded coordinates in any case; the report says how they are.
  void write_html(const Target& target) {
    const ViewScene scene = scene_of_solid(boundary_, triangles(Precision::binary64), title_, context_);
    if (target.is_stream()) return to_stream([&](std::ostream& out) { write_page(out, scene); });
    std::ofstream out(target.name, std::ios::binary);
    if (!out) throw FileError(target.name + ": cannot be written");
    write_page(out, scene);
    out.close();
    if (!out) throw FileError(target.name + ": writing failed");
  }

  const Brep& boundary_;
  std::string title_;
  const Options& options_;
  const Context& context_;
  OutputReport report_;
  std::optional<Triangulated> doubles_;
  std::optional<Triangulated> floats_;
};

}  // namespace

Mesh to_mesh(const Brep& boundary, const Triangulated& t, const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  mesh.vertices = t.vertices;
  mesh.corners.reserve(3 * t.triangles.size());
  mesh.face_begin.reserve(t.triangles.size() + 1);
  for (const Tile& triangle : t.triangles) mesh.add_face(triangle);
  if (!boundary.face_colors.empty()) {
    for (const std::uint32_t f : t.triangle_face) mesh.face_colors.push_back(boundary.face_colors[f]);
  }
  return mesh;
}

OutputReport write_outputs(const Brep& boundary, const std::string& title, const Options& options,
                           const Context& context) {
  return OutputWriter(boundary, title, options, context).run();
}

}  // namespace quoin::cli
