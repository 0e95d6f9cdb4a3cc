// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/simplex_text.h"
#include "quoin/topology/simplex_list.h"

namespace quoin {

/// Cells divided into simplices.
struct CellSimplices {
  SimplexList simplices;            ///< points have their numbers, others are new
  std::vector<std::uint32_t> cell;  ///< of each simplex, the cell inside which it lies
};

/// A simplex, a triangle as polygon and a tetrahedron as polyhedron stay whole; any other polygon becomes the cone of a
/// new vertex over its sides, any other polyhedron the cone of a new vertex over its divided faces: with all simplices
/// that are not in its boundary. Cells that share a face share its simplices. O(n log n)
/// @throws InputError  2^32 vertices or more; Cancelled
CellSimplices simplices_of_cells(const ExactCells& cells, const Context& context);

/// The same as a filtration: each simplex enters with its cell, at that one's number `value`. Faces of cells that are
/// no cells themselves are not listed.
/// @throws InputError  naming the file: there is no such column, or a cell has none; no cell at all; and as above
FiltrationText filtration_of_cells(const ExactCells& cells, const std::string& name, const Context& context);

}  // namespace quoin
