// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/polytope/edge_predicates.h"

namespace quoin {

/// All of a convex polytope but where it is: vertices, facets and halfedges by number, and the vectors of these. A
/// halfedge runs from its tail to its head with its facet on the left, seen from outside. Of dimension 2 there are two
/// facets back to back; a segment has two halfedges without facets, a point none.
///
/// Its Gaussian map is the same record read in another way: a facet is a point of the sphere (its outward normal), a
/// vertex the region of directions in which it is extreme, and a halfedge the arc from the normal of its facet to that
/// of its twin's, with the region of its head on the left and that of its tail on the right.
class PolytopeShape {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  struct Halfedge {
    Vector3 vector;  ///< rounded, as `rounded` (edge_predicates.h) does
    std::uint32_t tail;
    std::uint32_t head;
    std::uint32_t twin;
    std::uint32_t facet;  ///< none of a segment
    std::uint32_t next;   ///< in the facet
  };

  int dimension() const { return dimension_; }
  std::size_t vertex_count() const { return first_out_.size() - 1; }
  std::size_t facet_count() const { return normals_.size(); }
  std::size_t edge_count() const { return halfedges_.size() / 2; }
  std::span<const Halfedge> halfedges() const { return halfedges_; }
  /// Numbers of the halfedges that leave a vertex are consecutive, counterclockwise.
  std::uint32_t first_out(std::uint32_t v) const { return first_out_[v]; }
  std::uint32_t end_out(std::uint32_t v) const { return first_out_[v + 1]; }
  const RoundedNormal& normal(std::uint32_t f) const { return normals_[f]; }
  /// Exact, and valid as long as the shape. Of a sum, up to a positive factor.
  EdgeVector edge(std::uint32_t halfedge) const {
    if (!edges_.empty()) return edges_[halfedge];
    return {points_[halfedges_[halfedge].tail], points_[halfedges_[halfedge].head]};
  }
  std::uint32_t first_halfedge(std::uint32_t f) const { return facet_halfedge_[f]; }

 protected:
  /// Facets as rings of vertices, counterclockwise seen from outside.
  struct Rings {
    std::span<const std::uint32_t> corners;
    std::span<const std::size_t> facet_begin;
    std::size_t facet_count() const { return facet_begin.size() - 1; }
  };
  /// Facets and halfedges without their vectors; of dimension 2, from one ring.
  void link(int dimension, std::size_t vertex_count, const Rings& rings);
  /// From points or edges.
  void set_vectors();
  /// That of the reflection in the origin, points or edges included.
  void reflect();

  std::vector<Point3> points_;     // of the vertices, if they are doubles
  std::vector<EdgeVector> edges_;  // by halfedge, else

 private:
  void link_segment();
  void link_rings(std::size_t vertex_count, const Rings& rings);

  int dimension_ = 0;
  std::vector<Halfedge> halfedges_;
  std::vector<std::uint32_t> first_out_{0};
  std::vector<RoundedNormal> normals_;  // of an edge of each facet and the next
  std::vector<std::uint32_t> facet_halfedge_;
};

}  // namespace quoin
