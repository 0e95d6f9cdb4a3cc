// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// The sum where an operand is a point or a segment, or both are flat: see minkowski_sum.h.
///
/// A point moves the other. To a solid a segment adds a belt of parallelograms along the edges between facets that look
/// with it and facets that look against it. Polygons in one plane add their edges in one order by direction. A polygon
/// and what leaves its plane have, besides their own facets, one parallelogram for each two edges e, e' with normals
/// n, n' of their planes for which n.e' and n'.e have opposite signs: there e x e' or its negative points out of both.
/// O(size of the result).
PolytopeSum flat_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context);

}  // namespace quoin
