// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/base/context.h"
#include "quoin/solid/mesh.h"
#include "quoin/topology/simplex_list.h"

namespace quoin {

/// A mesh as simplices of dimension 2 and below.
struct MeshComplex {
  SimplexList simplices;            ///< corners have the numbers of vertices of the mesh, others are new
  std::size_t lonely_vertices = 0;  ///< corners of no face: left out, unless there are no faces: then points
  std::size_t repeated_faces = 0;   ///< with the corners of an earlier one, in either order around: left out
  std::size_t thin_faces = 0;  ///< with fewer than three corners once equal neighbours are one: an edge, or a vertex
};

/// Faces are disks, joined where they have corners in common; coordinates do not matter. Equal corners that follow one
/// another are one. A triangle is a simplex; any other face is the cone of a new vertex over its sides, or, if a corner
/// comes twice, a ring of new vertices and a cone over these. O(n log n) for n corners. @throws Cancelled
MeshComplex complex_of_mesh(const Mesh& mesh, const Context& context);

}  // namespace quoin
