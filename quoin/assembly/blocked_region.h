// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/geodesic/sphere_direction.h"
#include "quoin/assembly/projection.h"
#include "quoin/base/context.h"

namespace quoin {

/// The directions in which one part moving to infinity would meet another: an open set of directions, as its boundary.
///
/// In the one simplest form, so that equal sets are equal records: arcs are as long as they can be, nothing lies inside
/// the set, and arcs and vertices are sorted. Slits and points without area stay: the set is not regularized.
struct BlockedRegion {
  struct Vertex {
    SphereDirection at;  ///< primitive
    bool is_blocked = false;
  };
  /// From source to target counterclockwise about the normal; a whole circle has neither. The left side is blocked; a
  /// slit, which has both sides blocked and itself not, turns about the normal whose first component is positive.
  struct Arc {
    static constexpr std::uint32_t no_vertex = 0xFFFFFFFFU;
    SphereDirection normal;  ///< primitive
    std::uint32_t source = no_vertex;
    std::uint32_t target = no_vertex;
    bool is_slit = false;
  };

  std::vector<Vertex> vertices;
  std::vector<Arc> arcs;
  bool blocks_elsewhere = false;  ///< what holds where there is no arc: without any, everywhere but at the vertices

  friend std::strong_ordering operator<=>(const BlockedRegion& a, const BlockedRegion& b);
  friend bool operator==(const BlockedRegion& a, const BlockedRegion& b) { return (a <=> b) == 0; }
};

/// The union of open convex regions, not regularized: where they only touch, the common edge or vertex is free.
///
/// One sweep over the boundaries of those that no other one contains, then what is inside goes. A single region is its
/// own union, and costs no sweep. O((n + k) log n) for n arcs and k crossings, and O(m^2) for containment of m regions.
/// @throws Cancelled
BlockedRegion unite(std::span<const ConvexRegion> regions, const Context& context);

/// All directions reversed: what the other part meets when it moves.
BlockedRegion reflected(const BlockedRegion& region);

}  // namespace quoin
