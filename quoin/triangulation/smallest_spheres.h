// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/number/integer.h"
#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin {

/// A number as it is computed: numerator / denominator * 2^exponent; the denominator is positive.
struct ExactQuotient {
  Integer numerator;
  Integer denominator;
  int exponent = 0;

  Rational rational() const;
  /// Of a width of a few units in the last place.
  Interval interval() const;
  /// The nearest double, ties to even; infinite beyond the largest.
  double nearest() const { return rational().to_double(); }
  /// Times 2^shift, rounded down.
  Integer scaled_floor(int shift) const;
};
Sign compare(const ExactQuotient& a, const ExactQuotient& b);

/// The smallest sphere through the vertices of a simplex; with weights, orthogonal to the spheres about them whose
/// squared radii are the weights. Its power is its squared radius: of a vertex, less than nothing by its weight.
///
/// Simplices are sequences of one to four affinely independent points, by their numbers. Exact for all finite doubles.
/// The tiers: doubles, with bounds for the call; where the values of the call are small multiples of the common grid,
/// the double itself; integers of fixed widths; integers of any size.
class SmallestSpheres {
 public:
  using Simplex = std::span<const std::uint32_t>;

  /// No weights, or one for each point.
  explicit SmallestSpheres(std::vector<Point3> points, std::vector<double> weights = {});

  std::size_t size() const { return points_.size(); }
  bool is_weighted() const { return !weights_.empty(); }
  const Point3& point(std::uint32_t i) const { return points_[i]; }
  double weight(std::uint32_t i) const { return weights_.empty() ? 0 : weights_[i]; }

  /// Holds the power of the simplex, within one part in 2^24 of it (of the power and the weight of some vertex, if
  /// there are weights); a point where doubles hold it.
  Interval power(Simplex simplex) const;
  /// The same, of a width of a few units in the last place.
  Interval close_power(Simplex simplex) const;
  ExactQuotient exact_power(Simplex simplex) const;
  /// The double nearest to the power, ties to even; infinite beyond the largest. Less than a microsecond as a rule.
  double nearest_power(Simplex simplex) const;

  /// Sign of the power of q less that of the smallest sphere of the facet: negative where q is inside. They are
  /// independent, the facet has one to three points.
  Sign side(Simplex facet, std::uint32_t q) const;

  /// All about a tetrahedron at once: its power, and the sides of its points in the spheres of the facets opposite.
  struct Cell {
    Interval power;
    std::array<Sign, 4> side;
  };
  Cell cell(std::array<std::uint32_t, 4> vertices) const;

 private:
  std::optional<Sign> filtered_weighted_side(Simplex facet, std::uint32_t q) const;
  Sign exact_side(Simplex facet, std::uint32_t q) const;

  std::vector<Point3> points_;
  std::vector<double> weights_;
  double grid_ = 0;   ///< a power of two: coordinates are multiples of it, weights of its square; 0 if there is none
  double scale_ = 0;  ///< makes coordinates integers below 2^61, where they are such
};

}  // namespace quoin
