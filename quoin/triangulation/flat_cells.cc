// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/flat_cells.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace quoin {

CellArray without_apex(const CellArray& cells, std::uint32_t apex) {
  CellArray flat;
  std::vector<std::uint32_t> number(cells.size(), no_vertex);
  std::vector<std::array<std::uint32_t, 4>> place(cells.size());  // slot here of each slot there
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::array<std::uint32_t, 4>& v = cells[c].vertices;
    const auto at = static_cast<unsigned>(std::find(v.begin(), v.end(), apex) - v.begin());
    if (at == 4) continue;
    // The apex last, infinity before it; the first two so that the permutation is even.
    const unsigned third = v[3] == vertex_at_infinity ? 3 : at == 3 ? 2 : 3;
    std::array<unsigned, 4> from{4, 4, third, at};
    for (unsigned i = 0; i < 4; ++i) {
      if (i != third && i != at) from[from[0] == 4 ? 0 : 1] = i;
    }
    if (!is_even_order(from)) std::swap(from[0], from[1]);
    number[c] = static_cast<std::uint32_t>(flat.size());
    TriangulationCell cell{};
    for (unsigned i = 0; i < 4; ++i) {
      cell.vertices[i] = v[from[i]];
      cell.neighbours[i] = cells[c].neighbours[from[i]];
      place[c][from[i]] = i;
    }
    flat.push_back(cell);
  }
  for (TriangulationCell& cell : flat) {
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t mate = cell.neighbours[i];
      cell.neighbours[i] = number[mate >> 2] * 4 + place[mate >> 2][mate & 3];
    }
    cell.vertices[3] = no_vertex;
    cell.neighbours[3] = no_vertex;
  }
  return flat;
}

void turn_over(CellArray& cells) {
  // The first two slots change places everywhere.
  const auto other = [](std::uint32_t code) { return (code & 2) == 0 ? code ^ 1U : code; };
  for (TriangulationCell& cell : cells) {
    std::swap(cell.vertices[0], cell.vertices[1]);
    std::swap(cell.neighbours[0], cell.neighbours[1]);
    for (std::uint32_t& code : cell.neighbours) code = other(code);
  }
}

CellArray cells_of_chain(std::span<const std::uint32_t> chain) {
  CellArray cells;
  constexpr std::uint32_t none = no_vertex;
  const auto segments = static_cast<std::uint32_t>(chain.size() - 1);
  if (segments == 0) {
    cells.push_back({{chain[0], none, none, none}, {4, none, none, none}});
    cells.push_back({{vertex_at_infinity, none, none, none}, {0, none, none, none}});
    return cells;
  }
  // Two ghosts close the circle; each faces its segment with the slot of infinity.
  const std::uint32_t left = segments;
  const std::uint32_t right = segments + 1;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = i + 1 < segments ? (i + 1) * 4 + 1 : right * 4 + 1;
    const std::uint32_t previous = i > 0 ? (i - 1) * 4 : left * 4 + 1;
    cells.push_back({{chain[i], chain[i + 1], none, none}, {next, previous, none, none}});
  }
  cells.push_back({{chain.front(), vertex_at_infinity, none, none}, {right * 4, 1, none, none}});
  cells.push_back({{chain.back(), vertex_at_infinity, none, none}, {left * 4, (segments - 1) * 4, none, none}});
  return cells;
}

}  // namespace quoin
