// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/polytope.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// The pieces of a bounded solid in the order of their shells, if each is convex and all vertices are points of
/// doubles; nothing else. Pieces that share an edge count as not convex, those that touch in another way are told
/// apart. Exact, O(n log n). @throws Cancelled
std::optional<std::vector<Polytope>> convex_pieces(const Brep& boundary, const Context& context);

/// The hull of a boundary's vertices. Exact, O(n log n).
Polytope hull_of_boundary(const Brep& boundary, const Context& context);

}  // namespace quoin
