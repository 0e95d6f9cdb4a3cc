// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

#include "quoin/io/readers.h"
#include "quoin/io/single_point_set.h"
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

void expect_words(TextLines& lines, std::string_view first, std::string_view second) {
  lines.need(std::string(first));
  const auto& words = lines.words();
  if (!is_word(words[0], first) || (!second.empty() && (words.size() < 2 || !is_word(words[1], second)))) {
    lines.fail("'" + std::string(first) + (second.empty() ? "" : " ") + std::string(second) + "' should stand here");
  }
}

}  // namespace

bool fits_stl_binary(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + triangle_size * std::uint64_t{little_endian(bytes, 80)};
}

// Bytes 80 to 83 of a text are at least 9, the tabulator: as a count they would stand for more than 151 million
// triangles, 7.5 GB. So the last of them tells counts from text.
bool is_stl_text(std::string_view bytes) {
  if (fits_stl_binary(bytes)) return false;
  const std::string_view word = first_word(bytes);
  if (!is_word(word, "solid") && !is_word(word, "facet")) return false;
  return bytes.size() < header_size || static_cast<unsigned char>(bytes[83]) >= '\t';
}

namespace {

// The records of a binary file whose size fits its count; vertices as the file has them, or each distinct one once.
class BinaryTriangles {
 public:
  BinaryTriangles(std::string_view bytes, const std::string& name, std::size_t count, const Context& context)
      : bytes_(bytes), name_(name), count_(count), context_(context) {}

  void read(Mesh& mesh, bool weld) {
    mesh.corners.resize(3 * count_);
    mesh.face_begin.resize(count_ + 1);
    for (std::size_t t = 0; t < count_; ++t) mesh.face_begin[t + 1] = 3 * (t + 1);
    if (weld) {
      read_welded(mesh);
    } else {
      read_all(mesh);
    }
  }

  bool has_attributes() const { return has_attributes_; }

 private:
  static constexpr std::size_t block = 16;  // triangles

  using Corners = std::array<SinglePointSet::Point, 3 * block>;

  void read_welded(Mesh& mesh) {
    SinglePointSet distinct(count_ / 2);  // a closed mesh of n triangles has about n / 2 vertices
    mesh.vertices.reserve(count_ / 2 + 2);
    std::array<SinglePointSet::Inserted, 3 * block> numbers;
    for_each_block([&](std::size_t first, std::span<SinglePointSet::Point> corners) {
      distinct.insert(corners, numbers);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.corners[first + i] = numbers[i].number;
        if (numbers[i].is_new) mesh.vertices.push_back(widened(corners[i]));
      }
    });
  }

  void read_all(Mesh& mesh) {
    mesh.vertices.resize(3 * count_);
    for_each_block([&](std::size_t first, std::span<const SinglePointSet::Point> corners) {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.vertices[first + i] = widened(corners[i]);
        mesh.corners[first + i] = static_cast<std::uint32_t>(first + i);
      }
    });
  }

  static Point3 widened(const SinglePointSet::Point& p) {
    return {static_cast<double>(p[0]) + 0.0, static_cast<double>(p[1]) + 0.0, static_cast<double>(p[2]) + 0.0};
  }

  // Calls `visit` with the number of the first corner and the corners of each run of triangles.
  template <class Visitor>
  void for_each_block(const Visitor& visit) {
    Corners corners;
    bool has_attributes = false;
    for (std::size_t begin = 0; begin < count_; begin += block) {
      if (begin % 8192 == 0) context_.poll();
      const std::size_t end = std::min(count_, begin + block);
      for (std::size_t t = begin; t < end; ++t) {
        const char* record = bytes_.data() + header_size + triangle_size * t;
        for (std::size_t k = 0; k < 3; ++k) {
          const SinglePointSet::Point p = point_at(record + 12 + 12 * k);
          if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) refuse(t, k, p);
          corners[3 * (t - begin) + k] = p;
        }
        has_attributes |= (record[48] | record[49]) != 0;
      }
      visit(3 * begin, std::span(corners).first(3 * (end - begin)));
    }
    has_attributes_ = has_attributes;
  }

  static SinglePointSet::Point point_at(const char* bytes) {
    SinglePointSet::Point p;
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(p.data(), bytes, sizeof p);
    } else {
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = std::bit_cast<float>(little_endian({bytes + 4 * axis, 4}, 0));
    }
    return p;
  }

  [[noreturn]] void refuse(std::size_t triangle, std::size_t corner, const SinglePointSet::Point& p) const {
    std::size_t offset = header_size + triangle_size * triangle + 12 + 12 * corner;
    for (const float x : p) {
      if (!std::isfinite(x)) break;
      offset += 4;
    }
    throw InputError(name_ + ": byte " + std::to_string(offset) + ": triangle " + std::to_string(triangle) +
                     " has a coordinate that is not finite");
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t count_;
  const Context& context_;
  bool has_attributes_ = false;
};

}  // namespace

MeshFile read_stl_binary(std::string_view bytes, const std::string& name, bool weld, const Context& context) {
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
  if (count > 0xFFFFFFFFU / 3) throw InputError(name + ": more than 1.4 thousand million triangles");
  MeshFile file;
  file.report.format = MeshFormat::stl_binary;
  if (bytes.size() != header_size + count * triangle_size) {
    file.report.warnings.push_back(std::to_string(bytes.size() - header_size - count * triangle_size) +
                                   " bytes behind the last triangle are not kept");
  }
  BinaryTriangles triangles(bytes, name, count, context);
  triangles.read(file.mesh, weld);
  file.report.vertices_in_file = 3 * count;
  file.report.welded = 3 * count - file.mesh.vertices.size();
  if (triangles.has_attributes()) file.report.warnings.push_back("the attribute bytes of the triangles are not kept");
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
    if (is_word(words[0], "solid")) {
      in_solid = true;
      if (mesh.name.empty() && words.size() > 1) mesh.name = words[1];
      continue;
    }
    if (is_word(words[0], "endsolid")) {
      in_solid = false;
      continue;
    }
    if (!is_word(words[0], "facet")) lines.fail("'facet' or 'endsolid' should stand here");
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
