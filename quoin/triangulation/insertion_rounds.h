// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/insertion_round.h"
#include "quoin/triangulation/insertion_split.h"
#include "quoin/triangulation/region_insertion.h"

namespace quoin {

/// Triangulates vertices 0 to count - 1, and those of the simplex, which are four that are not coplanar; one of these
/// may be the vertex `count`. Calls `when_hidden` with vertices that are none of the triangulation, now or any more.
/// The cells and their order do not depend on threads.
/// @throws InputError where there are more than 2^30 cells; Cancelled
template <class Signs, class WhenHidden>
CellArray insert_in_rounds(const Signs& signs, std::size_t count, const std::array<std::uint32_t, 4>& simplex,
                           const Context& context, const WhenHidden& when_hidden, const InsertionSplit& split) {
  constexpr std::size_t cells_per_point = 8;  // somewhat more than in a volume; only what is used takes memory
  using Engine = IncrementalTriangulation<Signs>;
  CellArray cells;
  cells.reserve((count + 1) * cells_per_point + 64);
  Engine engine(signs, cells);
  engine.start(simplex);
  const auto cycle = static_cast<std::uint32_t>(count + 1);
  InsertionProgress progress(context, count);
  RegionInsertion<Signs> regions(signs, cells, engine, cycle, split.regions, progress, context);
  std::size_t tried = 0;
  const auto insert = [&](std::uint32_t v) {
    if (engine.insert(v, WholeRegion(), when_hidden) == Engine::Place::hidden) when_hidden(v);
    if (++tried % 1024 == 0) progress.add(1024);
  };
  for (unsigned round = insertion_rounds; round-- > 0;) {
    const auto is_of_round = [&](std::uint32_t v) {
      return insertion_round(v) == round && std::find(simplex.begin(), simplex.end(), v) == simplex.end();
    };
    const std::size_t points = round + 1 < insertion_rounds ? (count - count / 8) >> (3 * round) : 0;
    if (split.regions < 2 || points < split.regions * split.least_points) {
      for (std::uint32_t v = 0; v < count; ++v) {
        if (v % 65536 == 0) context.poll();
        if (is_of_round(v)) insert(v);
      }
      continue;
    }
    const auto visit = [&](const RankRegion& region, const auto& insert_one) {
      for (const auto& [begin, end] : region.runs()) {
        for (std::uint32_t v = begin; v < std::min<std::size_t>(end, count); ++v) {
          if (is_of_round(v)) insert_one(v);
        }
      }
    };
    std::vector<std::uint32_t> late = regions.insert(split.regions, 0, points, visit, when_hidden);
    // Halves of Hilbert's curve are halves of a cube, and from a quarter on they are so across another axis.
    constexpr std::array<double, 2> halves{0, 0.25};
    for (const double begin : halves) {
      if (late.size() < split.least_points / 4 || !regions.has_room()) break;
      if (begin == 0 && split.regions == 2) continue;
      const auto visit_late = [&](const RankRegion& region, const auto& insert_one) {
        for (const std::uint32_t v : late) {
          if (region.contains(v)) insert_one(v);
        }
      };
      late = regions.insert(2, begin, late.size(), visit_late, when_hidden);
    }
    std::for_each(late.begin(), late.end(), insert);
  }
  engine.compact();
  return cells;
}

}  // namespace quoin
