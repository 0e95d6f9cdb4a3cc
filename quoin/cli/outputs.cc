// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/outputs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <span>

#include "quoin/base/error.h"
#include "quoin/cli/scene_of_solid.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/io/exact_text.h"
#include "quoin/io/mesh_file.h"
#include "quoin/view/page.h"

namespace quoin::cli {

namespace {

std::string shortest(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

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
      exit.keep_polygons = true;
      result = triangulate_boundary(boundary_, exit, context_);
      report_.rounding = std::max(report_.rounding, result->rounding);
      report_.max_displacement = std::max(report_.max_displacement, result->max_displacement);
      report_.rounds = std::max(report_.rounds, result->rounds);
    }
    return *result;
  }

  bool is_acceptable(const Triangulated& t) const {
    return t.rounding <= Rounding::certified || options_.accept_rounding;
  }

  // Says what snapping did, or that it did not help: a note, or the reason why the file is refused.
  void report_rounding(const Triangulated& t, const std::string& name, bool is_written) {
    if (t.rounds == 0 && t.rounding != Rounding::failed) return;
    const std::string what = t.rounding == Rounding::failed ? describe_failure(t) : describe_snapping(t, name);
    (is_written ? report_.notes : report_.refusals).push_back(name + ": " + what);
  }

  std::string describe_snapping(const Triangulated& t, const std::string& name) {
    const std::string moved = "; coordinates move by up to " + shortest(t.max_displacement);
    if (t.topology_before == t.topology_after) {
      return "rounding made faces cross, which snapping mended in " + std::to_string(t.rounds) +
             (t.rounds == 1 ? " round" : " rounds") + moved;
    }
    report_.topology_changes.push_back({name, t.resolved, t.topology_before, t.topology_after});
    return "rounding changes the solid: " + describe_change(t.topology_before, t.topology_after) + moved;
  }

  static std::string describe_failure(const Triangulated& t) {
    if (t.crossings.empty()) return "rounding turns parts of the surface inside out";
    std::string text = "rounding makes " + std::to_string(t.crossings.size()) + " or more pairs of triangles cross";
    for (std::size_t i = 0; i < std::min<std::size_t>(t.crossings.size(), 4); ++i) {
      text += " " + std::to_string(t.crossings[i].a) + "/" + std::to_string(t.crossings[i].b);
    }
    return text;
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
      case Target::Kind::planar:
      case Target::Kind::planar_exact:
      case Target::Kind::picture:
      case Target::Kind::planar_page:
      case Target::Kind::report:
      case Target::Kind::grid:
      case Target::Kind::simplices:
      case Target::Kind::cells:
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
    report_rounding(t, target.name, is_acceptable(t));
    if (!is_acceptable(t)) return;
    if (t.rounding != Rounding::failed && !report_.resolved) report_.resolved = t.resolved;
    const Mesh mesh = to_mesh(boundary_, t, title_, !is_triangles_only(target.format));
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
    const Triangulated& t = triangles(Precision::binary64);
    report_rounding(t, target.name, true);
    const ViewScene scene = scene_of_solid(boundary_, t, title_, context_);
    write_target(target, [&](std::ostream& out) { write_page(out, scene); });
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
