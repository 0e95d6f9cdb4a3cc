// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/assembly/region_direction.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// Where the origin lies with respect to a convex polytope.
enum class OriginPlace : std::uint8_t { inside, facet, edge, vertex, separated };

/// An open, convex set of directions: those with a positive scalar product with each of some normals. At least a
/// hemisphere is missing from it.
struct ConvexRegion {
  /// Inward. Arc i of the boundary runs counterclockwise about normal i, the region on its left.
  std::vector<RegionDirection> normals;
  /// Arc i runs from corner i to the next one; without corners it is a whole great circle. Two corners are
  /// opposite to one another, and the region is a lune; with more, arcs are shorter than half a circle.
  std::vector<RegionDirection> corners;

  bool contains(const RegionDirection& direction) const;
  friend bool operator==(const ConvexRegion&, const ConvexRegion&) = default;
};

/// The directions in which rays from the origin enter the interior of a polytope.
struct Projection {
  OriginPlace place = OriginPlace::separated;
  ConvexRegion region;  ///< nothing where the origin is inside: the rays in all directions start there
};

/// The central projection of the sum of two polytopes, exact.
///
/// With s the side of each facet's plane on which the origin lies: where no facet is seen from outside, the region is
/// what is in front of the facets whose planes contain the origin, a hemisphere, a lune or the inside of the cone at a
/// vertex. Else its boundary is the silhouette, the edges between facets that are seen and others; of edges that one
/// plane through the origin holds, there is one arc. O(size log size) for the size of the sum.
/// Source: Fogel 2009, section 5.3.5, which leaves out edges and vertices.
Projection project(const PolytopeSum& sum, const Polytope& p, const Polytope& q);

}  // namespace quoin
