// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/fixed_int.h"
#include "quoin/number/rational.h"
#include "quoin/solid/brep.h"

namespace quoin {

/// Six times the signed volume of the cones between a point and some faces, enclosed: coordinates from there are
/// rounded down to a grid of about 2^-122 of the largest, and their determinants are exact. Each vertex is evaluated
/// once, and no fraction is added to another.
///
/// Coordinates are at most 2^122 units in magnitude, and off by less than one: each of the six products of a
/// determinant by less than 4 * 2^244, so the determinant by less than 2^249. Determinants stay below 2^370, sums of
/// 2^69 of them below 2^447.
class FixedPointCones {
 public:
  /// Of these faces; the nearer the point, the closer the bounds. Nothing where a coordinate leaves the range of
  /// doubles. O(their vertices).
  static std::optional<FixedPointCones> of(const Brep& boundary, std::span<const std::uint32_t> faces,
                                           const Point3& from, const Context& context);
  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }

 private:
  using Sum = FixedInt<7>;
  using Coordinates = std::array<FixedInt<2>, 3>;

  FixedPointCones(const Brep& boundary, const Point3& from, long bits)
      : boundary_(&boundary), from_(from), bits_(bits) {}
  void evaluate(const std::vector<PointId>& points, const Context& context);
  void add(std::span<const PointId> loop, Sum& sum, std::size_t& triangles) const;
  void enclose(std::span<const std::uint32_t> faces, const Context& context);

  const Brep* boundary_;
  Point3 from_;
  long bits_;  // a unit is 2^-bits
  std::vector<std::uint32_t> place_;
  std::vector<Coordinates> coordinates_;
  Rational low_;
  Rational high_;
};

}  // namespace quoin
