// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/context.h"
#include "quoin/polytope/map_arcs.h"

namespace quoin {

/// The Gaussian map of a polytope as an arrangement on the sphere, for pictures, checks and what works on arrangements.
///
/// A facet is the vertex in the direction of its outward normal, an edge the arc between the normals of its two facets,
/// a vertex the face of the directions in which it is extreme. Arcs that pass the identification (u = pi) are cut
/// there, by vertices of two edges that are no facets. That of a segment is a great circle, that of a point all of the
/// sphere.
struct GaussianMap {
  GeodesicArrangement arrangement;
  std::vector<std::uint32_t> vertex_of_face;  ///< by face: the vertex of the polytope
  std::vector<MapArc> arcs;                   ///< by curve of the arrangement
};

/// Exact. O(n log n). @throws Cancelled
GaussianMap gaussian_map(const Polytope& p, const Context& context);
/// Of what the arcs are of: a polytope, or a sum of two. @throws Cancelled
GaussianMap gaussian_map(const MapArcs& arcs, const Context& context);

/// The inverse: the polytope that a map is of, from its cells and the labels of its faces alone.
///
/// Its facets as rings of vertices (labels), counterclockwise seen from outside, in the order of the map's vertices;
/// vertices that cut an arc are skipped. Each ring may begin anywhere. O(n).
std::vector<std::vector<std::uint32_t>> facets_of_map(const GaussianMap& map);

}  // namespace quoin
