// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "quoin/io/exact_cells.h"

namespace quoin::test {

/// A row of unit cubes along x, their faces as polygons before them.
inline ExactCells row_of_cubes(std::uint32_t count) {
  ExactCells cells;
  const auto point = [](std::uint32_t i, unsigned y, unsigned z) { return 4 * i + 2 * y + z; };
  for (std::uint32_t i = 0; i <= count; ++i) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) cells.add_point(Point3{static_cast<double>(i), y, z});
    }
  }
  const auto add = [&](const std::array<std::uint32_t, 4>& corners) {
    cells.add_cell(ExactCellKind::polygon, corners);
    return static_cast<std::uint32_t>(cells.cell_count() - 1);
  };
  // Each wall is counterclockwise seen from the positive side of x.
  std::vector<std::uint32_t> walls;
  for (std::uint32_t i = 0; i <= count; ++i)
    walls.push_back(add({point(i, 0, 0), point(i, 1, 0), point(i, 1, 1), point(i, 0, 1)}));
  std::vector<std::uint32_t> sides;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const auto& [a, b] : std::array<std::array<unsigned, 2>, 4>{{{0, 1}, {1, 3}, {3, 2}, {2, 0}}})
      sides.push_back(add({4 * i + a, 4 * i + b, 4 * (i + 1) + b, 4 * (i + 1) + a}));
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, 6> parts{ExactCells::part_of(walls[i], true), ExactCells::part_of(walls[i + 1], false)};
    for (std::uint32_t k = 0; k < 4; ++k) parts[2 + k] = ExactCells::part_of(sides[4 * i + k], true);
    cells.add_cell(ExactCellKind::polyhedron, parts);
  }
  return cells;
}

/// Simplices and polygons over points with coordinates of all kinds, with columns of all kinds.
inline ExactCells random_cells(std::mt19937& random) {
  ExactCells cells;
  cells.dimension = 2 + random() % 2;
  const auto add_number = [&](ExactNumbers& numbers) {
    const auto whole = static_cast<int>(random() % 2000) - 1000;
    switch (random() % 5) {
      case 0:
        return numbers.add(static_cast<double>(whole));
      case 1:
        return numbers.add(std::ldexp(whole, static_cast<int>(random() % 1500) - 750));
      case 2:
        return numbers.add(Rational(whole) / Rational(static_cast<int>(1 + random() % 99)));
      case 3:
        return numbers.add(Rational(1e300) * Rational(1e300) * Rational(whole));
      default:
        return numbers.add(0.1 * whole);
    }
  };
  const std::size_t points = 3 + random() % 20;
  for (std::size_t i = 0; i < points * cells.dimension; ++i) add_number(cells.positions);
  for (std::size_t c = random() % 20; c > 0; --c) {
    std::vector<std::uint32_t> numbers(points);
    for (std::uint32_t i = 0; i < points; ++i) numbers[i] = i;
    std::ranges::shuffle(numbers, random);
    const bool is_polygon = random() % 2 == 0;
    numbers.resize(is_polygon ? 3 + random() % (points - 2) : 1 + random() % std::min<std::size_t>(points, 20));
    cells.add_cell(is_polygon ? ExactCellKind::polygon : ExactCellKind::simplex, numbers);
  }
  const auto add_columns = [&](ExactColumns& columns, std::size_t count) {
    for (std::size_t k = random() % 3; k > 0; --k) {
      auto& [name, list] = columns.integers.emplace_back("whole #" + std::to_string(k), std::vector<std::uint32_t>());
      for (std::size_t i = 0; i < count; ++i)
        list.push_back(random() % 4 == 0 ? ExactColumns::none : static_cast<std::uint32_t>(random() % 0xFFFFFFFF));
    }
    for (std::size_t k = random() % 3; k > 0; --k) {
      auto& [name, list] = columns.numbers.emplace_back("exact" + std::to_string(k), ExactNumbers());
      for (std::size_t i = 0; i < count; ++i) {
        if (random() % 4 == 0) {
          list.add_none();
        } else {
          add_number(list);
        }
      }
    }
  };
  add_columns(cells.point_data, points);
  add_columns(cells.cell_data, cells.cell_count());
  return cells;
}

}  // namespace quoin::test
