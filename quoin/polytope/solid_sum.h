// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/base/context.h"
#include "quoin/polytope/polytope.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// The Minkowski sum of any two solids: all sums of a point of one and a point of the other. Holes, cavities, several
/// components and touching parts are ordinary; the empty set gives the empty set.
///
/// Exact. One overlay of the convolution of both boundaries (convolution.h): cells about which it winds belong to the
/// sum, those of winding number zero do where the first meets the second one reflected and placed at a point of them.
/// O(edges of a times edges of b), and that of an overlay of the convolution's triangles.
/// Source: Guibas, Ramshaw and Stolfi 1983; that winding numbers alone do not tell: Schapira 1991.
/// @throws InputError  a set is unbounded, or a coordinate on the way (of a sum, or of one solid reflected and placed
/// where the other is) leaves the range of doubles; Cancelled
Solid minkowski_sum(const Solid& a, const Solid& b, const Context& context);

/// The erosion of a by b: all translations that place b inside a. It is what the sum of the complement of a and b
/// reflected leaves out, regularized: places where b fits, but only just in some direction, are left out too.
/// Exact, complexity and errors as minkowski_sum; of an empty b it would be everything, which is an InputError.
Solid erosion(const Solid& a, const Solid& b, const Context& context);

/// The same with a convex polytope of any dimension, by the union of its sums with convex pieces of the solid: what a
/// flat one sweeps along. Exact; O(sums) and one overlay of these. @throws InputError  the solid is unbounded;
/// Cancelled
Solid minkowski_sum(const Solid& a, const Polytope& b, const Context& context);
Solid erosion(const Solid& a, const Polytope& b, const Context& context);

/// How much work a sum is, before it starts.
struct SumEstimate {
  std::size_t edges_of_first = 0;  ///< of the boundaries' faces
  std::size_t edges_of_second = 0;
  double edge_pairs = 0;
};
SumEstimate estimate_sum(const Solid& a, const Solid& b);

}  // namespace quoin
