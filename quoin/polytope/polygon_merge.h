// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/polytope/edge_predicates.h"
#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// A convex polygon in some plane of space by its vertices in order, each with the edge to the next. A segment has two,
/// there and back; a vertex alone has no edge.
struct ConvexRing {
  std::vector<std::uint32_t> vertices;
  std::vector<EdgeVector> edges;  ///< as many, or none

  static ConvexRing of_vertex(std::uint32_t v) { return {{v}, {}}; }
  /// Counterclockwise seen from outside. Valid as long as the shape.
  static ConvexRing of_facet(const PolytopeShape& shape, std::uint32_t facet);
  static ConvexRing of_edge(const PolytopeShape& shape, std::uint32_t halfedge);
};

/// A plane of directions, projected along an axis without loss, so that what turns left about its normal a x b turns
/// left there.
class DirectionPlane {
 public:
  DirectionPlane(const EdgeVector& a, const EdgeVector& b);
  /// Whether the normal's first component that is not zero is positive.
  bool faces_up() const { return sign_ == Sign::positive; }
  Sign turn(const EdgeVector& a, const EdgeVector& b) const { return sign_ * cross_sign(a, b, axis_); }
  /// Of an angle from 0 up to half a turn, without this.
  bool is_in_first_half(const EdgeVector& v) const;

 private:
  unsigned axis_ = 0;  // the first that the normal is not perpendicular to
  Sign sign_ = Sign::positive;
};

/// The sum of two rings that run counterclockwise in the plane: their edges in one order by direction, parallel ones
/// joined. O(sizes), exact.
std::vector<std::array<std::uint32_t, 2>> merge_rings(const ConvexRing& p, const ConvexRing& q,
                                                      const DirectionPlane& plane);

}  // namespace quoin
