// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/vtk_grid.h"

#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "quoin/base/error.h"

namespace quoin {

namespace {

class VtkWriter {
 public:
  VtkWriter(std::ostream& out, const Context& context) : out_(out), context_(context) {}

  void write(const VtkGrid& grid, const std::string& title) {
    text("# vtk DataFile Version 3.0\n").text(line_of(title)).text("\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    write_points(grid);
    write_cells(grid);
    if (!grid.point_integers.empty() || !grid.point_doubles.empty() || !grid.normals.empty() || !grid.colors.empty()) {
      text("POINT_DATA ").number(grid.points.size()).text("\n");
      for (const auto& [name, values] : grid.point_integers) write_scalars(name, "int", values);
      for (const auto& [name, values] : grid.point_doubles) write_scalars(name, "double", values);
      write_colors(grid.colors);
      write_normals(grid.normals);
    }
    if (!grid.cell_integers.empty() || !grid.cell_doubles.empty()) {
      text("CELL_DATA ").number(grid.types.size()).text("\n");
      for (const auto& [name, values] : grid.cell_integers) write_scalars(name, "int", values);
      for (const auto& [name, values] : grid.cell_doubles) write_scalars(name, "double", values);
    }
    flush();
  }

 private:
  VtkWriter& text(std::string_view s) {
    block_.append(s);
    if (block_.size() > 65536) {
      context_.poll();
      flush();
    }
    return *this;
  }

  template <class Number>
  VtkWriter& number(Number value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  /// One line of at most 255 characters.
  static std::string line_of(const std::string& title) {
    std::string line = title.substr(0, 200);
    for (char& c : line) c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return line.empty() ? "quoin" : line;
  }

  void write_points(const VtkGrid& grid) {
    text("POINTS ").number(grid.points.size()).text(" double\n");
    for (const Point3& p : grid.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw InputError("a point is beyond the largest double: VTK cannot hold it");
      number(p.x).text(" ").number(p.y).text(" ").number(p.z).text("\n");
    }
  }

  void write_cells(const VtkGrid& grid) {
    text("CELLS ").number(grid.types.size()).text(" ").number(grid.types.size() + grid.cells.size()).text("\n");
    for (std::size_t c = 0; c < grid.types.size(); ++c) {
      number(grid.cell_begin[c + 1] - grid.cell_begin[c]);
      for (std::size_t i = grid.cell_begin[c]; i < grid.cell_begin[c + 1]; ++i) text(" ").number(grid.cells[i]);
      text("\n");
    }
    text("CELL_TYPES ").number(grid.types.size()).text("\n");
    for (const VtkCell type : grid.types) number(static_cast<unsigned>(type)).text("\n");
  }

  template <class Number>
  void write_scalars(const std::string& name, const char* type, const std::vector<Number>& values) {
    text("SCALARS ").text(name).text(" ").text(type).text(" 1\nLOOKUP_TABLE default\n");
    for (const Number value : values) {
      if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(value))
          throw InputError("a number '" + name + "' is beyond the largest double: VTK cannot hold it");
        number(value).text("\n");
      } else if (value == VtkGrid::none) {
        text("-1\n");
      } else {
        number(value).text("\n");
      }
    }
  }

  void write_colors(const std::vector<Color>& colors) {
    if (colors.empty()) return;
    text("COLOR_SCALARS color 4\n");
    for (const Color& c : colors) {
      number(c.r / 255.0).text(" ").number(c.g / 255.0).text(" ");
      number(c.b / 255.0).text(" ").number(c.a / 255.0).text("\n");
    }
  }

  void write_normals(const std::vector<Vector3>& normals) {
    if (normals.empty()) return;
    text("NORMALS normal double\n");
    for (const Vector3& n : normals) number(n.x).text(" ").number(n.y).text(" ").number(n.z).text("\n");
  }

  void flush() {
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  std::ostream& out_;
  const Context& context_;
  std::string block_;
};

}  // namespace

void write_vtk(std::ostream& out, const VtkGrid& grid, const std::string& title, const Context& context) {
  VtkWriter(out, context).write(grid, title);
}

}  // namespace quoin
