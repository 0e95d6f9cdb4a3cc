// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/tiled_surface.h"

#include <algorithm>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/radial_order.h"

namespace quoin {

namespace {

Sign first_sign(const RationalPoint3& v) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (v[axis].sign() != Sign::zero) return v[axis].sign();
  }
  return Sign::zero;
}

std::uint32_t next_in_tile(std::uint32_t halfedge) {
  return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1;
}

}  // namespace

TiledSurface::TiledSurface(const Leaf& leaf) : points_(leaf.vertices), exact_(leaf.exact_vertices), tiles_(leaf.tiles) {
  bool are_doubles = true;
  for (std::size_t v = 0; v < exact_.size() && are_doubles; ++v) are_doubles = exact_point(points_[v]) == exact_[v];
  if (are_doubles) exact_.clear();
  for (const Tile& t : tiles_)
    normals_.push_back(rounded_normal(rounded_vector(t[0], t[1]), rounded_vector(t[0], t[2])));
  const std::vector<std::uint32_t> twins = paired_halfedges(leaf);
  edge_of_.resize(twins.size());
  for (std::uint32_t h = 0; h < twins.size(); ++h) {
    if (twins[h] < h) continue;
    Edge edge{h, twins[h], tail(h), head(h), rounded_vector(tail(h), head(h)), 0};
    const bool is_flat = leaf.twins[h] != Leaf::no_twin && leaf.flat[h] != 0;
    if (!is_flat) {
      const Sign side = side_of_apex(edge);
      edge.sign = side != Sign::zero ? -to_int(side) : folds_back(edge) ? 1 : 0;
    }
    edge_of_[h] = edge_of_[twins[h]] = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(edge);
  }
  count_fans();
}

Vector3 TiledSurface::rounded_vector(std::uint32_t from, std::uint32_t to) const {
  if (exact_.empty()) return rounded(EdgeVector{points_[from], points_[to]});
  const RationalPoint3 v = exact_[to] - exact_[from];
  return rounded(edge_vector(v));
}

/// Of edges with more than two tiles, each that runs from the smaller to the larger end with the one that comes first
/// through the material from there on.
std::vector<std::uint32_t> TiledSurface::paired_halfedges(const Leaf& leaf) const {
  std::vector<std::uint32_t> twins = leaf.twins;
  std::vector<std::uint32_t> open;
  for (std::uint32_t h = 0; h < twins.size(); ++h) {
    if (twins[h] == Leaf::no_twin) open.push_back(h);
  }
  if (open.empty()) return twins;
  const Constructions points = exact_.empty() ? Constructions(points_) : Constructions(exact_);
  const auto ends = [&](std::uint32_t h) { return std::pair(std::min(tail(h), head(h)), std::max(tail(h), head(h))); };
  std::sort(open.begin(), open.end(),
            [&](std::uint32_t g, std::uint32_t h) { return std::pair(ends(g), g) < std::pair(ends(h), h); });
  for (std::size_t first = 0; first < open.size();) {
    std::size_t end = first + 1;
    while (end < open.size() && ends(open[end]) == ends(open[first])) ++end;
    pair_about_edge(points, std::span(open).subspan(first, end - first), twins);
    first = end;
  }
  return twins;
}

/// Seen from the head of the edge, material lies clockwise of a tile that runs along it forward.
void TiledSurface::pair_about_edge(const Constructions& points, std::span<std::uint32_t> around,
                                   std::vector<std::uint32_t>& twins) const {
  const std::uint32_t from = std::min(tail(around[0]), head(around[0]));
  const std::uint32_t to = std::max(tail(around[0]), head(around[0]));
  const PointId p{std::size_t{from}};
  const PointId q{std::size_t{to}};
  const auto apex = [&](std::uint32_t h) { return PointId{std::size_t{head(next_in_tile(h))}}; };
  const PointId reference = apex(around[0]);
  std::ranges::sort(around, [&](std::uint32_t g, std::uint32_t h) {
    const Sign order = compare_radially(points, p, q, reference, apex(g), apex(h));
    return order != Sign::zero ? order == Sign::negative : g < h;
  });
  std::vector<std::uint32_t> waiting;  // backward, for the forward one that follows counterclockwise
  for (std::size_t i = 0; i < 2 * around.size(); ++i) {
    const std::uint32_t h = around[i % around.size()];
    if (twins[h] != Leaf::no_twin) continue;
    if (tail(h) != from) {
      if (i < around.size()) waiting.push_back(h);
    } else if (!waiting.empty()) {
      twins[h] = waiting.back();
      twins[waiting.back()] = h;
      waiting.pop_back();
    }
  }
  for (const std::uint32_t h : around) {
    if (twins[h] == Leaf::no_twin) throw InternalError("the surface of a solid is not closed");
  }
}

/// The side of the left tile's plane on which the apex of the right one lies.
Sign TiledSurface::side_of_apex(const Edge& edge) const {
  const Tile& t = tiles_[tile_of(edge.halfedge)];
  const std::uint32_t apex = head(next_in_tile(edge.twin));
  return side(normals_[tile_of(edge.halfedge)], rounded_vector(t[0], apex), [&] {
    if (exact_.empty())
      return exact_determinant({points_[t[0]], points_[t[1]]}, {points_[t[0]], points_[t[2]]},
                               {points_[t[0]], points_[apex]});
    return dot(cross(exact_[t[1]] - exact_[t[0]], exact_[t[2]] - exact_[t[0]]), exact_[apex] - exact_[t[0]]).sign();
  });
}

/// Of coplanar tiles: whether their normals are opposite, as both lie on one side of the edge.
bool TiledSurface::folds_back(const Edge& edge) const {
  const RationalPoint3 from = exact(edge.tail);
  const RationalPoint3 along = exact(edge.head) - from;
  const Sign left = first_sign(cross(along, exact(head(next_in_tile(edge.halfedge))) - from));
  const Sign right = first_sign(cross(along, exact(head(next_in_tile(edge.twin))) - from));
  return left == right;
}

/// Corners of tiles at one vertex belong to one fan if edges there pair them.
void TiledSurface::count_fans() {
  DisjointSets corners(3 * tiles_.size());
  for (const Edge& e : edges_) {
    corners.unite(e.halfedge, next_in_tile(e.twin));
    corners.unite(next_in_tile(e.halfedge), e.twin);
  }
  fan_counts_.assign(points_.size(), 0);
  for (std::uint32_t c = 0; c < 3 * tiles_.size(); ++c) {
    if (corners.find(c) == c) ++fan_counts_[tail(c)];
  }
}

}  // namespace quoin
