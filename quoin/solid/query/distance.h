// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "quoin/kernel/rational_point.h"
#include "quoin/solid/query/boundary_distance.h"
#include "quoin/solid/query/interference.h"
#include "quoin/solid/query/point_location.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// How two solids lie to one another.
struct SolidDistance {
  Interference relation = Interference::apart;
  Rational squared_distance{0};             ///< of their nearest points; 0 unless they are apart
  std::array<RationalPoint3, 2> witness{};  ///< a point of the first and one of the second that are nearest: equal if
                                            ///< they touch; nothing if they overlap
};

/// Answers how two solids lie to one another, for any translation of the first.
///
/// Exact, for any two evaluated solids: with holes, of several pieces, one in a cavity of the other, unbounded. The
/// distance of their boundaries (boundary_distance.h); where these do not meet, one point of each shell tells whether a
/// solid is inside the other; where they cross inside a face, the solids overlap; where they only meet in other ways,
/// if their regularized intersection is not empty, which costs one. Immutable after construction; safe to share between
/// threads.
class SolidProximity {
 public:
  /// O(n log n). @throws InputError if one is empty, Cancelled
  SolidProximity(const Solid& a, const Solid& b, const Context& context);

  /// The witness of the first is where it is then. @throws Cancelled
  SolidDistance distance(const RationalPoint3& translation, const Context& context) const;

 private:
  bool do_interiors_meet(const RationalPoint3& translation, const Context& context) const;

  Solid a_;
  Solid b_;
  std::unique_ptr<const BoundaryProximity> boundaries_;  // none of all of space
  std::unique_ptr<const SolidLocator> in_a_;
  std::unique_ptr<const SolidLocator> in_b_;
};

/// Of the two as they are.
SolidDistance solid_distance(const Solid& a, const Solid& b, const Context& context);

}  // namespace quoin
