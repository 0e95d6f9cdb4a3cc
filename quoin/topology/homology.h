// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/integer.h"
#include "quoin/topology/ordered_boundaries.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Betti numbers over the field of p elements, by dimension 0 ... dimension of the complex. Exact.
///
/// The complex is collapsed first, then boundaries are reduced from the highest dimension down, without those that are
/// known to be cycles ("twist"). Near linear where few simplices are critical.
/// @throws InputError  p is not a prime below 2^31
/// @throws Cancelled
/// Source: Chen, Kerber: Persistent homology computation with a twist (2011).
std::vector<std::size_t> betti_numbers(const SimplicialComplex& complex, std::uint32_t p, const Context& context);

/// Homology with integer coefficients: in each dimension k the sum of betti[k] copies of the integers and of cyclic
/// groups of the orders torsion[k].
struct IntegerHomology {
  std::vector<std::size_t> betti;             ///< also the Betti numbers over the rationals
  std::vector<std::vector<Integer>> torsion;  ///< each above 1 and a divisor of the next
};

/// The integer homology of a complex. Exact, for torsion of any size.
///
/// As above with pivots 1 and -1; what is left of the matrices goes to `elementary_divisors`.
IntegerHomology integer_homology(const SimplicialComplex& complex, const Context& context);

/// Both of boundaries in any order, so that a complex is collapsed once for several rings: that of `collapsed` is the
/// one in which few columns are changed.
std::vector<std::size_t> betti_numbers(const OrderedBoundaries& boundaries, std::uint32_t p, const Context& context);
IntegerHomology integer_homology(const OrderedBoundaries& boundaries, const Context& context);
/// The boundaries of a complex in the order that its collapses give. O(size) @throws Cancelled
OrderedBoundaries collapsed(const SimplicialComplex& complex, const Context& context);

/// Betti numbers over the field of p elements that integer homology has by the universal coefficient theorem: besides
/// those over the rationals, one in dimensions k and k + 1 for each order of torsion in dimension k that p divides.
std::vector<std::size_t> betti_numbers(const IntegerHomology& homology, std::uint32_t p);

bool is_prime(std::uint32_t n);

/// The primes below 2^31 that divide an order of torsion, in ascending order, found by division up to 2^16: what is
/// left of an order then is not looked into unless it is below 2^31 itself.
std::vector<std::uint32_t> torsion_primes(const IntegerHomology& homology);

}  // namespace quoin
