// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regions2.h"

#include <utility>

namespace quoin {

namespace {

constexpr std::uint32_t none = Vertex2::none_value;

// What the winding number gains from the right of the edge to its left.
std::int64_t gain(const ConstrainedDelaunay2& triangulation, Edge2 e) {
  const std::size_t piece = *triangulation.piece(e);
  std::int64_t sum = 0;
  for (const SegmentUse2& use : triangulation.uses(piece)) sum += use.reversed ? -1 : 1;
  return triangulation.links().source(e) == triangulation.pieces()[piece].source ? sum : -sum;
}

}  // namespace

Regions2::Regions2(const ConstrainedDelaunay2& triangulation) {
  const Triangulation2& links = triangulation.links();
  region_.assign(links.triangle_count(), none);
  if (region_.empty()) {
    depth_.push_back(0);
    winding_.push_back(0);
    return;
  }
  // Regions of one depth after the other: an edge across which nothing is known yet leads one deeper.
  std::vector<Edge2> entries{links.edge_from(links.infinite_vertex())};
  std::vector<Edge2> deeper;
  std::vector<Triangle2> pending;
  for (std::uint32_t depth = 0; !entries.empty(); ++depth, entries = std::exchange(deeper, {})) {
    for (const Edge2 entry : entries) {
      if (region_[entry.triangle().index()] != none) continue;
      const auto region = static_cast<std::uint32_t>(depth_.size());
      depth_.push_back(depth);
      winding_.push_back(
          depth == 0 ? 0 : winding_[region_[links.twin(entry).triangle().index()]] + gain(triangulation, entry));
      region_[entry.triangle().index()] = region;
      pending.push_back(entry.triangle());
      while (!pending.empty()) {
        const Triangle2 t = pending.back();
        pending.pop_back();
        for (unsigned slot = 0; slot < 3; ++slot) {
          const Edge2 other = links.twin(Edge2(t, slot));
          if (region_[other.triangle().index()] != none) continue;
          if (triangulation.is_constrained(other)) {
            deeper.push_back(other);
          } else {
            region_[other.triangle().index()] = region;
            pending.push_back(other.triangle());
          }
        }
      }
    }
  }
  for (std::uint32_t t = 0; t < region_.size(); ++t) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(Triangle2(t), slot);
      if (!triangulation.is_constrained(e)) continue;
      const std::uint32_t right = region_[links.twin(e).triangle().index()];
      if (winding_[region_[t]] - winding_[right] != gain(triangulation, e)) has_windings_ = false;
    }
  }
}

}  // namespace quoin
