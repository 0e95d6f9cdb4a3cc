// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "quoin/triangulation/cell_array.h"

namespace quoin {

/// Number of the edge between two slots of a simplex; the opposite one is 5 minus it.
inline constexpr std::array<std::array<unsigned, 4>, 4> edge_number{
    {{6, 0, 1, 2}, {0, 6, 3, 4}, {1, 3, 6, 5}, {2, 4, 5, 6}}};
/// Number of the edge of the other two slots; 6 of a slot and itself.
inline constexpr std::array<std::array<unsigned, 4>, 4> opposite_edge{
    {{6, 5, 4, 3}, {5, 6, 2, 1}, {4, 2, 6, 0}, {3, 1, 0, 6}}};
/// Slots of an edge, ascending.
inline constexpr std::array<std::array<unsigned, 2>, 6> edge_slots{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The other two slots, so that (from, to, behind, ahead) has the orientation of the simplex: for each pair of slots.
struct OtherSlots {
  unsigned behind;
  unsigned ahead;
};
inline constexpr std::array<std::array<OtherSlots, 4>, 4> other_slots{{{{{0, 0}, {2, 3}, {3, 1}, {1, 2}}},
                                                                       {{{3, 2}, {1, 1}, {0, 3}, {2, 0}}},
                                                                       {{{1, 3}, {3, 0}, {2, 2}, {0, 1}}},
                                                                       {{{2, 1}, {0, 2}, {1, 0}, {3, 3}}}}};

/// A place in the ring of simplices around an edge: the simplex, and the slots of its two vertices off the edge. The
/// facet opposite to `behind` is the one through which the walk goes on.
struct RingPlace {
  std::uint32_t cell;
  unsigned behind;
  unsigned ahead;

  /// Slot of the facet with the vertex ahead, whatever the direction.
  unsigned facet_ahead() const { return behind; }
  /// The slots of the edge.
  std::array<unsigned, 2> edge() const { return edge_slots[5 - edge_number[behind][ahead]]; }

  RingPlace next(std::span<const TriangulationCell> cells) const {
    const TriangulationCell& here = cells[cell];
    const std::uint32_t mate = here.neighbours[behind];
    const std::uint32_t pivot = here.vertices[ahead];
    const std::array<std::uint32_t, 4>& there = cells[mate >> 2].vertices;
    const unsigned slot = static_cast<unsigned>(there[1] == pivot) + 2 * static_cast<unsigned>(there[2] == pivot) +
                          3 * static_cast<unsigned>(there[3] == pivot);
    return {mate >> 2, slot, mate & 3};
  }
};

}  // namespace quoin
