// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "quoin/kernel/point.h"
#include "quoin/triangulation/delaunay_signs.h"

namespace quoin {

/// What is known of all weights of a triangulation together.
struct WeightExtent {
  double largest = 0;  ///< magnitude
  int lowest_bit = std::numeric_limits<int>::max();

  void add(double weight);
};

/// The predicates of a regular triangulation of weighted points, by their indices; a weight is the square of a radius,
/// and may be negative.
///
/// Exact for all points and weights. The tiers: a bound for the call; where the values of the call are small multiples
/// of the grid, the double itself; integers. Ties as DelaunaySigns.
class RegularSigns {
 public:
  static constexpr bool may_hide = true;

  RegularSigns() = default;
  /// If the points lie in one plane but for the last, `is_flat`.
  RegularSigns(std::span<const Point3> points, std::span<const double> weights, bool is_flat);
  /// Of points and weights within an extent, with an `apex` or none, as DelaunaySigns.
  RegularSigns(std::span<const Point3> points, std::span<const double> weights, const PointExtent& extent,
               const WeightExtent& weight_extent, std::uint32_t apex);

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return plain_.orientation(a, b, c, d);
  }

  /// Whether the power of q is less than that of the sphere orthogonal to the cell's.
  bool in_conflict(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q) const {
    const int sign = power_sign(a, b, c, d, q);
    if (sign != 0) return sign > 0;
    const std::array<std::uint32_t, 5> v{a, b, c, d, q};
    return is_perturbed_inside(
        v, [&](unsigned i, unsigned j) { return lexicographically_less(points_[v[i]], points_[v[j]]); },
        [this](auto... vertices) { return orientation(vertices...); });
  }

  /// Without perturbation; positive in conflict.
  int power_sign(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q) const;

 private:
  int exact_power_sign(const std::array<std::uint32_t, 5>& v) const;

  DelaunaySigns plain_;
  const Point3* points_ = nullptr;
  const double* weights_ = nullptr;
  double grid_ = 0;  ///< products of maxima below it do not round
};

}  // namespace quoin
