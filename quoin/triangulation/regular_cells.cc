// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular_cells.h"

#include "quoin/triangulation/insertion_rounds.h"

namespace quoin {

RegularCells regular_cells(const RegularSigns& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                           const Context& context) {
  RegularCells result;
  const auto hide = [&result](std::uint32_t v) { result.hidden.push_back(v); };
  result.cells = insert_in_rounds(signs, count, simplex, context, hide, InsertionSplit::of(count));
  return result;
}

}  // namespace quoin
