// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "quoin/number/fixed_int.h"
#include "quoin/number/rational.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Cones between a point, the origin if no other is chosen, and faces whose vertices are doubles on one grid of at most
/// 124 bits, in fixed-width integers instead of rationals; nothing is kept per face.
///
/// Coordinates are below 2^B in units of the grid, B = 61 or 124, so those from a point among them below 2^(B+1), a
/// minor below 2^(2B+3) and a determinant below 2^(3B+6): 125 and 189 bits, 251 and 378. Sums of up to 2^66
/// determinants stay below 2^255 and 2^444.
class DyadicCones {
 public:
  using Sum = FixedInt<7>;

  /// Nothing where the boundary's explicit points need a wider grid. O(points).
  static std::optional<DyadicCones> of(const Brep& boundary);

  /// All vertices of the face are explicit.
  bool holds(std::uint32_t face) const;
  /// All cones are to this explicit point from now on.
  void measure_from(PointId apex);
  /// Six times the signed volume between that point and a face that it holds, in units of the grid, is added.
  void add(std::uint32_t face, Sum& sum) const;
  /// The same in units of the coordinates.
  Rational value(const Sum& sum) const;

 private:
  DyadicCones(const Brep& boundary, int lo, bool is_wide);
  template <std::size_t Limbs>
  std::array<FixedInt<Limbs>, 3> scaled(const Point3& point) const;
  template <std::size_t Limbs>
  std::array<FixedInt<Limbs>, 3> corner(PointId p) const;
  template <std::size_t Limbs, std::size_t SumLimbs>
  FixedInt<SumLimbs> determinants(std::span<const PointId> loop) const;

  const Brep* boundary_;
  int lo_;
  bool is_wide_;        // 124 bits, else 61
  double scale_first_;  // x 2^-lo = x * scale_first_ * scale_second_, neither product rounding
  double scale_second_;
  std::array<FixedInt<2>, 3> from_;
};

}  // namespace quoin
