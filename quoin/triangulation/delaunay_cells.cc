// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_cells.h"

#include "quoin/triangulation/insertion_rounds.h"

namespace quoin {

CellArray delaunay_cells(const DelaunaySigns& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                         const InsertionSplit& split, const Context& context) {
  return insert_in_rounds(
      signs, count, simplex, context, [](std::uint32_t) {}, split);
}

}  // namespace quoin
