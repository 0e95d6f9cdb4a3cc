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
/// zero; every edge used as often in one direction as in the other; Euler-Poincare for manifolds (an even number that
/// leaves a genus). Returns one sentence per violation, at most `max_listed`. O(n log n) rational operations. Crossings
/// of faces are the business of find_crossings on a triangulation.
std::vector<std::string> check_boundary(const Brep& boundary, std::size_t max_listed, const Context& context);

}  // namespace quoin
