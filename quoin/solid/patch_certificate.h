// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Parts of a leaf whose tiles meet each other in nothing but shared vertices and edges, without a test of any pair.
struct Patches {
  std::vector<std::uint8_t> is_patch;  ///< per node of the leaf's tree: its tiles form a patch
  std::vector<std::uint8_t> is_seam;   ///< per vertex: on the rim of a patch, or of a tile in no patch
};

/// Finds the largest subtrees of the leaf's tree, of 64 to 65536 tiles, that are graphs over a coordinate plane.
///
/// Seen along an axis, all tiles of a patch turn the same way, and the halfedges whose twin is not in it, its rim,
/// form simple loops whose boxes are apart. The number of tiles over a point off the rim is the sum of the loops'
/// winding numbers about it, hence 0 or 1: no two tiles overlap. Nor do they touch except where they share: around a
/// vertex or edge that is not on the rim every point is covered once already, and the rim does not touch itself.
///
/// Signs are exact; where a rim costs too much to test, the subtree is no patch. So the patches decide which pairs are
/// tested, never a result. O(n log n).
Patches find_patches(const Leaf& leaf, const Constructions& points, const Context& context);

}  // namespace quoin
