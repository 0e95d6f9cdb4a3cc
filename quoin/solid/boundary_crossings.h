// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// What is wrong with how the elements of a boundary lie to each other, one sentence each, at most `max_listed`.
///
/// Looks for: a vertex inside an edge it does not end; two edges that cross; an edge that pierces a face or runs inside
/// one it does not bound; an edge that a face passes in both directions beside its area; faces that lie on one another;
/// faces whose outward side is inside the solid; shells whose declaration as outer or void is not what surrounds them;
/// a wrong number of components; a vertex that touches a face from one side where the face does not name it, or the
/// other way round. Exact. Indices must be valid and faces planar. O(n log n + c), c the corners of faces whose boxes
/// meet.
std::vector<std::string> find_boundary_crossings(const Brep& boundary, std::size_t max_listed, const Context& context);

}  // namespace quoin
