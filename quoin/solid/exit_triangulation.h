// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Triangles of all faces over given vertex positions (one per vertex id of the boundary).
struct FaceTriangles {
  std::vector<Tile> triangles;
  std::vector<std::uint32_t> triangle_face;  ///< ascending
  std::vector<std::uint32_t> failed_faces;  ///< outline not simple in these positions; such a face has a fan of each of
                                            ///< its loops, which closes the surface but may fold over
};

/// Triangulates each face in the projection along the largest component of its exact normal. `moved` is 0 for the
/// vertices whose position is where they are exactly. Parallel over faces.
FaceTriangles triangulate_faces(const Brep& boundary, std::span<const Point3> positions,
                                std::span<const std::uint8_t> moved, const Context& context);

/// Triangulates the faces (ascending) anew, in the exact positions of their vertices, and puts the triangles in place
/// of theirs; false, and nothing changed, where one of them bounds no polygon.
///
/// Vertices on one line before rounding then make no triangle, which after rounding might stand out of its face; but
/// triangles that have area before rounding may turn over. O(n log n) rational operations for n corners.
bool triangulate_exactly(const Brep& boundary, std::span<const std::uint32_t> faces, std::vector<Tile>& triangles,
                         std::vector<std::uint32_t>& triangle_face, const Context& context);

}  // namespace quoin
