// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/edge_predicates.h"
#include "quoin/polytope/hull.h"

namespace quoin {

/// A convex polytope of dimension 3, or a flat one of dimension 2 with two facets back to back, as vertices, facets and
/// halfedges. A halfedge runs from its tail to its head with its facet on the left, seen from outside.
///
/// Its Gaussian map is the same record read in another way: a facet is a point of the sphere (its outward normal), a
/// vertex the region of directions in which it is extreme, and a halfedge the arc from the normal of its facet to that
/// of its twin's, with the region of its head on the left and that of its tail on the right.
class Polytope {
 public:
  struct Halfedge {
    Vector3 vector;  ///< rounded
    std::uint32_t tail;
    std::uint32_t head;
    std::uint32_t twin;
    std::uint32_t facet;
    std::uint32_t next;  ///< in the facet
  };

  /// The hull of the points, which is of dimension 2 or 3. @throws InputError, Cancelled
  static Polytope hull_of(std::span<const Point3> points, const Context& context);

  int dimension() const { return dimension_; }
  std::size_t vertex_count() const { return vertices_.size(); }
  std::size_t facet_count() const { return normals_.size(); }
  std::size_t edge_count() const { return halfedges_.size() / 2; }
  const Point3& vertex(std::uint32_t v) const { return vertices_[v]; }
  /// Index of a vertex among the points given.
  std::uint32_t source(std::uint32_t v) const { return sources_[v]; }
  std::span<const Halfedge> halfedges() const { return halfedges_; }
  /// Numbers of the halfedges that leave a vertex are consecutive, counterclockwise.
  std::uint32_t first_out(std::uint32_t v) const { return first_out_[v]; }
  std::uint32_t end_out(std::uint32_t v) const { return first_out_[v + 1]; }
  const RoundedNormal& normal(std::uint32_t f) const { return normals_[f]; }
  /// Exact.
  EdgeVector edge(std::uint32_t halfedge) const {
    return {vertices_[halfedges_[halfedge].tail], vertices_[halfedges_[halfedge].head]};
  }
  std::uint32_t first_halfedge(std::uint32_t f) const { return facet_halfedge_[f]; }

 private:
  void link(const ConvexHull& hull, std::span<const std::uint32_t> place);

  int dimension_ = 3;
  std::vector<Point3> vertices_;
  std::vector<std::uint32_t> sources_;
  std::vector<Halfedge> halfedges_;
  std::vector<std::uint32_t> first_out_;
  std::vector<RoundedNormal> normals_;  // of an edge of each facet and the next
  std::vector<std::uint32_t> facet_halfedge_;
};

}  // namespace quoin
