// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/edge_predicates.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// The boundary of a solid as oriented triangles that are paired along their edges, as its convolution with another
/// needs it. Where more than two tiles meet in an edge, those are paired that have material between them.
///
/// The Gaussian image of an edge is the shorter arc between the normals of its two tiles. It counts 1 where the edge is
/// convex, -1 where it is reflex.
class TiledSurface {
 public:
  /// Undirected; the halfedge 3 t + k runs from corner k of tile t to the next.
  struct Edge {
    std::uint32_t halfedge;  ///< from tail to head, on the left side
    std::uint32_t twin;      ///< back, on the right side
    std::uint32_t tail;
    std::uint32_t head;
    Vector3 vector;  ///< from tail to head, as `rounded` (edge_predicates.h) does
    int sign;        ///< 1 convex (or folded back), -1 reflex, 0 flat
  };

  /// Of a closed surface. The leaf is not kept. O(n log n).
  explicit TiledSurface(const Leaf& leaf);

  bool has_doubles() const { return exact_.empty(); }
  std::size_t point_count() const { return points_.size(); }
  /// Nearest doubles; the points themselves where has_doubles().
  const Point3& point(std::uint32_t v) const { return points_[v]; }
  RationalPoint3 exact(std::uint32_t v) const { return exact_.empty() ? exact_point(points_[v]) : exact_[v]; }

  std::span<const Tile> tiles() const { return tiles_; }
  const RoundedNormal& normal(std::uint32_t tile) const { return normals_[tile]; }
  std::span<const Edge> edges() const { return edges_; }
  /// The edge of a halfedge.
  std::uint32_t edge_of(std::uint32_t halfedge) const { return edge_of_[halfedge]; }
  std::uint32_t twin(std::uint32_t halfedge) const {
    const Edge& e = edges_[edge_of_[halfedge]];
    return e.halfedge == halfedge ? e.twin : e.halfedge;
  }
  static std::uint32_t tile_of(std::uint32_t halfedge) { return halfedge / 3; }
  std::uint32_t tail(std::uint32_t halfedge) const { return tiles_[halfedge / 3][halfedge % 3]; }
  std::uint32_t head(std::uint32_t halfedge) const { return tiles_[halfedge / 3][(halfedge % 3 + 1) % 3]; }
  /// By vertex, how many cycles of tiles meet in it.
  std::span<const std::uint32_t> fan_counts() const { return fan_counts_; }

 private:
  Vector3 rounded_vector(std::uint32_t from, std::uint32_t to) const;
  std::vector<std::uint32_t> paired_halfedges(const Leaf& leaf) const;
  void pair_about_edge(const Constructions& points, std::span<std::uint32_t> around,
                       std::vector<std::uint32_t>& twins) const;
  Sign side_of_apex(const Edge& edge) const;
  bool folds_back(const Edge& edge) const;
  void count_fans();

  std::vector<Point3> points_;
  std::vector<RationalPoint3> exact_;
  std::vector<Tile> tiles_;
  std::vector<RoundedNormal> normals_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> edge_of_;
  std::vector<std::uint32_t> fan_counts_;
};

}  // namespace quoin
