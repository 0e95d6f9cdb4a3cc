// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/arrangement/sets/planar_motion.h"

namespace quoin {

struct PlanarMinkowskiOptions {
  /// Also find where only the open sets keep apart; costs an intersection of the operands for every vertex of the sum
  /// at which that is in doubt.
  bool find_tight_passages = false;
};

/// The sum of two sets and what it says about how one moves past the other.
struct PlanarMinkowskiSum {
  /// All p + q for p in A and q in B: closed and regular.
  LinearPolygonSet sum;
  /// All p + q for p inside A and q inside B: an open set, its closure is `sum`. Empty if not asked for.
  LinearPolygonSet open_sum;
  /// Edges and vertices inside `sum` that are not in the open sum: -B moved there touches A but does not enter it, on
  /// whichever side it would enter. Passages of exactly the width of the body, places into which it fits exactly. Empty
  /// if not asked for.
  LinearPolygonSet tight;
  std::size_t slits = 0;            ///< edges of `tight`
  std::size_t isolated_points = 0;  ///< vertices of `tight` without an edge of it
  std::size_t holes = 0;            ///< of `sum`
  std::size_t new_holes = 0;        ///< no part of whose boundary comes from a hole of an operand
  std::size_t vanished_holes = 0;   ///< of the operands, which bound no hole of the sum
};

/// The Minkowski sum of two bounded sets: polygons with holes, not convex, in several parts. The sets are regularized
/// first; if one is empty, so is the sum.
///
/// Exact, one sweep over the convolution of the boundaries (planar_convolution.h); coordinates that are no doubles are
/// kept as rationals. Equal and homothetic operands, common directions and touching boundaries are ordinary. For n and
/// m vertices with r and s reflex ones, the convolution of two simple polygons has at most n + m + 2 n s + 2 m r edges;
/// O((k + c) log k) for k edges with c crossings, linear many for convex operands.
/// @throws InputError a set is unbounded; Cancelled
PlanarMinkowskiSum minkowski_sum(const LinearPolygonSet& a, const LinearPolygonSet& b,
                                 const PlanarMinkowskiOptions& options, const Context& context);

}  // namespace quoin
