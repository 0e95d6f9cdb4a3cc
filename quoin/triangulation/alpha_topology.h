// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "quoin/base/context.h"
#include "quoin/triangulation/alpha_complex.h"

namespace quoin {

/// Components, tunnels and voids of the alpha complex of so many grades: its Betti numbers, over any field and the
/// integers, as subcomplexes of a triangulated ball have no torsion. Components by edges; voids are what the complement
/// has beside the outside (Alexander duality); tunnels are what the Euler characteristic lacks. O(n a(n)) for n
/// simplices, where `betti_numbers` of the subcomplex reduces matrices. @throws Cancelled
/// Source: Delfinado and Edelsbrunner 1995.
std::array<std::size_t, 3> alpha_betti_numbers(const AlphaComplex& alpha, std::uint32_t grades, const Context& context);

/// The parts into which the simplices of full dimension of that complex fall, joined where they share a facet.
/// O(n a(n)) @throws Cancelled
std::size_t alpha_pieces(const AlphaComplex& alpha, std::uint32_t grades, const Context& context);

/// The least number of grades at which each vertex is a corner of a simplex of full dimension, and these are `most`
/// pieces or fewer; there is one, as all of them are one piece. O(n log n) for n such simplices.
/// @throws InputError if `most` is zero or there are no points; Cancelled
std::uint32_t grades_with_pieces(const AlphaComplex& alpha, std::size_t most, const Context& context);

}  // namespace quoin
