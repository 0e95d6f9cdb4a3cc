// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "quoin/base/error.h"
#include "quoin/cli/scene_of_solid.h"
#include "quoin/io/exact_text.h"
#include "quoin/io/mesh_file.h"
#include "quoin/view/page.h"

namespace quoin::cli {

namespace {

enum class Kind { mesh, page, exact };

struct Target {
  std::string name;
  Kind kind;
  MeshFormat format = MeshFormat::off;
};

Target target_of(const std::string& name) {
  if (name == "-") return {name, Kind::mesh};
  const std::string ending = std::filesystem::path(name).extension().string();
  if (ending == ".html" || ending == ".htm") return {name, Kind::page};
  if (ending == ".qsolid") return {name, Kind::exact};
  const auto format = format_from_path(name);
  if (!format)
    throw InputError(name + ": the ending tells no format that is written (off, obj, stl, ply, html, qsolid)");
  return {name, Kind::mesh, *format};
}

class OutputWriter {
 public:
  OutputWriter(const Brep& boundary, std::string title, const Options& options, const Context& context)
      : boundary_(boundary), title_(std::move(title)), options_(options), context_(context) {}

  OutputReport run() {
    std::vector<Target> targets;
    for (const std::string& name : options_.outputs) targets.push_back(target_of(name));
    for (const Target& target : targets) write(target);
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
    report_.notes.push_back(note);
    if (!options_.accept_rounding) report_.written = false;
    return options_.accept_rounding;
  }

  void write(const Target& target) {
    if (target.kind == Kind::exact) {
      write_exact_text(std::filesystem::path(target.name), boundary_);
      return;
    }
    if (target.kind == Kind::page) {
      write_html(target.name);
      return;
    }
    if (boundary_.is_unbounded)
      throw InputError(target.name + ": the solid is unbounded; only .html and .qsolid hold such");
    const Triangulated& t = triangles(is_single_precision(target.format) ? Precision::binary32 : Precision::binary64);
    if (!is_acceptable(t, target.name)) return;
    const Mesh mesh = to_mesh(boundary_, t, title_);
    WriteReport written;
    if (target.name == "-") {
      written = write_mesh(std::cout, target.format, mesh, context_);
      std::cout.flush();
      if (!std::cout) throw FileError("standard output: writing failed");
    } else {
      written = write_mesh(std::filesystem::path(target.name), target.format, mesh, context_);
    }
    if (written.dropped_colors) report_.notes.push_back(target.name + ": the format holds no colours");
  }

  // A picture may show rounded coordinates in any case; the report says how they are.
  void write_html(const std::string& name) {
    const Triangulated& t = triangles(Precision::binary64);
    std::ofstream out(name, std::ios::binary);
    if (!out) throw FileError(name + ": cannot be written");
    write_page(out, scene_of_solid(boundary_, t, title_, context_));
    out.close();
    if (!out) throw FileError(name + ": writing failed");
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
