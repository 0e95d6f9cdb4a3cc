// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// An elementary collapse: a free face, whose one coface of any dimension is `coface`, and that, go together.
struct ElementaryCollapse {
  std::uint32_t free_face = 0;  ///< among the simplices of dimension - 1
  std::uint32_t coface = 0;
  int dimension = 0;  ///< of the coface
};

/// What a sequence of elementary collapses did.
struct CollapseResult {
  std::vector<ElementaryCollapse> steps;  ///< each free when it is its turn
  std::vector<SimplexId> rest;            ///< what is left, a complex, by dimension and place
};

/// Collapses as long as there is a free face of dimension `least` or more.
///
/// Homotopy type, homology and Euler characteristic stay. Faces of high dimension go first, otherwise those that came
/// free first; a smaller rest may exist, and to find the smallest is hard. O(size) beyond the incidences.
/// @throws Cancelled
CollapseResult collapse(const SimplicialComplex& complex, const Context& context, int least = 0);

/// The complex that is left of another, with its labels.
SimplicialComplex rest_of_collapse(const SimplicialComplex& complex, const CollapseResult& result,
                                   const Context& context);

/// An order of the simplices of each dimension in which most boundaries have a last facet of their own.
///
/// The complex is taken apart by elementary collapses, and by removing a maximal simplex of the highest dimension where
/// nothing is free; the order is the reverse of that. Simplices that were removed alone are the critical ones, of which
/// there are at least as many as homology has generators. Every prefix is a complex. Source: Forman (1998); Benedetti,
/// Lutz: Random discrete Morse theory (2014).
struct CollapseOrder {
  std::vector<std::vector<std::uint32_t>> simplices;  ///< by dimension, in this order
  std::vector<std::size_t> critical;                  ///< how many, by dimension
};
CollapseOrder collapse_order(const SimplicialComplex& complex, const Context& context);

}  // namespace quoin
