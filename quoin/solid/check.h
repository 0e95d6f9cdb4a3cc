// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Verifies a boundary by exact rational arithmetic, without the code that makes boundaries.
///
/// Looks at: indices; every vertex of a face on its plane; the outward normal along the area vector; no edge of length
/// zero (a loop of two vertices is a slit, a loop of one a vertex that touches); every edge used as often in one
/// direction as in the other; Euler-Poincare for manifolds (an even number that leaves a genus); and where all that
/// holds, at what boundary_crossings.h lists: crossings, sides, nesting of shells. Returns one sentence per violation,
/// at most `max_listed`. O(n log n) rational operations, and more where boxes of faces overlap.
std::vector<std::string> check_boundary(const Brep& boundary, std::size_t max_listed, const Context& context);

}  // namespace quoin
