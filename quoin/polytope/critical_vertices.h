// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/tiled_surface.h"

namespace quoin {

/// The vertices of a surface that are critical for the height along a direction, each with its count: 1 less the
/// Euler number of what is near it and higher. A peak counts 1, a vertex on a slope 0, a saddle -1 or less, or 0.
///
/// The direction moves along arcs; where it crosses the arc of an edge, counts at its ends change.
class CriticalVertices {
 public:
  /// The surface must outlive it.
  explicit CriticalVertices(const TiledSurface& surface)
      : surface_(surface), counts_(surface.point_count(), 0), place_(surface.point_count(), 0) {}

  std::span<const std::uint32_t> vertices() const { return vertices_; }
  int count(std::uint32_t vertex) const { return counts_[vertex]; }

  /// Places the direction n. `height` gives the sign of n.d along an edge, `side_of_path` that of m.d for the normal of
  /// a tile and a direction d perpendicular to n. The count and that of -n add up to what changes of height around a
  /// vertex tell, and differ by the edges whose arcs cross the half circle from -n to n that turns about d.
  /// O(edges).
  template <class Height, class SideOfPath>
  void start(const Height& height, const SideOfPath& side_of_path);

  /// The count at the head of an edge grows by `change`, that at its tail falls.
  void move(const TiledSurface::Edge& edge, int change) {
    add(edge.head, change);
    add(edge.tail, -change);
  }

 private:
  void add(std::uint32_t vertex, int change) {
    const int before = counts_[vertex];
    counts_[vertex] += change;
    if (before == 0) {
      place_[vertex] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(vertex);
    } else if (counts_[vertex] == 0) {
      const std::uint32_t last = vertices_.back();
      vertices_[place_[vertex]] = last;
      place_[last] = place_[vertex];
      vertices_.pop_back();
    }
  }

  const TiledSurface& surface_;
  std::vector<int> counts_;
  std::vector<std::uint32_t> vertices_;  // of count not 0
  std::vector<std::uint32_t> place_;     // in vertices_
};

template <class Height, class SideOfPath>
void CriticalVertices::start(const Height& height, const SideOfPath& side_of_path) {
  const auto edges = surface_.edges();
  const auto tiles = surface_.tiles();
  std::vector<int> rises(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) rises[e] = to_int(height(edges[e]));
  const auto rise = [&](std::uint32_t halfedge) {
    const std::uint32_t e = surface_.edge_of(halfedge);
    return edges[e].halfedge == halfedge ? rises[e] : -rises[e];
  };
  std::vector<int> fourfold(surface_.point_count(), 0);  // four times each count
  for (std::uint32_t v = 0; v < fourfold.size(); ++v) fourfold[v] = 2 * static_cast<int>(surface_.fan_counts()[v]);
  for (std::uint32_t t = 0; t < tiles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (rise(3 * t + k) != -rise(3 * t + (k + 2) % 3)) --fourfold[tiles[t][k]];
    }
  }
  std::vector<int> sides(tiles.size());
  for (std::uint32_t t = 0; t < tiles.size(); ++t) sides[t] = to_int(side_of_path(t));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const TiledSurface::Edge& edge = edges[e];
    const int left = sides[TiledSurface::tile_of(edge.halfedge)];
    if (edge.sign == 0 || left == sides[TiledSurface::tile_of(edge.twin)] || rises[e] != edge.sign * left) continue;
    fourfold[edge.head] += 2 * rises[e] * edge.sign;
    fourfold[edge.tail] -= 2 * rises[e] * edge.sign;
  }
  for (const std::uint32_t v : vertices_) counts_[v] = 0;
  vertices_.clear();
  for (std::uint32_t v = 0; v < fourfold.size(); ++v) {
    if (fourfold[v] % 4 != 0) throw InternalError("a critical vertex of a convolution has no whole count");
    if (fourfold[v] != 0) add(v, fourfold[v] / 4);
  }
}

}  // namespace quoin
