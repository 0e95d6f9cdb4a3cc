// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/hull.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// The boundary of a polytope of dimension 3 as that of a solid: facets as faces, each its own origin in a leaf of the
/// given name. The facets are maximal, strictly convex polygons, counterclockwise seen from outside, over all vertices.
/// O(n).
Brep convex_boundary(const std::vector<RationalPoint3>& vertices, std::span<const std::uint32_t> corners,
                     std::span<const std::size_t> facet_begin, const std::string& name);
/// Of a hull of dimension 3.
Brep convex_boundary(const ConvexHull& hull, std::span<const Point3> points, const std::string& name);
Brep convex_boundary(const ConvexHull& hull, std::span<const RationalPoint3> points, const std::string& name);

}  // namespace quoin
