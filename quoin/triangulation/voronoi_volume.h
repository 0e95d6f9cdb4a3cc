// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/number/rational.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// The volume of the Voronoi cell of a vertex of a triangulation of dimension 3 that is not on its hull, from all cells
/// of the vertex in any order. Exact: integers of the coordinates, and one division at the end. O(k^2) bit operations
/// times the size of coordinates for k cells.
///
/// With the vertex as origin, the cone over the facet towards a neighbour w, of corners x_1, x_2 ... counterclockwise
/// from outside, is det(w, x_i, x_i+1) / 12 summed up, as the vector area of the facet goes along w and the facet is
/// half as far as w. An edge of the diagram belongs to two facets, to w and to w': together det(w - w', x, x') / 12.
/// The corner of a cell with det(a, b, c) = d > 0 is N / 2d with N = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b. So the
/// volume is the sum of det(w - w', N, N') / (48 d d').
///
/// With weights, |w|^2 is less by what w weighs more than the vertex, l(w), here and in N: the cone over the facet is
/// l(w) / (12 w_x) times the sum of its x_i x x_i+1, along the axis of some coordinate of w that is not zero.
Rational voronoi_volume(const TriangulationView3& triangulation, std::uint32_t vertex,
                        std::span<const std::uint32_t> star);

}  // namespace quoin
