// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Whether a simplex of dimension k that enters a complex makes a new class of degree k, or ends one of degree k - 1.
/// All other Betti numbers stay. One per simplex, in the order in which they enter.
using BettiSteps = std::vector<bool>;

/// The steps over the field of p elements, by reduction.
/// @throws InputError  p is not a prime below 2^31; `order` lacks a simplex, has one twice, or before one of its faces
/// Source: Delfinado, Edelsbrunner: An incremental algorithm for Betti numbers of simplicial complexes on the 3-sphere
/// (1995), proposition on the change.
BettiSteps incremental_betti(const SimplicialComplex& complex, std::span<const SimplexId> order, std::uint32_t p,
                             const Context& context);

/// The same for a triangulated ball of dimension 3, by disjoint sets in near linear time: components grow with edges,
/// and components of the outside shrink with triangles, seen from the end. The steps are those over any field, as
/// complexes in space have no torsion.
/// @throws InputError  as above, and where the whole is not a manifold with the homology of a ball: on such complexes
///                     the rule for triangles is wrong
BettiSteps incremental_betti_in_space(const SimplicialComplex& ball, std::span<const SimplexId> order,
                                      const Context& context);

/// Betti numbers after each step, by degree.
std::vector<std::vector<std::size_t>> betti_numbers_by_step(std::span<const SimplexId> order, const BettiSteps& births,
                                                            int dimension);

}  // namespace quoin
