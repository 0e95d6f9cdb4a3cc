// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/solid/solid.h"

namespace quoin {

enum class BallSide {
  within,  ///< the polytope lies in the ball, and holds the one of a radius smaller by the tolerance
  around   ///< the polytope holds the ball, and lies in the one of a radius larger by the tolerance
};

/// A polytope near the ball about the origin: vertices are doubles, and both bounds are checked exactly. Geodesic, of
/// about 6 radius / tolerance facets.
///
/// Sums and erosions with both bound those with the ball from two sides, each within the tolerance.
/// @throws InputError  radius and tolerance are not positive and finite, the radius is outside [2^-300, 2^300], or the
/// tolerance is below 2^-20 of it
Solid ball_polytope(double radius, double tolerance, BallSide side, const Context& context);

}  // namespace quoin
