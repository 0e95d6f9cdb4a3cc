// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/io/mesh_file.h"

namespace quoin {

namespace {

// Collects output in blocks of some size before it goes to the stream.
class Writer {
 public:
  Writer(std::ostream& out, const Context& context) : out_(out), context_(context) {}
  ~Writer() { flush(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  Writer& text(std::string_view s) {
    block_.append(s);
    if (block_.size() > 65536) {
      context_.poll();
      flush();
    }
    return *this;
  }

  /// Shortest decimals that read back to the same double.
  Writer& number(double value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  Writer& number(std::size_t value) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  template <class T>
  Writer& binary(T value, bool big_endian = false) {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian == (std::endian::native == std::endian::little)) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    }
    return text({bytes.data(), bytes.size()});
  }

  Writer& point(const Point3& p) { return number(p.x).text(" ").number(p.y).text(" ").number(p.z); }

 private:
  void flush() {
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  std::ostream& out_;
  const Context& context_;
  std::string block_;
};

// One line of text: control characters of a name would end it.
std::string line_of(const std::string& name) {
  std::string line = name;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return line;
}

// The corners of a face with their number, and its colour if there are colours, as words of a line.
void write_face_line(Writer& out, const Mesh& mesh, std::size_t f) {
  out.number(mesh.face(f).size());
  for (const std::uint32_t v : mesh.face(f)) out.text(" ").number(std::size_t{v});
  if (!mesh.face_colors.empty()) {
    const Color& c = mesh.face_colors[f];
    for (const std::uint8_t channel : {c.r, c.g, c.b, c.a}) out.text(" ").number(std::size_t{channel});
  }
  out.text("\n");
}

void write_off(Writer& out, const Mesh& mesh) {
  out.text("OFF\n").number(mesh.vertices.size()).text(" ").number(mesh.face_count()).text(" 0\n");
  for (const Point3& p : mesh.vertices) out.point(p).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) write_face_line(out, mesh, f);
}

void write_obj(Writer& out, const Mesh& mesh) {
  if (!mesh.name.empty()) out.text("o ").text(line_of(mesh.name)).text("\n");
  for (const Point3& p : mesh.vertices) out.text("v ").point(p).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.text("f");
    for (const std::uint32_t v : mesh.face(f)) out.text(" ").number(std::size_t{v} + 1);
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

void write_stl_text(Writer& out, const Mesh& mesh) {
  const std::string name = mesh.name.empty() ? "quoin" : line_of(mesh.name);
  out.text("solid ").text(name).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.text("facet normal ").point(normal_of(mesh, f)).text("\n outer loop\n");
    for (const std::uint32_t v : mesh.face(f)) out.text("  vertex ").point(mesh.vertices[v]).text("\n");
    out.text(" endloop\nendfacet\n");
  }
  out.text("endsolid ").text(name).text("\n");
}

void write_stl_binary(Writer& out, const Mesh& mesh) {
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

void write_ply_header(Writer& out, MeshFormat format, const Mesh& mesh) {
  const std::string_view kind = format == MeshFormat::ply_text            ? "ascii"
                                : format == MeshFormat::ply_binary_little ? "binary_little_endian"
                                                                          : "binary_big_endian";
  out.text("ply\nformat ").text(kind).text(" 1.0\nelement vertex ").number(mesh.vertices.size());
  out.text("\nproperty double x\nproperty double y\nproperty double z\nelement face ").number(mesh.face_count());
  out.text("\nproperty list uint uint vertex_indices\n");
  if (!mesh.face_colors.empty()) {
    out.text("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n");
  }
  out.text("end_header\n");
}

void write_ply_text(Writer& out, const Mesh& mesh) {
  for (const Point3& p : mesh.vertices) out.point(p).text("\n");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) write_face_line(out, mesh, f);
}

void write_ply_binary(Writer& out, const Mesh& mesh, bool big) {
  for (const Point3& p : mesh.vertices) out.binary(p.x, big).binary(p.y, big).binary(p.z, big);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out.binary(static_cast<std::uint32_t>(mesh.face(f).size()), big);
    for (const std::uint32_t v : mesh.face(f)) out.binary(v, big);
    if (!mesh.face_colors.empty()) {
      const Color& c = mesh.face_colors[f];
      out.binary(c.r).binary(c.g).binary(c.b).binary(c.a);
    }
  }
}

void require_written(MeshFormat format) {
  if (!is_written(format)) throw InputError("3MF files are read, not written");
}

WriteReport report_on(MeshFormat format, const Mesh& mesh) {
  WriteReport report;
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

WriteReport write_mesh(std::ostream& stream, MeshFormat format, const Mesh& mesh, const Context& context) {
  require_written(format);
  if (is_triangles_only(format)) require_triangles(mesh);
  const WriteReport report = report_on(format, mesh);
  {
    Writer out(stream, context);
    switch (format) {
      case MeshFormat::off:
        write_off(out, mesh);
        break;
      case MeshFormat::obj:
        write_obj(out, mesh);
        break;
      case MeshFormat::stl_text:
        write_stl_text(out, mesh);
        break;
      case MeshFormat::stl_binary:
        write_stl_binary(out, mesh);
        break;
      case MeshFormat::ply_text:
        write_ply_header(out, format, mesh);
        write_ply_text(out, mesh);
        break;
      case MeshFormat::ply_binary_little:
      case MeshFormat::ply_binary_big:
        write_ply_header(out, format, mesh);
        write_ply_binary(out, mesh, format == MeshFormat::ply_binary_big);
        break;
      case MeshFormat::threemf:
        break;  // refused above
    }
  }
  return report;
}

WriteReport write_mesh(const std::filesystem::path& path, MeshFormat format, const Mesh& mesh, const Context& context) {
  require_written(format);
  std::ofstream stream(path, std::ios::binary);
  if (!stream) throw FileError(path.string() + ": cannot be written: " + std::strerror(errno));
  const WriteReport report = write_mesh(stream, format, mesh, context);
  stream.close();
  if (!stream) throw FileError(path.string() + ": writing failed: " + std::strerror(errno));
  return report;
}

}  // namespace quoin
