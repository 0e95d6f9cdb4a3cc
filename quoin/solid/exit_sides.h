// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Whether triangles of a boundary over moved vertices, which do not cross, have material where the boundary has it.
///
/// They have not where a shell is turned inside out, as a tetrahedron whose apex moves through its base, or comes to
/// lie in material that it was outside of. O(n) where the signs of the shells' volumes show in doubles and their boxes
/// are disjoint; else winding numbers decide, exactly, in O(n log n).
bool are_sides_kept(const Brep& boundary, const std::vector<Point3>& positions, std::span<const Tile> triangles,
                    std::span<const std::uint32_t> triangle_face, const Context& context);

/// The first and cheap part of that: true only where the signs of the shells' volumes, and boxes that are apart, show
/// it. O(n).
bool are_sides_evident(const Brep& boundary, const std::vector<Point3>& positions, std::span<const Tile> triangles,
                       std::span<const std::uint32_t> triangle_face, const Context& context);

}  // namespace quoin
