// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/arrangement/geodesic/sphere_direction.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// The arc of an edge in a Gaussian map: from the normal of one of its facets to that of the other, counterclockwise
/// about the edge.
struct MapArc {
  std::uint32_t source;  ///< facet; none of a segment, whose arc is a great circle
  std::uint32_t target;  ///< facet
  std::uint32_t head;    ///< vertex in whose directions the arc's left side lies
  std::uint32_t tail;    ///< and that of its right side: the edge runs from here to the head
};

/// What a Gaussian map is made of, on whatever surface it is drawn.
struct MapArcs {
  std::vector<SphereDirection> normals;  ///< outward, by facet
  std::vector<MapArc> arcs;              ///< one for each edge
  std::vector<SphereDirection> edges;    ///< from tail to head, by arc
  std::size_t vertex_count = 0;
};

/// Exact. O(n).
MapArcs map_arcs(const Polytope& p);

/// Of a sum of p and q; its vertices and facets as the sum numbers them. Exact. O(n log n).
/// @throws InputError  the sum is flat
MapArcs map_arcs(const PolytopeSum& sum, const Polytope& p, const Polytope& q);

}  // namespace quoin
