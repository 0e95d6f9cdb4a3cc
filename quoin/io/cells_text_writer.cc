// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>

#include "quoin/io/cells_text.h"

namespace quoin {

namespace {

class CellsWriter {
 public:
  CellsWriter(std::ostream& out, const ExactCells& cells, const Context& context)
      : out_(out), cells_(cells), context_(context) {}

  void run() {
    block_ = "quoin-cells 1\ncoordinates " + std::to_string(cells_.dimension) + "\n";
    write_names("point", cells_.point_data);
    write_points();
    write_names("cell", cells_.cell_data);
    write_cells();
    block_ += "end\n";
    flush();
  }

 private:
  void write_names(const std::string& of, const ExactColumns& columns) {
    block_ += of + "-integers";
    for (const auto& column : columns.integers) block_ += " " + io::encoded_name(column.first);
    block_ += "\n" + of + "-numbers";
    for (const auto& column : columns.numbers) block_ += " " + io::encoded_name(column.first);
    block_ += "\n";
  }

  void write_points() {
    block_ += "points " + std::to_string(cells_.point_count()) + "\n";
    for (std::size_t i = 0; i < cells_.point_count(); ++i) {
      for (std::size_t k = 0; k < cells_.dimension; ++k) {
        if (k > 0) block_ += ' ';
        block_ += cells_.positions.word(cells_.dimension * i + k);
      }
      write_data(cells_.point_data, i);
      end_line();
    }
  }

  void write_cells() {
    static constexpr std::array<std::string_view, 3> names{"simplex", "polygon", "polyhedron"};
    block_ += "cells " + std::to_string(cells_.cell_count()) + "\n";
    for (std::size_t c = 0; c < cells_.cell_count(); ++c) {
      block_ += names[static_cast<std::size_t>(cells_.kinds[c])];
      write_data(cells_.cell_data, c);
      for (const std::uint32_t part : cells_.cell(c)) {
        if (cells_.kinds[c] == ExactCellKind::polyhedron) {
          block_ += ExactCells::is_turned(part) ? " -" : " +";
          write_integer(ExactCells::face_of(part));
        } else {
          block_ += ' ';
          write_integer(part);
        }
      }
      end_line();
    }
  }

  void write_data(const ExactColumns& columns, std::size_t i) {
    for (const auto& column : columns.integers) {
      block_ += ' ';
      if (column.second[i] == ExactColumns::none) {
        block_ += '-';
      } else {
        write_integer(column.second[i]);
      }
    }
    for (const auto& column : columns.numbers) block_ += " " + column.second.word(i);
  }

  void write_integer(std::uint32_t value) {
    std::array<char, 16> digits;
    block_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  }

  void end_line() {
    block_ += '\n';
    if (block_.size() < 65536) return;
    context_.poll();
    flush();
  }

  void flush() {
    out_ << block_;
    block_.clear();
  }

  std::ostream& out_;
  const ExactCells& cells_;
  const Context& context_;
  std::string block_;
};

}  // namespace

void write_cells_text(std::ostream& out, const ExactCells& cells, const Context& context) {
  CellsWriter(out, cells, context).run();
}

}  // namespace quoin
