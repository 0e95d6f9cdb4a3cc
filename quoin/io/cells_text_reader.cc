// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/io/cells_text.h"
#include "quoin/io/closed_surface.h"
#include "quoin/io/exact_lines.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

namespace {

constexpr std::size_t poll_step = 1024;

class CellsReader {
 public:
  CellsReader(std::string_view text, const std::string& name, const Context& context)
      : lines_(text, name), context_(context) {}

  ExactCells run() {
    lines_.expect("quoin-cells", 2);
    if (lines_.words()[1] != "1") lines_.fail("this version of the format is not known");
    cells_.dimension = lines_.choice("coordinates", "2", "3") ? 3 : 2;
    read_names("point", cells_.point_data);
    read_points();
    read_names("cell", cells_.cell_data);
    read_cells();
    lines_.expect_end();
    return std::move(cells_);
  }

 private:
  void read_names(const std::string& of, ExactColumns& columns) {
    std::vector<std::string> names;
    const auto take = [&](const std::string& keyword, auto& list) {
      lines_.expect_at_least(keyword, 1);
      for (const std::string_view word : std::span(lines_.words()).subspan(1)) {
        list.emplace_back().first = io::decoded_name(word);
        if (std::ranges::find(names, list.back().first) != names.end())
          lines_.fail(io::quoted(word) + " names two columns");
        names.push_back(list.back().first);
      }
    };
    take(of + "-integers", columns.integers);
    take(of + "-numbers", columns.numbers);
  }

  void read_points() {
    lines_.expect("points", 2);
    const std::size_t count = lines_.count(1);
    const std::size_t words = cells_.dimension + data_words(cells_.point_data);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % poll_step == 0) context_.poll();
      lines_.need("point " + std::to_string(i));
      if (lines_.words().size() < words) lines_.fail("the line is too short");
      lines_.expect_size(words);
      for (std::size_t k = 0; k < cells_.dimension; ++k) cells_.positions.add(number(lines_.words()[k]));
      read_data(cells_.point_data, cells_.dimension);
    }
  }

  static std::size_t data_words(const ExactColumns& columns) {
    return columns.integers.size() + columns.numbers.size();
  }

  io::ExactNumber number(std::string_view word) const {
    return lines_.located([&] { return io::parse_exact(word); });
  }

  void read_data(ExactColumns& columns, std::size_t first) {
    for (auto& column : columns.integers) {
      const std::string_view word = lines_.words()[first++];
      column.second.push_back(word == "-" ? ExactColumns::none : lines_.index(word, ExactColumns::none));
    }
    for (auto& column : columns.numbers) {
      const std::string_view word = lines_.words()[first++];
      if (word == "-") {
        column.second.add_none();
      } else {
        column.second.add(number(word));
      }
    }
  }

  void read_cells() {
    lines_.expect("cells", 2);
    const std::size_t count = lines_.count(1);
    for (std::size_t c = 0; c < count; ++c) {
      if (c % poll_step == 0) context_.poll();
      lines_.need("cell " + std::to_string(c));
      const ExactCellKind kind = kind_of(lines_.words()[0]);
      const std::size_t first = 1 + data_words(cells_.cell_data);
      if (lines_.words().size() < first) lines_.fail("the line is too short");
      read_data(cells_.cell_data, 1);
      numbers_.clear();
      if (kind == ExactCellKind::polyhedron) {
        read_faces(first);
      } else {
        read_corners(kind, first);
      }
      cells_.add_cell(kind, numbers_);
    }
  }

  ExactCellKind kind_of(std::string_view word) const {
    if (word == "simplex") return ExactCellKind::simplex;
    if (word == "polygon") return ExactCellKind::polygon;
    if (word == "polyhedron") return ExactCellKind::polyhedron;
    lines_.fail(io::quoted(word) + " is no kind of cell (simplex, polygon, polyhedron)");
  }

  void read_corners(ExactCellKind kind, std::size_t first) {
    const std::size_t count = lines_.words().size() - first;
    if (kind == ExactCellKind::polygon && count < 3) lines_.fail("a polygon has at least three corners");
    if (count == 0) lines_.fail("a simplex needs a vertex");
    if (kind == ExactCellKind::simplex && count > SimplicialComplex::most_vertices) {
      lines_.fail("a simplex of " + std::to_string(count) + " vertices; more than " +
                  std::to_string(SimplicialComplex::most_vertices) + " have too many faces");
    }
    for (std::size_t w = first; w < lines_.words().size(); ++w)
      numbers_.push_back(lines_.index(w, cells_.point_count()));
    sorted_.assign(numbers_.begin(), numbers_.end());
    std::ranges::sort(sorted_);
    const auto twice = std::ranges::adjacent_find(sorted_);
    if (twice != sorted_.end()) lines_.fail("point " + std::to_string(*twice) + " stands here twice");
  }

  void read_faces(std::size_t first) {
    if (cells_.dimension < 3) lines_.fail("there are no polyhedra in the plane");
    used_.resize(2 * cells_.cell_count());
    sides_.clear();
    for (std::size_t w = first; w < lines_.words().size(); ++w) {
      const std::string_view word = lines_.words()[w];
      if (word[0] != '+' && word[0] != '-') lines_.fail(io::quoted(word) + " has no sign; faces are +F or -F");
      const std::uint32_t face = lines_.index(word.substr(1), cells_.cell_count());
      const bool is_turned = word[0] == '-';
      if (face >= (1U << 31)) lines_.fail("faces have numbers below 2^31");
      const bool is_face = cells_.kinds[face] == ExactCellKind::polygon ||
                           (cells_.kinds[face] == ExactCellKind::simplex && cells_.cell(face).size() == 3);
      if (!is_face) lines_.fail("cell " + std::to_string(face) + " is neither a polygon nor a triangle");
      numbers_.push_back(ExactCells::part_of(face, is_turned));
      if (used_[numbers_.back()]) lines_.fail("there is a polyhedron on this side of face " + std::to_string(face));
      used_[numbers_.back()] = true;
      add_sides(cells_.cell(face), is_turned, static_cast<std::uint32_t>(w - first));
    }
    if (numbers_.size() < 4) lines_.fail("a polyhedron has at least four faces");
    const std::string defect = io::why_no_sphere(sides_, static_cast<std::uint32_t>(numbers_.size()));
    if (!defect.empty()) lines_.fail("the faces do not bound a polyhedron: " + defect);
  }

  void add_sides(std::span<const std::uint32_t> corners, bool is_turned, std::uint32_t face) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[i + 1 < corners.size() ? i + 1 : 0];
      sides_.push_back({is_turned ? std::array{b, a} : std::array{a, b}, face});
    }
  }

  io::ExactLines lines_;
  const Context& context_;
  ExactCells cells_;
  std::vector<std::uint32_t> numbers_;  // of the present cell
  std::vector<std::uint32_t> sorted_;
  std::vector<io::FaceSide> sides_;
  std::vector<bool> used_;  // by face and the side of it
};

}  // namespace

ExactCells read_cells_text(std::string_view text, const std::string& name, const Context& context) {
  return CellsReader(text, name, context).run();
}

bool is_cells_text(std::string_view text) {
  return io::first_word(text, '#') == "quoin-cells";
}

}  // namespace quoin
