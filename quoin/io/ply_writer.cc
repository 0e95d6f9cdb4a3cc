// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_writers.h"

namespace quoin::io {

namespace {

constexpr std::string_view color_properties =
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";

void write_header(BlockWriter& out, MeshFormat format, const Mesh& mesh, const VertexData& data) {
  const std::string_view kind = format == MeshFormat::ply_text            ? "ascii"
                                : format == MeshFormat::ply_binary_little ? "binary_little_endian"
                                                                          : "binary_big_endian";
  out.text("ply\nformat ").text(kind).text(" 1.0\nelement vertex ").number(mesh.vertices.size());
  out.text("\nproperty double x\nproperty double y\nproperty double z\n");
  if (!data.normals.empty()) out.text("property double nx\nproperty double ny\nproperty double nz\n");
  if (!data.colors.empty()) out.text(color_properties);
  if (!data.intensities.empty()) out.text("property double intensity\n");
  if (!data.weights.empty()) out.text("property double weight\n");
  out.text("element face ").number(mesh.face_count()).text("\nproperty list uint uint vertex_indices\n");
  if (!mesh.face_colors.empty()) out.text(color_properties);
  out.text("end_header\n");
}

void write_text(BlockWriter& out, const Mesh& mesh, const VertexData& data) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    out.point(mesh.vertices[v]);
    if (!data.normals.empty()) out.text(" ").point({data.normals[v].x, data.normals[v].y, data.normals[v].z});
    if (!data.colors.empty()) {
      const Color& c = data.colors[v];
      for (const std::uint8_t channel : {c.r, c.g, c.b, c.a}) out.text(" ").number(std::size_t{channel});
    }
    if (!data.intensities.empty()) out.text(" ").number(data.intensities[v]);
    if (!data.weights.empty()) out.text(" ").number(data.weights[v]);
    out.text("\n");
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) write_face_line(out, mesh, f);
}

void write_color(BlockWriter& out, const Color& c) {
  out.binary(c.r).binary(c.g).binary(c.b).binary(c.a);
}

void write_binary(BlockWriter& out, const Mesh& mesh, const VertexData& data, bool big) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point3& p = mesh.vertices[v];
    out.binary(p.x, big).binary(p.y, big).binary(p.z, big);
    if (!data.normals.empty()) {
      const Vector3& n = data.normals[v];
      out.binary(n.x, big).binary(n.y, big).binary(n.z, big);
    }
    if (!data.colors.empty()) write_color(out, data.colors[v]);
    if (!data.intensities.empty()) out.binary(data.intensities[v], big);
    if (!data.weights.empty()) out.binary(data.weights[v], big);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.binary(static_cast<std::uint32_t>(mesh.face(f).size()), big);
    for (const std::uint32_t v : mesh.face(f)) out.binary(v, big);
    if (!mesh.face_colors.empty()) write_color(out, mesh.face_colors[f]);
  }
}

}  // namespace

void write_face_line(BlockWriter& out, const Mesh& mesh, std::size_t f) {
  out.number(mesh.face(f).size());
  for (const std::uint32_t v : mesh.face(f)) out.text(" ").number(std::size_t{v});
  if (!mesh.face_colors.empty()) {
    const Color& c = mesh.face_colors[f];
    for (const std::uint8_t channel : {c.r, c.g, c.b, c.a}) out.text(" ").number(std::size_t{channel});
  }
  out.text("\n");
}

void write_ply(BlockWriter& out, MeshFormat format, const Mesh& mesh, const VertexData& data) {
  write_header(out, format, mesh, data);
  if (format == MeshFormat::ply_text) {
    write_text(out, mesh, data);
  } else {
    write_binary(out, mesh, data, format == MeshFormat::ply_binary_big);
  }
}

}  // namespace quoin::io
