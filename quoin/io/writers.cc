// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/io/block_writer.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/mesh_writers.h"

namespace quoin {

namespace {

using io::BlockWriter;

// One line of text: control characters of a name would end it.
std::string line_of(const std::string& name) {
  std::string line = name;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return line;
}

void write_off(BlockWriter& out, const Mesh& mesh) {
  out.text("OFF\n").number(mesh.vertices.size()).text(" ").number(mesh.face_count()).text(" 0\n");
  for (const Point3& p : mesh.vertices) out.point(p).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) io::write_face_line(out, mesh, f);
}

/// Colours behind the coordinates, as fractions, with opacity where it is not full; normals by the number of the
/// vertex.
void write_obj(BlockWriter& out, const Mesh& mesh, const VertexData& data) {
  if (!mesh.name.empty()) out.text("o ").text(line_of(mesh.name)).text("\n");
  const bool is_opaque = std::ranges::all_of(data.colors, [](const Color& c) { return c.a == 255; });
  const auto fraction = [&](std::uint8_t channel) { out.text(" ").number(channel / 255.0); };
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    out.text("v ").point(mesh.vertices[v]);
    if (!data.colors.empty()) {
      const Color& c = data.colors[v];
      for (const std::uint8_t channel : {c.r, c.g, c.b}) fraction(channel);
      if (!is_opaque) fraction(c.a);
    }
    out.text("\n");
  }
  for (const Vector3& n : data.normals)
    out.text("vn ").number(n.x).text(" ").number(n.y).text(" ").number(n.z).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.text("f");
    for (const std::uint32_t v : mesh.face(f)) {
      out.text(" ").number(std::size_t{v} + 1);
      if (!data.normals.empty()) out.text("//").number(std::size_t{v} + 1);
    }
    out.text("\n");
  }
}

// Unit normal for readers that want one; it decides nothing.
Point3 normal_of(const Mesh& mesh, std::size_t f) {
  const auto corners = mesh.face(f);
  const Point3& a = mesh.vertices[corners[0]];
  const Point3& b = mesh.vertices[corners[1]];
  const Point3& c = mesh.vertices[corners[2]];
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return {n.x / length, n.y / length, n.z / length};
}

void require_triangles(const Mesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != 3) {
      throw InputError("face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                       " corners; STL holds triangles only");
    }
  }
}

void write_stl_text(BlockWriter& out, const Mesh& mesh) {
  const std::string name = mesh.name.empty() ? "quoin" : line_of(mesh.name);
  out.text("solid ").text(name).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.text("facet normal ").point(normal_of(mesh, f)).text("\n outer loop\n");
    for (const std::uint32_t v : mesh.face(f)) out.text("  vertex ").point(mesh.vertices[v]).text("\n");
    out.text(" endloop\nendfacet\n");
  }
  out.text("endsolid ").text(name).text("\n");
}

void write_stl_binary(BlockWriter& out, const Mesh& mesh) {
  std::string header = "binary STL by quoin";
  header.resize(80, ' ');
  out.text(header).binary(static_cast<std::uint32_t>(mesh.face_count()));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto put = [&](const Point3& p) {
      out.binary(static_cast<float>(p.x)).binary(static_cast<float>(p.y)).binary(static_cast<float>(p.z));
    };
    put(normal_of(mesh, f));
    for (const std::uint32_t v : mesh.face(f)) put(mesh.vertices[v]);
    out.binary(std::uint16_t{0});
  }
}

void require_written(MeshFormat format) {
  if (!is_written(format)) throw InputError("3MF files are read, not written");
}

bool is_ply(MeshFormat format) {
  return format == MeshFormat::ply_text || format == MeshFormat::ply_binary_little ||
         format == MeshFormat::ply_binary_big;
}

WriteReport report_on(MeshFormat format, const Mesh& mesh, const VertexData& data) {
  WriteReport report;
  const bool is_obj = format == MeshFormat::obj;
  if (!is_ply(format)) {
    if (!data.normals.empty() && !is_obj) report.dropped_vertex_data.emplace_back("normals");
    if (!data.colors.empty() && !is_obj) report.dropped_vertex_data.emplace_back("colours");
    if (!data.intensities.empty()) report.dropped_vertex_data.emplace_back("intensities");
    if (!data.weights.empty()) report.dropped_vertex_data.emplace_back("weights");
  }
  report.dropped_colors = !mesh.face_colors.empty() && (format == MeshFormat::obj || is_triangles_only(format));
  if (!is_single_precision(format)) return report;
  for (const Point3& p : mesh.vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::fabs(p[k]) <= static_cast<double>(std::numeric_limits<float>::max()))) {
        throw InputError("a coordinate is too large for single precision");
      }
      const double move = std::fabs(static_cast<double>(static_cast<float>(p[k])) - p[k]);
      if (move > 0) ++report.rounded_coordinates;
      report.largest_rounding = std::max(report.largest_rounding, move);
    }
  }
  return report;
}

}  // namespace

WriteReport write_mesh(std::ostream& stream, MeshFormat format, const Mesh& mesh, const Context& context,
                       const VertexData& data) {
  require_written(format);
  if (is_triangles_only(format)) require_triangles(mesh);
  WriteReport report = report_on(format, mesh, data);
  BlockWriter out(stream, context);
  switch (format) {
    case MeshFormat::off:
      write_off(out, mesh);
      break;
    case MeshFormat::obj:
      write_obj(out, mesh, data);
      break;
    case MeshFormat::stl_text:
      write_stl_text(out, mesh);
      break;
    case MeshFormat::stl_binary:
      write_stl_binary(out, mesh);
      break;
    case MeshFormat::ply_text:
    case MeshFormat::ply_binary_little:
    case MeshFormat::ply_binary_big:
      io::write_ply(out, format, mesh, data);
      break;
    case MeshFormat::threemf:
      break;  // refused above
  }
  out.finish();
  return report;
}

WriteReport write_mesh(const std::filesystem::path& path, MeshFormat format, const Mesh& mesh, const Context& context) {
  require_written(format);
  std::ofstream stream(path, std::ios::binary);
  if (!stream) throw FileError(path.string() + ": cannot be written: " + std::strerror(errno));
  WriteReport report = write_mesh(stream, format, mesh, context);
  stream.close();
  if (!stream) throw FileError(path.string() + ": writing failed: " + std::strerror(errno));
  return report;
}

}  // namespace quoin
