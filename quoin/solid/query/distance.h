// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "quoin/kernel/rational_point.h"
#include "quoin/solid/query/interference.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// How two solids lie to one another.
struct SolidDistance {
  Interference relation = Interference::apart;
  Rational squared_distance{0};             ///< of their nearest points; 0 unless they are apart
  std::array<RationalPoint3, 2> witness{};  ///< a point of the first and one of the second that are nearest: equal if
                                            ///< they touch; nothing if they overlap
};

/// Exact, for any two evaluated solids: with holes, of several pieces, one in a cavity of the other, unbounded. The
/// distance of their boundaries (boundary_distance.h); where these do not meet, one point of each shell tells whether a
/// solid is inside the other; where they do, the solids overlap if their regularized intersection is not empty, which
/// costs one.
/// @throws InputError if one is empty, Cancelled
SolidDistance solid_distance(const Solid& a, const Solid& b, const Context& context);

}  // namespace quoin
