// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/insertion_order2.h"
#include "quoin/triangulation/insertion_split.h"
#include "quoin/triangulation/region_insertion2.h"

namespace quoin::detail {

/// The first of `count` vertices off the line of the first two, with these, counterclockwise: what an insertion starts
/// from. `turn(i)` is that of vertices 0, 1 and i.
template <class Turn>
std::optional<std::array<std::uint32_t, 3>> first_triangle(std::size_t count, const Turn& turn,
                                                           const Context& context) {
  for (std::uint32_t i = 2; i < count; ++i) {
    if (i % 4096 == 0) context.poll();
    const Sign side = turn(i);
    if (side == Sign::positive) return std::array<std::uint32_t, 3>{0, 1, i};
    if (side == Sign::negative) return std::array<std::uint32_t, 3>{1, 0, i};
  }
  return std::nullopt;
}

/// Moves triangles from the end into places where there are none.
inline void close_holes(TriangleArray2& triangles, std::vector<std::uint32_t> holes) {
  std::sort(holes.begin(), holes.end(), std::greater<>());
  for (const std::uint32_t hole : holes) close_hole(triangles, hole);
}

/// Triangulates vertices 0 to count - 1, starting with three that turn counterclockwise, in rounds of growing size,
/// each along the order of the vertices (Amenta, Choi and Rote 2003), the larger ones in regions. Triangles and their
/// order do not depend on threads.
template <class Predicates>
TriangleArray2 insert_in_rounds(const Predicates& predicates, std::size_t count,
                                const std::array<std::uint32_t, 3>& start, const InsertionSplit& split,
                                const Context& context) {
  using Engine = Insertion2<Predicates>;
  const auto vertex_count = static_cast<std::uint32_t>(count);
  TriangleArray2 triangles(2 * (count - 1));
  Engine engine(predicates, triangles, vertex_count);
  engine.start(start);
  const InsertionOrder2 order(count, start, context);
  InsertionProgress progress(context, count);
  RegionInsertion2<Predicates> regions(predicates, triangles, engine, vertex_count, split.regions, progress, context);
  std::size_t tried = 0;
  const auto insert_alone = [&](const PlacedVertex& v) {
    if (++tried % 64 == 0) context.poll();  // exact arithmetic of large spans takes long
    if (tried % 4096 == 0) progress.add(4096);
    engine.insert(v.vertex, v.triangle(), WholePlane());
  };
  for (unsigned round = insertion_rounds; round-- > 0;) {
    const auto visit = [&](std::uint32_t begin, std::uint32_t end, const auto& insert) {
      order.visit(round, begin, end, [&](std::uint32_t v, std::uint32_t place) { insert(PlacedVertex{v, place}); });
    };
    if (split.regions < 2 || order.size(round) < split.regions * split.least_points) {
      visit(0, vertex_count, insert_alone);
      continue;
    }
    std::vector<PlacedVertex> late = regions.insert(split.regions, 0, order.size(round), visit);
    // Halves of Hilbert's curve are halves of a square, and from a quarter on they are so across the other axis.
    constexpr std::array<double, 2> halves{0, 0.25};
    for (const double begin : halves) {
      if (late.size() < split.least_points / 4) break;
      if (begin == 0 && split.regions == 2) continue;
      const auto visit_late = [&late](std::uint32_t first, std::uint32_t end, const auto& insert) {
        const auto precedes = [](PlacedVertex v, std::uint32_t rank) { return v.vertex < rank; };
        auto v = std::lower_bound(late.begin(), late.end(), first, precedes);
        for (; v != late.end() && v->vertex < end; ++v) insert(*v);
      };
      late = regions.insert(2, begin, late.size(), visit_late);
    }
    std::for_each(late.begin(), late.end(), insert_alone);
  }
  if constexpr (Predicates::may_hide) {
    std::vector<std::uint32_t> holes = engine.left_over();
    regions.append_left_over(holes);
    close_holes(triangles, std::move(holes));
  }
  return triangles;
}

}  // namespace quoin::detail
