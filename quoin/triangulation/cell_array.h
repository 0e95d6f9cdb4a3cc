// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "quoin/base/large_vector.h"

namespace quoin {

/// A simplex of a triangulation of space: four vertices, positively oriented, and what lies across the facet opposite
/// to each, as cell * 4 + the slot there that is opposite to the common facet.
///
/// A ghost is the cone of a facet of the hull to the vertex at infinity, which is in its last slot; its other vertices
/// are counterclockwise seen from outside.
struct alignas(32) TriangulationCell {
  std::array<std::uint32_t, 4> vertices;
  std::array<std::uint32_t, 4> neighbours;
};
static_assert(sizeof(TriangulationCell) == 32);

using CellArray = UnsetVector<TriangulationCell>;

/// Number of the vertex at infinity, of every triangulation.
inline constexpr std::uint32_t vertex_at_infinity = 0x7FFFFFFF;
/// What stands in slots that a triangulation of lower dimension does not use.
inline constexpr std::uint32_t no_vertex = 0xFFFFFFFF;

/// Slots of the facet opposite to each slot, so that the facet's vertices and the one opposite are positively oriented;
/// the last slot stays last.
inline constexpr std::array<std::array<unsigned, 3>, 4> facet_slots{{{2, 1, 3}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}}};

/// Whether the first `size` slots come from ascending ones by an even number of exchanges: a simplex with its vertices
/// in this order is oriented as before.
template <class Slot>
constexpr bool is_even_order(const std::array<Slot, 4>& slots, unsigned size = 4) {
  unsigned inversions = 0;
  for (unsigned i = 0; i < size; ++i) {
    for (unsigned j = 0; j < i; ++j) inversions += slots[j] > slots[i] ? 1 : 0;
  }
  return inversions % 2 == 0;
}

}  // namespace quoin
