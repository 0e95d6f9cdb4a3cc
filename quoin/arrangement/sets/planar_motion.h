// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// The set moved by a vector, exact: coordinates that are no doubles are kept as rationals. Any set, unbounded ones and
/// such with lone edges and points too. O(n log n). @throws Cancelled
LinearPolygonSet translated(const LinearPolygonSet& set, const RationalPoint2& vector, const Context& context);

/// All -p for p in the set, likewise.
LinearPolygonSet reflected(const LinearPolygonSet& set, const Context& context);

/// All c - p for p in the set, likewise: where a body that is reflected lies.
LinearPolygonSet reflected(const LinearPolygonSet& set, const RationalPoint2& c, const Context& context);

}  // namespace quoin
