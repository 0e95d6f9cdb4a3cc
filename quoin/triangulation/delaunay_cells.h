// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "quoin/base/context.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/delaunay_signs.h"

namespace quoin {

struct InsertionSplit;

/// The Delaunay cells of vertices 0 to count - 1, numbered along a curve, and of those of the simplex, which are four
/// that are not coplanar; one of these may be the vertex `count`.
/// @throws InputError where there are more than 2^30 cells; Cancelled
CellArray delaunay_cells(const DelaunaySigns& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                         const InsertionSplit& split, const Context& context);

}  // namespace quoin
