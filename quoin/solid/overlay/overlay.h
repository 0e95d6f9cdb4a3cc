// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/expression.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Boundary of the set that the expression makes of the leaves, by one overlay of all their tiles.
///
/// Leaf i of the expression is the set of positive winding number of leaves[i]. Exact; O((n + k) log n) for n tiles and
/// k intersections on bounded local complexity. Sources: the overlay follows engineering practice of "mesh
/// arrangements" (Zhou et al. 2016, Levy 2024), but subdivides facets as planar graphs and names every constructed
/// point by at most three input planes; see the room's README.
Brep overlay_boundary(std::span<const std::shared_ptr<const Leaf>> leaves, const Expression& expression,
                      const Context& context);

}  // namespace quoin
