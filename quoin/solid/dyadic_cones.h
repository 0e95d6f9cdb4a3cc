// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "quoin/number/fixed_int.h"
#include "quoin/number/rational.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Cones between the origin and faces whose vertices are doubles on one grid of 61 bits, in fixed-width integers
/// instead of rationals; nothing is kept per face.
///
/// With coordinates below 2^61 in units of the grid, a minor is below 2^123, a determinant below 2^186, and sums of up
/// to 2^69 of them stay below 2^255.
class DyadicCones {
 public:
  using Sum = FixedInt<4>;

  /// Nothing where the boundary's explicit points need a wider grid. O(points).
  static std::optional<DyadicCones> of(const Brep& boundary);

  /// All vertices of the face are explicit.
  bool holds(std::uint32_t face) const;
  /// Six times the signed volume between the origin and a face that it holds, in units of the grid, is added.
  void add(std::uint32_t face, Sum& sum) const;
  /// The same in units of the coordinates.
  Rational value(const Sum& sum) const;

 private:
  DyadicCones(const Brep& boundary, int lo);
  std::array<FixedInt<1>, 3> scaled(PointId p) const;

  const Brep* boundary_;
  int lo_;
  double scale_first_;  // x 2^-lo = x * scale_first_ * scale_second_, neither product rounding
  double scale_second_;
};

}  // namespace quoin
