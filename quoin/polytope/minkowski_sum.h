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

/// Facets of a polytope as rings of numbered vertices.
struct FacetRings {
  int dimension = 0;                        ///< from 0, a point, to 3
  std::vector<std::uint32_t> corners;       ///< of all facets, counterclockwise seen from outside
  std::vector<std::size_t> facet_begin{0};  ///< facet_count() + 1 offsets into corners

  /// Of dimension 2 there is one facet, the polygon, counterclockwise seen from where the first of x, y, z that its
  /// normal is not perpendicular to increases; of lower dimensions none.
  std::size_t facet_count() const { return facet_begin.size() - 1; }
  std::size_t edge_count() const {
    return dimension == 3 ? corners.size() / 2 : dimension == 2 ? corners.size() : dimension == 1 ? 1 : 0;
  }
  std::span<const std::uint32_t> facet(std::size_t f) const {
    return {corners.data() + facet_begin[f], facet_begin[f + 1] - facet_begin[f]};
  }
};

/// The Minkowski sum of two polytopes, by indices: vertex i is the sum of vertices[i][0] of the first and
/// vertices[i][1] of the second, and of no other two.
struct PolytopeSum : FacetRings {
  std::vector<std::array<std::uint32_t, 2>> vertices;
  bool has_ties = false;  ///< signs were zero on the way, as they are where facets or edges of the two are parallel

  std::size_t vertex_count() const { return vertices.size(); }
};

/// Exact, of operands of any dimension in any position: parallel facets and edges, equal and homothetic polytopes are
/// ordinary. Facets are maximal, no corner lies on the line through its neighbours.
///
/// The Gaussian map of the sum is the overlay of those of the two: its facets are facets of either, placed at the
/// vertex of the other that is extreme in that direction, and parallelograms of two edges whose arcs cross. The maps
/// are overlaid by walks along arcs (map_overlay.h). Where signs are zero, the second map is turned by an infinitesimal
/// rotation, and what that pulled apart is joined again. O(size of both and of the sum), with the degrees of the
/// second's vertices. Points, segments and pairs of polygons have simple maps and are summed directly (flat_sums.h).
/// Source: Fogel and Halperin 2007; Guibas and Seidel 1987 (linear overlay of convex subdivisions).
/// @throws Cancelled
PolytopeSum minkowski_sum(const PolytopeShape& p, const PolytopeShape& q, const Context& context);

/// The sums of the vertices' coordinates.
std::vector<RationalPoint3> exact_vertices(const PolytopeSum& sum, const Polytope& p, const Polytope& q);

/// The Minkowski sum of k polytopes: each of its vertices is the sum of one vertex of each, and of no others.
struct PolytopeSumOfMany : FacetRings {
  std::size_t summand_count = 0;
  std::vector<std::uint32_t> vertices;  ///< summand_count indices for each vertex

  std::size_t vertex_count() const { return summand_count == 0 ? 1 : vertices.size() / summand_count; }
  std::span<const std::uint32_t> vertex(std::size_t v) const {
    return {vertices.data() + v * summand_count, summand_count};
  }
};

/// Exact, of any number of polytopes of any dimensions; of none, the origin. The cells do not depend on the order of
/// the summands, their numbers do.
///
/// One summand after the other is added by overlays. No number grows: an edge of a sum is parallel to one of some
/// summand, which stands for it, and a normal is the product of two such.
/// O(sizes of all partial sums), with degrees as above. Source: Fogel, Halperin and Weibel 2009, section 4.
/// @throws Cancelled
PolytopeSumOfMany minkowski_sum(std::span<const Polytope> summands, const Context& context);

/// The sums of the vertices' coordinates.
std::vector<RationalPoint3> exact_vertices(const PolytopeSumOfMany& sum, std::span<const Polytope> summands);

}  // namespace quoin
