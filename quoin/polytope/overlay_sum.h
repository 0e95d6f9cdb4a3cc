// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// The sum of two polytopes of which one is solid and the other solid or a polygon, by the overlay of their Gaussian
/// maps: see minkowski_sum.h.
PolytopeSum overlay_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context);

}  // namespace quoin
