// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// One round of snap rounding: the vertices of crossing triangles, and all others in their cells, go to the centres of
/// cells of a uniform grid, 2^bits of which reach from zero to the largest coordinate. Gives the largest move of a
/// coordinate.
double snap_crossing(std::vector<Point3>& points, std::span<const Tile> triangles, std::span<const TilePair> crossings,
                     int bits);

/// The points of positive winding number of triangles that may cross each other; for an unbounded set, whose triangles
/// wind about what it leaves out, the complement of those of the reversed triangles. The faces stem from triangles.
/// Nothing where the triangles do not close.
std::optional<Brep> resolve(const std::vector<Point3>& points, std::span<const Tile> triangles, bool is_unbounded,
                            const Context& context);

}  // namespace quoin
