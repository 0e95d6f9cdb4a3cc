// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// A solid as convex pieces whose insides are disjoint.
struct ConvexDecomposition {
  std::vector<Solid> pieces;
  std::size_t notches = 0;      ///< edges at which the solid is not convex
  std::size_t cuts = 0;         ///< by planes of its faces
  std::size_t lower_bound = 0;  ///< no decomposition into convex pieces with disjoint insides has fewer
};

/// Few, not the fewest: that is NP-hard. Exact; holes, cavities, several components and solids that touch themselves
/// are ordinary.
///
/// A piece with notches is cut by the plane of a face at one of them, the one that ends most notches and cuts fewest
/// others, and falls apart into components. At the end neighbours whose union is convex are joined, those with the
/// largest common faces first. No plane is used but those of faces, so numbers do not grow.
///
/// The bound: two convex pieces have at most one plane in common, each notch where two faces meet lies in such a plane,
/// and no plane holds two of a set of notches that are pairwise not coplanar, which is chosen greedily. So with c of
/// these k (k - 1) / 2 is at least c; of several components bounds add up. O(cuts) overlays of pieces; O(notches^2) at
/// worst to choose one. Source: Chazelle 1984; Bajaj and Dey 1992.
/// @throws InputError  the solid is unbounded; Cancelled
ConvexDecomposition convex_decomposition(const Solid& solid, const Context& context);

}  // namespace quoin
