// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/alpha_complex.h"

namespace quoin {

/// Pairs of vertices of an alpha complex without weights, which are those of its triangulation: the smaller one first,
/// ascending.
using VertexPairs = std::vector<std::array<std::uint32_t, 2>>;

/// Graphs of distinct points of the plane or of space, each part of the next one's edges, and all of the edges of every
/// Delaunay triangulation, so that nothing depends on the choice of diagonals. Exact.
///
/// Minimum spanning tree: of all trees that of least length where edges are compared by their squares, equal ones by
/// their vertices: the edges in this order, without those that close a cycle. O(n log n) for n edges of the complex.
/// @throws InputError with weights; Cancelled
VertexPairs minimum_spanning_tree(const AlphaComplex& alpha, const Context& context);

/// Relative neighbours: pairs without a third point that is nearer to both than they are to each other. For each
/// Gabriel edge a search among vertices near its middle: O(n) for points that are spread evenly, O(n^2) at worst.
/// @throws InputError with weights; Cancelled
/// Source: Toussaint 1980.
VertexPairs relative_neighbours(const AlphaComplex& alpha, const Context& context);

/// Gabriel edges: pairs without a third point in the ball of which they are a diameter, nor on its boundary. O(n)
/// @throws InputError with weights
/// Source: Gabriel and Sokal 1969.
VertexPairs gabriel_edges(const AlphaComplex& alpha);

}  // namespace quoin
