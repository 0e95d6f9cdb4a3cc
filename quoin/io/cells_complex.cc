// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/cells_complex.h"

#include <algorithm>
#include <array>
#include <span>

#include "quoin/base/error.h"

namespace quoin {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Divider {
 public:
  Divider(const ExactCells& cells, const Context& context)
      : cells_(cells), context_(context), next_(cells.point_count()) {}

  CellSimplices run() {
    apex_.resize(cells_.cell_count());
    for (std::uint32_t c = 0; c < cells_.cell_count(); ++c) {
      if (c % 1024 == 0) context_.poll();
      const std::span<const std::uint32_t> parts = cells_.cell(c);
      if (cells_.kinds[c] == ExactCellKind::polyhedron) {
        add_polyhedron(c, parts);
      } else if (is_whole(c)) {
        add(c, parts);
      } else {
        add_polygon(c, parts);
      }
    }
    return std::move(result_);
  }

 private:
  bool is_whole(std::uint32_t c) const {
    return cells_.kinds[c] == ExactCellKind::simplex || cells_.cell(c).size() == 3;
  }

  void add(std::uint32_t cell, std::span<const std::uint32_t> vertices) {
    result_.simplices.add(vertices);
    result_.cell.push_back(cell);
  }

  std::uint32_t new_vertex() {
    if (next_ >= 0xFFFFFFFFU) throw InputError("the cells need 2^32 vertices or more");
    return static_cast<std::uint32_t>(next_++);
  }

  void add_polygon(std::uint32_t c, std::span<const std::uint32_t> corners) {
    const std::uint32_t apex = apex_[c] = new_vertex();
    add(c, std::array{apex});
    for (const std::uint32_t v : corners) add(c, std::array{v, apex});
    for (const Triangle& t : triangles_of(c)) add(c, t);
  }

  std::vector<Triangle> triangles_of(std::uint32_t face) const {
    const std::span<const std::uint32_t> v = cells_.cell(face);
    if (is_whole(face)) return {{v[0], v[1], v[2]}};
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < v.size(); ++i)
      triangles.push_back({v[i], v[i + 1 < v.size() ? i + 1 : 0], apex_[face]});
    return triangles;
  }

  void add_polyhedron(std::uint32_t c, std::span<const std::uint32_t> parts) {
    boundary_.clear();
    for (const std::uint32_t part : parts) {
      const std::vector<Triangle> triangles = triangles_of(ExactCells::face_of(part));
      boundary_.insert(boundary_.end(), triangles.begin(), triangles.end());
    }
    std::vector<std::uint32_t> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const Triangle& t : boundary_) {
      for (std::size_t i = 0; i < 3; ++i) {
        vertices.push_back(t[i]);
        const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
        edges.push_back({low, high});
      }
    }
    keep_one_of_each(vertices);
    if (vertices.size() == 4 && boundary_.size() == 4) return add(c, vertices);
    keep_one_of_each(edges);
    const std::uint32_t apex = new_vertex();
    add(c, std::array{apex});
    for (const std::uint32_t v : vertices) add(c, std::array{v, apex});
    for (const auto& [a, b] : edges) add(c, std::array{a, b, apex});
    for (const Triangle& t : boundary_) add(c, std::array{t[0], t[1], t[2], apex});
  }

  template <class T>
  static void keep_one_of_each(std::vector<T>& list) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  const ExactCells& cells_;
  const Context& context_;
  std::size_t next_;
  std::vector<std::uint32_t> apex_;  // by polygon that is divided
  std::vector<Triangle> boundary_;   // of the present polyhedron
  CellSimplices result_;
};

}  // namespace

CellSimplices simplices_of_cells(const ExactCells& cells, const Context& context) {
  return Divider(cells, context).run();
}

FiltrationText filtration_of_cells(const ExactCells& cells, const std::string& name, const Context& context) {
  const ExactNumbers* const values = cells.cell_data.find_numbers("value");
  if (values == nullptr) throw InputError(name + ": its cells have no numbers 'value', at which they enter");
  if (cells.cell_count() == 0) throw InputError(name + ": there is no cell");
  for (std::size_t c = 0; c < values->size(); ++c) {
    if (values->is_none(c)) throw InputError(name + ": cell " + std::to_string(c) + " has no value");
  }
  CellSimplices divided = simplices_of_cells(cells, context);
  Grades<Rational> grades = values->grades();
  FiltrationText result{std::move(divided.simplices), {}, std::move(grades.values)};
  result.grades.reserve(divided.cell.size());
  for (const std::uint32_t c : divided.cell) result.grades.push_back(grades.grade[c]);
  return result;
}

}  // namespace quoin
