// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/polytope/cubical_map.h"

/// How the squares of a cubical map hold together.
namespace quoin::cube {

/// Links the vertices on sides and at corners, and tells all vertices at a normal that they are real. Source: table 3.1
/// of Fogel 2009 for the corners; sides are walked on both squares at once. O(vertices on sides).
void link_squares(CubicalMap& map);

/// Labels the squares that no arc meets: each has one face, of the vertex whose face is on the other side of any of its
/// sides. Some arc meets some square. @throws InternalError  a bounded face stays without a label
void spread_labels(CubicalMap& map);

/// Labels all bounded faces of a map without arcs, which is that of a point.
void label_with_the_only_vertex(CubicalMap& map);

/// The halfedges that leave a vertex with a bounded face on their left, counterclockwise: all around an interior one,
/// on the border from the side that has the square on its left.
std::vector<dcel::HalfedgeId> fan(const CubicalMap::Square& square, dcel::VertexId v);

}  // namespace quoin::cube
