// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/triangulation/cell_array.h"

namespace quoin {

/// From the triangulation in space of points of a plane and an apex off it: that of the plane. Each triangle was the
/// base of a cell with the apex, each ghost at an edge of the hull one with the apex too.
CellArray without_apex(const CellArray& cells, std::uint32_t apex);

/// Orients all cells the other way; of dimension 2 or 3.
void turn_over(CellArray& cells);

/// Segments between vertices along a line, and a ghost at either end. Of one vertex: it and a ghost.
CellArray cells_of_chain(std::span<const std::uint32_t> chain);

}  // namespace quoin
