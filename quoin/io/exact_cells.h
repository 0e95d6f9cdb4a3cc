// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quoin/io/exact_numbers.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

enum class ExactCellKind : std::uint8_t { simplex, polygon, polyhedron };

/// Columns of numbers, one per point or cell: whole ones, and exact ones.
struct ExactColumns {
  static constexpr std::uint32_t none = 0xFFFFFFFF;  ///< of a whole number that is not there
  using Integers = std::pair<std::string, std::vector<std::uint32_t>>;
  using Numbers = std::pair<std::string, ExactNumbers>;
  std::vector<Integers> integers;
  std::vector<Numbers> numbers;

  /// The column of that name; null if there is none.
  const ExactNumbers* find_numbers(std::string_view name) const;
  const std::vector<std::uint32_t>* find_integers(std::string_view name) const;
  friend bool operator==(const ExactColumns&, const ExactColumns&) = default;
};

/// Cells over points of the plane or of space, with exact coordinates: simplices of any dimension, convex polygons, and
/// convex polyhedra by their faces. No promise about how they lie: `read_cells_text` checks that polyhedra are closed.
struct ExactCells {
  unsigned dimension = 3;   ///< coordinates of a point: 2 or 3
  ExactNumbers positions;   ///< so many for each point, one after the other
  ExactColumns point_data;  ///< see docs/exact-text.md for the names that have a meaning
  ExactColumns cell_data;
  std::vector<ExactCellKind> kinds;   ///< one per cell
  std::vector<std::uint32_t> parts;   ///< one cell after the other, see `cell`
  std::vector<std::size_t> begin{0};  ///< offsets into parts

  std::size_t point_count() const { return positions.size() / dimension; }
  std::size_t cell_count() const { return kinds.size(); }
  /// The points of a simplex; those of a polygon in order around it; of a polyhedron the numbers of cells before it
  /// that are its faces, polygons or triangles, each by `face_of` and `is_turned`.
  std::span<const std::uint32_t> cell(std::size_t c) const {
    return {parts.data() + begin[c], begin[c + 1] - begin[c]};
  }
  static constexpr std::uint32_t face_of(std::uint32_t part) { return part / 2; }
  /// Whether the corners of the face are clockwise seen from outside the polyhedron.
  static constexpr bool is_turned(std::uint32_t part) { return part % 2 != 0; }
  static constexpr std::uint32_t part_of(std::uint32_t face, bool is_turned) { return 2 * face + (is_turned ? 1 : 0); }

  void add_point(const Point3& p) {
    for (unsigned k = 0; k < dimension; ++k) positions.add(p[k]);
  }
  void add_point(const RationalPoint3& p) {
    for (unsigned k = 0; k < dimension; ++k) positions.add(p[k]);
  }
  void add_cell(ExactCellKind kind, std::span<const std::uint32_t> numbers) {
    parts.insert(parts.end(), numbers.begin(), numbers.end());
    begin.push_back(parts.size());
    kinds.push_back(kind);
  }
  friend bool operator==(const ExactCells&, const ExactCells&) = default;
};

inline const ExactNumbers* ExactColumns::find_numbers(std::string_view name) const {
  for (const auto& [its_name, values] : numbers) {
    if (its_name == name) return &values;
  }
  return nullptr;
}

inline const std::vector<std::uint32_t>* ExactColumns::find_integers(std::string_view name) const {
  for (const auto& [its_name, values] : integers) {
    if (its_name == name) return &values;
  }
  return nullptr;
}

}  // namespace quoin
