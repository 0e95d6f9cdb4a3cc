// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/canonical_cells.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace quoin {

namespace {

using Slots = std::array<std::uint8_t, 4>;

/// Slots of a cell in their new order. Infinity is larger than all vertices, so it is last where the orientation
/// allows.
Slots order_of(const TriangulationCell& cell, unsigned dimension) {
  const auto& v = cell.vertices;
  Slots slots{0, 1, 2, 3};
  for (unsigned i = 1; i <= dimension; ++i) {
    for (unsigned j = i; j > 0 && v[slots[j]] < v[slots[j - 1]]; --j) std::swap(slots[j], slots[j - 1]);
  }
  if (dimension < 2 || is_even_order(slots, dimension + 1)) return slots;
  const bool is_ghost = v[slots[dimension]] == vertex_at_infinity;
  // Two slots are exchanged: the last ones, but for infinity.
  if (is_ghost) {
    std::swap(slots[dimension - 2], slots[dimension - 1]);
  } else {
    std::swap(slots[dimension - 1], slots[dimension]);
  }
  return slots;
}

}  // namespace

void sort_cells(CellArray& cells, int dimension) {
  const auto d = static_cast<unsigned>(dimension);
  std::uint32_t highest = 0;
  std::vector<Slots> slots(cells.size());  // old slot of each new one
  for (std::size_t c = 0; c < cells.size(); ++c) {
    slots[c] = order_of(cells[c], d);
    const std::uint32_t first = cells[c].vertices[slots[c][0]];
    if (first != vertex_at_infinity) highest = std::max(highest, first);
  }
  const auto key = [&](std::uint32_t c, unsigned i) { return cells[c].vertices[slots[c][i]]; };
  std::vector<std::uint32_t> begin(std::size_t{highest} + 3, 0);
  for (std::uint32_t c = 0; c < cells.size(); ++c) ++begin[std::min(key(c, 0), highest + 1) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> order(cells.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t c = 0; c < cells.size(); ++c) order[next[std::min(key(c, 0), highest + 1)]++] = c;
  for (std::size_t b = 0; b + 1 < begin.size(); ++b) {
    std::sort(order.begin() + begin[b], order.begin() + begin[b + 1], [&](std::uint32_t p, std::uint32_t q) {
      for (unsigned i = 1; i <= d; ++i) {
        if (key(p, i) != key(q, i)) return key(p, i) < key(q, i);
      }
      return false;
    });
  }
  std::vector<std::uint32_t> number(cells.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  CellArray sorted(cells.size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    TriangulationCell& to = sorted[number[c]];
    to = cells[c];
    for (unsigned i = 0; i <= d; ++i) {
      to.vertices[i] = cells[c].vertices[slots[c][i]];
      const std::uint32_t mate = cells[c].neighbours[slots[c][i]];
      const Slots& there = slots[mate >> 2];
      const auto at = static_cast<std::uint32_t>(std::find(there.begin(), there.end(), mate & 3) - there.begin());
      to.neighbours[i] = number[mate >> 2] * 4 + at;
    }
  }
  cells = std::move(sorted);
}

}  // namespace quoin
