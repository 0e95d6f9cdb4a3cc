// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>

#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k]));
  };
  return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

float float_at(std::string_view bytes, std::size_t at) {
  const std::uint32_t bits = little_endian(bytes, at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void expect_words(TextLines& lines, std::string_view first, std::string_view second) {
  lines.need(std::string(first));
  const auto& words = lines.words();
  if (words[0] != first || (!second.empty() && (words.size() < 2 || words[1] != second))) {
    lines.fail("'" + std::string(first) + (second.empty() ? "" : " ") + std::string(second) + "' should stand here");
  }
}

}  // namespace

bool is_stl_binary(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + triangle_size * std::uint64_t{little_endian(bytes, 80)};
}

MeshFile read_stl_binary(std::string_view bytes, const std::string& name, const Context& context) {
  if (bytes.size() < header_size) {
    throw InputError(name + ": byte " + std::to_string(bytes.size()) +
                     ": the file ends within the header of a binary STL");
  }
  const std::uint64_t count = little_endian(bytes, 80);
  const std::uint64_t held = (bytes.size() - header_size) / triangle_size;
  if (held < count) {
    throw InputError(name + ": byte " + std::to_string(bytes.size()) + ": the file ends within triangle " +
                     std::to_string(held) + " of " + std::to_string(count));
  }
  MeshFile file;
  file.report.format = MeshFormat::stl_binary;
  if (bytes.size() != header_size + count * triangle_size) {
    file.report.warnings.push_back(std::to_string(bytes.size() - header_size - count * triangle_size) +
                                   " bytes behind the last triangle are not kept");
  }
  Mesh& mesh = file.mesh;
  mesh.vertices.resize(3 * count);
  mesh.corners.resize(3 * count);
  mesh.face_begin.resize(count + 1);
  bool has_attributes = false;
  for (std::size_t t = 0; t < count; ++t) {
    if (t % 8192 == 0) context.poll();
    const std::size_t at = header_size + triangle_size * t;
    for (std::size_t k = 0; k < 3; ++k) {
      Point3 p;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t offset = at + 12 + 12 * k + 4 * axis;
        const float value = float_at(bytes, offset);
        if (!std::isfinite(value)) {
          throw InputError(name + ": byte " + std::to_string(offset) + ": triangle " + std::to_string(t) +
                           " has a coordinate that is not finite");
        }
        p[axis] = static_cast<double>(value) + 0.0;
      }
      mesh.vertices[3 * t + k] = p;
      mesh.corners[3 * t + k] = static_cast<std::uint32_t>(3 * t + k);
    }
    mesh.face_begin[t + 1] = 3 * (t + 1);
    has_attributes = has_attributes || bytes[at + 48] != 0 || bytes[at + 49] != 0;
  }
  if (has_attributes) file.report.warnings.push_back("the attribute bytes of the triangles are not kept");
  return file;
}

MeshFile read_stl_text(std::string_view bytes, const std::string& name, const Context& context) {
  TextLines lines(bytes, name, '\0');
  MeshFile file;
  file.report.format = MeshFormat::stl_text;
  Mesh& mesh = file.mesh;
  bool in_solid = false;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "solid") {
      in_solid = true;
      if (mesh.name.empty() && words.size() > 1) mesh.name = words[1];
      continue;
    }
    if (words[0] == "endsolid") {
      in_solid = false;
      continue;
    }
    if (words[0] != "facet") lines.fail("'facet' or 'endsolid' should stand here");
    if (mesh.vertices.size() % 4095 == 0) context.poll();
    expect_words(lines, "outer", "loop");
    for (int k = 0; k < 3; ++k) {
      expect_words(lines, "vertex", "");
      if (lines.words().size() < 4) lines.fail("a vertex has fewer than three coordinates");
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(
          {lines.number(lines.words()[1]), lines.number(lines.words()[2]), lines.number(lines.words()[3])});
    }
    mesh.face_begin.push_back(mesh.corners.size());
    expect_words(lines, "endloop", "");
    expect_words(lines, "endfacet", "");
  }
  if (in_solid) lines.fail("the file ends where 'endsolid' should follow");
  return file;
}

}  // namespace quoin::io
