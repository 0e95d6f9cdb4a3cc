// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/assembly/projection.h"
#include "quoin/base/context.h"

namespace quoin {

/// The union of open convex regions as a set of points that is not regularized, by one sweep over all boundaries. On a
/// boundary a region does not count, whatever it does on both sides. @throws Cancelled
GeodesicPolygonSet sweep_union(std::span<const ConvexRegion> regions, const Context& context);

}  // namespace quoin
