// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/regular_signs.h"

namespace quoin {

struct RegularCells {
  CellArray cells;
  std::vector<std::uint32_t> hidden;  ///< vertices of no cell, in no order
};

/// `insert_in_rounds` of weighted points.
RegularCells regular_cells(const RegularSigns& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                           const Context& context);

}  // namespace quoin
