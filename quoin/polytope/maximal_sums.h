// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// The most facets that a Minkowski sum of solid polytopes with m_1, ..., m_k facets can have:
/// sum over i < j of (2 m_i - 5)(2 m_j - 5), plus sum of m_i, plus k (k - 1) / 2; for two, 4 m n - 9 m - 9 n + 26.
/// Source: Fogel, Halperin and Weibel 2009, sections 4.1 and 4.3. @throws InputError for fewer than four facets
std::size_t most_facets_of_sum(std::span<const std::size_t> facet_counts);

/// Polytopes with these numbers of facets whose sum has the most facets that it can have: the worst case of
/// `minkowski_sum`. Their vertices are rational, and their facets exactly planar.
///
/// A polytope with m facets lies in the unit cylinder about the z axis. Its top is a polygon at z = 0 from v_0, at
/// parameter t_0 = -1/2 of the circle, to the mirror image of it, through (1, 0) and (-1, 0), with its other vertices
/// on either side crowded towards these two ends. A second polygon hangs from the edge between them, the ridge at
/// y = y_0: each other vertex has a partner, the second point of the circle on the line from it to the pole (0, 1 /
/// y_0) of the ridge, at the height a (y - y_0). Chords and their partners meet on the ridge, since partners correspond
/// by the harmonic homology with the ridge as its axis, so the quadrilaterals between them are planar. With four facets
/// it is a thin tetrahedron. Summand i of k is turned about the y axis by about (i - 1) / k of half a turn, after a
/// little one about the z axis that keeps the arcs of more than two from crossing in the directions of the y axis. The
/// slope a and the crowding are made smaller until the sum, which is computed, reaches the bound. Source: Fogel,
/// Halperin and Weibel 2009, section 4.2; departs from it in the partners, whose quadrilaterals are not planar there.
/// @throws InputError for fewer than four facets; InternalError if no slope would do; Cancelled
std::vector<Polytope> maximal_summands(std::span<const std::size_t> facet_counts, const Context& context);

}  // namespace quoin
