// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/solid/box_tree.h"

namespace quoin {

/// All pairs of triangles, of which at least one has moved, that meet outside their shared vertices and edges,
/// ascending.
///
/// Two vertices on one spot, a triangle without area and two triangles with the same corners count as crossings.
/// `moved` is per vertex. Exact; the pairs in which nothing moved are taken to be apart. O(n log n + pairs).
std::vector<TilePair> find_crossings(std::span<const Point3> vertices, std::span<const Tile> triangles,
                                     std::span<const std::uint8_t> moved, const Context& context);

}  // namespace quoin
