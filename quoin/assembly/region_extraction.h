// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/assembly/blocked_region.h"

namespace quoin {

/// An open set of directions as a record of its boundary: arcs that only the identification or a pole cuts are joined,
/// so that the record does not know where these are. O(n log n).
BlockedRegion extract_region(const GeodesicPolygonSet& set);

/// Puts vertices and arcs in order.
void sort_region(BlockedRegion& region);

}  // namespace quoin
