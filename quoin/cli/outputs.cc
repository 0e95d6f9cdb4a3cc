// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/outputs.h"

#include <algorithm>
#include <array>
#include <charconv>
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

std::string shortest(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

void add_change(std::string& text, const char* what, std::size_t before, std::size_t after) {
  if (before == after) return;
  text += (text.empty() ? "" : ", ") + std::to_string(after) + " " + what + " instead of " + std::to_string(before);
}

std::string describe_change(const Topology& before, const Topology& after) {
  if (after.shells == 0) return "nothing is left of it (components before: " + std::to_string(before.components) + ")";
  std::string text;
  add_change(text, "components", before.components, after.components);
  add_change(text, "shells", before.shells, after.shells);
  add_change(text, "voids", before.voids, after.voids);
  if (before.is_manifold != after.is_manifold) {
    text += (text.empty() ? "" : ", ");
    text += after.is_manifold ? "it no longer touches itself" : "it comes to touch itself";
  } else {
    add_change(text, "handles", before.handles, after.handles);
  }
  return text;
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
      exit.keep_polygons = true;
      result = triangulate_boundary(boundary_, exit, context_);
      report_.rounding = std::max(report_.rounding, result->rounding);
      report_.max_displacement = std::max(report_.max_displacement, result->max_displacement);
      report_.rounds = std::max(report_.rounds, result->rounds);
    }
    return *result;
  }

  // Says what snapping did.
  void report_snapping(const Triangulated& t, const std::string& name) {
    if (t.rounds == 0 || t.rounding == Rounding::failed) return;
    std::string note = name + ": ";
    if (t.topology_before == t.topology_after) {
      note += "rounding made faces cross, which snapping mended in " + std::to_string(t.rounds) +
              (t.rounds == 1 ? " round" : " rounds");
    } else {
      report_.topology_changes.push_back({name, t.resolved, t.topology_before, t.topology_after});
      note += "rounding changes the solid: " + describe_change(t.topology_before, t.topology_after);
    }
    report_.notes.push_back(note + "; coordinates move by up to " + shortest(t.max_displacement));
  }

  void report_failure(const Triangulated& t, const std::string& name) {
    if (t.rounding != Rounding::failed) return;
    std::string note = name + ": rounding turns parts of the surface inside out";
    if (!t.crossings.empty())
      note = name + ": rounding makes " + std::to_string(t.crossings.size()) + " or more pairs of triangles cross";
    for (std::size_t i = 0; i < std::min<std::size_t>(t.crossings.size(), 4); ++i) {
      note += " " + std::to_string(t.crossings[i].a) + "/" + std::to_string(t.crossings[i].b);
    }
    report_.notes.push_back(note);
  }

  bool is_acceptable(const Triangulated& t) {
    if (t.rounding <= Rounding::certified || options_.accept_rounding) return true;
    report_.written = false;
    return false;
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
    report_snapping(t, target.name);
    report_failure(t, target.name);
    if (!is_acceptable(t)) return;
    if (t.rounding != Rounding::failed && !report_.resolved) report_.resolved = t.resolved;
    const Mesh mesh = to_mesh(boundary_, t, title_, !is_triangles_only(target.format));
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
    report_snapping(t, name);
    report_failure(t, name);
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

Mesh to_mesh(const Brep& boundary, const Triangulated& t, const std::string& name, bool with_polygons) {
  Mesh mesh;
  mesh.name = name;
  mesh.vertices = t.vertices;
  mesh.corners.reserve(3 * t.triangles.size());
  mesh.face_begin.reserve(t.triangles.size() + 1);
  const FacePolygons& polygons = t.polygons;
  std::size_t polygon = with_polygons ? 0 : polygons.first_triangle.size();
  for (std::uint32_t i = 0; i < t.triangles.size();) {
    if (!boundary.face_colors.empty()) mesh.face_colors.push_back(boundary.face_colors[t.triangle_face[i]]);
    if (polygon < polygons.first_triangle.size() && polygons.first_triangle[polygon] == i) {
      const std::uint32_t count = polygons.begin[polygon + 1] - polygons.begin[polygon];
      mesh.add_face(std::span(polygons.corners).subspan(polygons.begin[polygon], count));
      i += count - 2;
      ++polygon;
    } else {
      mesh.add_face(t.triangles[i++]);
    }
  }
  return mesh;
}

OutputReport write_outputs(const Brep& boundary, const std::string& title, const Options& options,
                           const Context& context) {
  return OutputWriter(boundary, title, options, context).run();
}

}  // namespace quoin::cli
