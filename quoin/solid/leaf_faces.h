// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/solid/brep.h"
#include "quoin/solid/leaf_tiles.h"

namespace quoin {

/// The exact value of every point of a table.
std::vector<RationalPoint3> exact_points(const Constructions& points, const Context& context);

/// Cuts the faces of a boundary into triangles over the first of equal points, turned over where the set is unbounded.
///
/// Edges that a face passes in both directions are left out; several loops, also such that touch in vertices, are one
/// polygon. Notes faces without a plane or with a vertex off it as not planar, those whose loops bound no polygon as
/// not simple; neither gives tiles. `points` holds the exact points of the boundary, all explicit.
MeshTiles make_tiles(const Brep& boundary, const Constructions& points, std::size_t max_listed,
                     MeshDiagnosis& diagnosis, const Context& context);

}  // namespace quoin
