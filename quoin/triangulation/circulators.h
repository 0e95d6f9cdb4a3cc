// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// Slot of a vertex in a cell that has it.
inline unsigned slot_of(const TriangulationCell& cell, std::uint32_t vertex) {
  unsigned slot = 0;
  while (cell.vertices[slot] != vertex) ++slot;
  return slot;
}

/// Calls `visit(cell)` for each cell around the edge of two slots of a cell of space, ghosts too, once around,
/// counterclockwise seen from the second vertex: the other two vertices of the first cell, as its orientation has them,
/// are followed by those of the next.
template <class Visit>
void for_each_around_edge(std::span<const TriangulationCell> cells, std::uint32_t cell, unsigned from, unsigned to,
                          const Visit& visit) {
  // The other slots, so that (from, to, behind, ahead) is even: the cell's own orientation.
  unsigned behind = 0;
  while (behind == from || behind == to) ++behind;
  unsigned ahead = 6 - from - to - behind;
  if (!is_even_order<unsigned>({from, to, behind, ahead})) std::swap(behind, ahead);
  std::uint32_t at = cell;
  do {
    visit(at);
    // Through the facet of the edge and the vertex ahead, which is behind afterwards.
    const std::uint32_t mate = cells[at].neighbours[behind];
    const std::uint32_t pivot = cells[at].vertices[ahead];
    at = mate >> 2;
    ahead = mate & 3;
    behind = slot_of(cells[at], pivot);
  } while (at != cell);
}

/// All cells that have the vertex, ghosts too, in no order but with `first`, which is one of them, first; simplices of
/// `size` vertices. The list is written over. O(d) for a star of d cells. @throws Cancelled where there is a context
void find_star(std::span<const TriangulationCell> cells, unsigned size, std::uint32_t vertex, std::uint32_t first,
               std::vector<std::uint32_t>& list, const Context* context = nullptr);
/// Of a star: its vertices but for this one and infinity, ascending. The list is written over.
void find_link_vertices(std::span<const TriangulationCell> cells, unsigned size, std::uint32_t vertex,
                        std::span<const std::uint32_t> star, std::vector<std::uint32_t>& list);

/// The cells of each vertex of a Delaunay or regular triangulation, found by walking around it from one of them.
class VertexStars {
 public:
  static constexpr std::uint32_t no_cell = 0xFFFFFFFF;

  /// O(n), 4 bytes per vertex. The triangulation must outlive this.
  explicit VertexStars(const TriangulationView3& triangulation);

  /// Some cell of the vertex; `no_cell` of a hidden one, of which nothing else is to be asked.
  std::uint32_t cell(std::uint32_t vertex) const { return first_[vertex]; }

  /// All cells that have the vertex, ghosts too, in no order.
  std::vector<std::uint32_t> star(std::uint32_t vertex) const;
  /// All vertices that share an edge with it, ascending, without infinity.
  std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const;
  /// On the boundary of the hull: a neighbour of infinity.
  bool is_on_hull(std::uint32_t vertex) const;

 private:
  std::span<const TriangulationCell> cells_;
  unsigned size_;
  std::vector<std::uint32_t> first_;
};

}  // namespace quoin
