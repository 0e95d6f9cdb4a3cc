// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
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

/// Whether a cell belongs to a set, by its winding number and, where it is called for, a point strictly inside it. The
/// point is binary fractions with few digits where the room in the cell lets it be; it costs more than the number.
using CellMembership = std::function<bool(int winding, const std::function<RationalPoint3()>& point)>;

/// Boundary of the union of those cells of one leaf's tiles that `is_inside` accepts. It is asked once for each cell,
/// also for the unbounded one, which must not be accepted, and more than once where no edges connect parts of a cell's
/// boundary. Exact, complexity as overlay_boundary.
Brep winding_boundary(const std::shared_ptr<const Leaf>& leaf, const CellMembership& is_inside, const Context& context);

}  // namespace quoin
