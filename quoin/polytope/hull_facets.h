// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

/// Joins coplanar triangles of a finished hull to facets, and drops what is no vertex then. `names`: what the points of
/// the builder are called in the result, less than `name_count`. The builder is of no use then. O(n),
/// exact.
ConvexHull join_facets(HullBuilder& builder, std::span<const std::uint32_t> names, std::size_t name_count,
                       const Context& context);

/// Of points in one plane, with one facet. O(n log n).
ConvexHull hull_of_polygon(std::span<const std::uint32_t> corners);

/// Of points of the plane, whose facets are edges: from all its corners in order. O(n log n).
ConvexHull hull_in_plane(std::span<const std::uint32_t> corners);

}  // namespace quoin
