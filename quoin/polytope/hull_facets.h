// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

/// Joins coplanar triangles of a finished hull to facets, and drops what is no vertex then. `names`: what the points of
/// the builder are called in the result. O(n), exact.
ConvexHull join_facets(const HullBuilder& builder, std::span<const std::uint32_t> names, const Context& context);

/// Every facet from its smallest corner on, facets in lexicographic order, and the vertices. `name_count`: names are
/// smaller. O(n) where few facets begin at a vertex.
void put_in_order(ConvexHull& hull, std::size_t name_count);

}  // namespace quoin
