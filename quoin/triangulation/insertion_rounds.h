// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/triangulation/incremental3.h"
#include "quoin/triangulation/insertion_round.h"

namespace quoin {

/// Triangulates vertices 0 to count - 1, and those of the simplex, which are four that are not coplanar. Calls
/// `when_hidden` with vertices that are none of the triangulation, now or any more.
/// @throws InputError where there are more than 2^30 cells; Cancelled
template <class Signs, class WhenHidden>
CellArray insert_in_rounds(const Signs& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                           const Context& context, const WhenHidden& when_hidden) {
  constexpr std::size_t cells_per_point = 8;  // somewhat more than in a volume; only what is used takes memory
  CellArray cells;
  cells.reserve((count + 1) * cells_per_point + 64);
  IncrementalTriangulation<Signs> engine(signs, count + 1, cells);
  engine.start(simplex);
  std::size_t done = 0;
  for (unsigned round = insertion_rounds; round-- > 0;) {
    for (std::uint32_t v = 0; v < count; ++v) {
      if (insertion_round(v) != round || std::find(simplex.begin(), simplex.end(), v) != simplex.end()) continue;
      if (++done % 1024 == 0) {
        context.progress("triangulate", static_cast<double>(done) / static_cast<double>(count));
      }
      if (!engine.insert(v, when_hidden)) when_hidden(v);
    }
  }
  engine.compact();
  return cells;
}

}  // namespace quoin
