// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// The Minkowski sum of two polytopes, by indices: vertex i is the sum of vertices[i][0] of the first and
/// vertices[i][1] of the second, and of no other two.
struct PolytopeSum {
  std::vector<std::array<std::uint32_t, 2>> vertices;
  std::vector<std::uint32_t> corners;       ///< of all facets, counterclockwise seen from outside
  std::vector<std::size_t> facet_begin{0};  ///< facet_count() + 1 offsets into corners
  bool has_ties = false;  ///< some facets, edges or both of the two are parallel, so that facets were joined

  std::size_t facet_count() const { return facet_begin.size() - 1; }
  std::size_t edge_count() const { return corners.size() / 2; }
  std::span<const std::uint32_t> facet(std::size_t f) const {
    return {corners.data() + facet_begin[f], facet_begin[f + 1] - facet_begin[f]};
  }
};

/// Exact, in any position: parallel facets and edges, equal and homothetic polytopes are ordinary. One of the two may
/// be flat. Facets are maximal, no corner lies on the line through its neighbours.
///
/// The Gaussian map of the sum is the overlay of those of the two: its facets are facets of either, placed at the
/// vertex of the other that is extreme in that direction, and parallelograms of two edges whose arcs cross. The maps
/// are overlaid by walks along arcs (map_overlay.h). Where signs are zero, the second map is turned by an infinitesimal
/// rotation, and what that pulled apart is joined again. O(size of both and of the sum), with the degrees of the
/// second's vertices. Source: Fogel and Halperin 2007; Guibas and Seidel 1987 (linear overlay of convex subdivisions).
/// @throws InputError if both are flat, Cancelled
PolytopeSum minkowski_sum(const Polytope& p, const Polytope& q, const Context& context);

/// The sums of the vertices' coordinates.
std::vector<RationalPoint3> exact_vertices(const PolytopeSum& sum, const Polytope& p, const Polytope& q);

}  // namespace quoin
