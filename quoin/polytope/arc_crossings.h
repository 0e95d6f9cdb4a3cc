// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/surface_signs.h"

namespace quoin {

/// Two edges whose arcs on the sphere of normals cross.
struct ArcCrossing {
  std::uint32_t a;  ///< edge of the fixed surface
  std::uint32_t b;  ///< edge of the turned surface
  /// Along the arc of a, from the left tile's normal to the right one's, normals come to point along b (1) or against
  /// it (-1). Times the sign of edge b, it is the change at the head of b; at its tail it is the opposite. Of the arc
  /// of b and the edge a, it is minus that times both signs.
  int along_a;
};

/// All of them, ascending by a, then b. Exact. O(edges of a times edges of b), at a nanosecond or two for each pair of
/// arcs that are far from each other; on all threads.
std::vector<ArcCrossing> arc_crossings(const TiledSurface& a, const TiledSurface& b, const SurfaceSigns& signs,
                                       const Context& context);

}  // namespace quoin
