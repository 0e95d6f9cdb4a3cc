// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// Convex solids with disjoint insides, after neighbours whose union is convex have been joined as long as there are
/// any, those with the largest common faces first (as far as doubles tell; what may be joined is decided exactly).
///
/// Two lie on either side of a plane that holds a face of each, and each lies within all other face planes of the
/// other: then their union is the intersection of all these half-spaces. O(pairs in common planes * their sizes).
/// Source: necessary and sufficient by the definition of convexity.
std::vector<Solid> join_convex(const std::vector<Solid>& solids, const Context& context);

}  // namespace quoin
