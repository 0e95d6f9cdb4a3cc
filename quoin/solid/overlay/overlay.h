// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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

/// What a cell is to a set that winds: in it, a hole of it, or the outside of everything.
enum class CellVerdict : std::uint8_t { inside, hole, outside };

/// Asked about one point strictly inside a cell of winding number zero. The point is binary fractions with few digits
/// where the room in the cell lets it be.
using CellQuestion = std::function<CellVerdict(const RationalPoint3&)>;

/// Boundary of the cells of one leaf's tiles that are of the kind, which is not `outside`, in a set of which two things
/// are known: points about which the leaf winds are in it, and wherever its boundary is, a tile lies whose normal
/// points out of it. What that leaves open is asked, once for each such cell
/// as far as edges connect its boundary. Exact, complexity as
/// overlay_boundary, and O(tiles log tiles) for each question.
Brep winding_boundary(const std::shared_ptr<const Leaf>& leaf, CellVerdict kind, const CellQuestion& question,
                      const Context& context);

}  // namespace quoin
