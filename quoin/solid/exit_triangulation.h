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

/// Triangulates each face in the projection along the largest component of its exact normal. Parallel over faces.
FaceTriangles triangulate_faces(const Brep& boundary, std::span<const Point3> positions, const Context& context);

}  // namespace quoin
