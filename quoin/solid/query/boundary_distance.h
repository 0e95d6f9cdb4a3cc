// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// How far two boundaries are apart.
struct BoundaryDistance {
  Rational squared_distance{0};
  std::array<RationalPoint3, 2> witness{};  ///< a point of each, as far apart; equal where they meet
};

/// Exact, for boundaries of explicit and constructed points that have faces. Pairs of triangles in trees of boxes are
/// bounded in doubles from both sides (triangle_distance.h); those that these leave are compared in rationals, and
/// where two triangles meet the search ends. O(log n) pairs and more where many are about as near.
/// @throws InputError where one has no faces, Cancelled
BoundaryDistance boundary_distance(const Brep& a, const Brep& b, const Context& context);

}  // namespace quoin
