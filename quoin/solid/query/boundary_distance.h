// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// How far two boundaries are apart.
struct BoundaryDistance {
  Rational squared_distance{0};
  std::array<RationalPoint3, 2> witness{};  ///< a point of each, as far apart; equal where they meet
  /// An edge of one crosses a triangle inside a face of the other, where there is nothing else of that boundary: then
  /// the solids that they bound overlap. Not set of all that overlap.
  bool is_crossing = false;
};

/// Answers how far two boundaries are apart, for any translation of the first.
///
/// Exact, for boundaries of explicit and constructed points that have faces. Pairs of triangles in trees of boxes are
/// bounded in doubles from both sides (triangle_distance.h); those that these leave are compared in rationals, and
/// where two triangles meet the search ends. A query takes O(log n) pairs, and more where many are about as near.
/// Immutable after construction; safe to share between threads.
class BoundaryProximity {
 public:
  /// O(n log n). The boundaries must outlive it. @throws InputError where one has no faces, Cancelled
  BoundaryProximity(const Brep& a, const Brep& b, const Context& context);
  ~BoundaryProximity();
  BoundaryProximity(const BoundaryProximity&) = delete;
  BoundaryProximity& operator=(const BoundaryProximity&) = delete;

  /// The witness of the first is where it is then. @throws Cancelled
  BoundaryDistance distance(const RationalPoint3& translation, const Context& context) const;

 private:
  class Covered;
  class Search;
  std::unique_ptr<const Covered> a_;
  std::unique_ptr<const Covered> b_;
};

}  // namespace quoin
