// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/exit.h"

namespace quoin {

/// The faces of a boundary that may stand as polygons over moved vertices, as `FacePolygons` says. `triangles` are
/// those of the faces, ascending, `moved` is per vertex. Exact. O(n).
FacePolygons find_polygons(const Brep& boundary, std::span<const Point3> positions, std::span<const std::uint8_t> moved,
                           std::span<const Tile> triangles, std::span<const std::uint32_t> triangle_face,
                           const Context& context);

}  // namespace quoin
