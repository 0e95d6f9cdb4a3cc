// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "quoin/base/context.h"
#include "quoin/topology/ordered_boundaries.h"

namespace quoin {

/// Called with the ranks of the simplex with which a class is born, and that with which it dies.
using NotePair = std::function<void(std::uint32_t birth, std::uint32_t death)>;

/// Pairs of vertices and edges: the younger of two components dies with the edge that joins them. O(n α(n))
void pair_components(const OrderedBoundaries& boundaries, const Context& context, const NotePair& note);

/// Pairs of simplices of the highest dimension d and of dimension d - 1, none of which has more than two cofacets: in
/// reverse order the latter join the former, or join one with the outside. Where a component cannot be oriented and
/// `is_two` is not set (the field has other than two elements), it is joined to the outside too. O(n α(n))
void pair_dual_components(const OrderedBoundaries& boundaries, const CoboundaryColumns& coboundaries, bool is_two,
                          const Context& context, const NotePair& note);

}  // namespace quoin
