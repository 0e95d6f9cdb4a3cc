// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <compare>
#include <utility>

#include "quoin/arrangement/geodesic/sphere_direction.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// By the integers, x first. Of primitive ones, equal if and only if the directions are.
std::strong_ordering compare(const SphereDirection& a, const SphereDirection& b);
inline bool are_equal(const SphereDirection& a, const SphereDirection& b) {
  return compare(a, b) == std::strong_ordering::equal;
}

/// A direction with doubles beside it, so that most scalar products need nothing else.
class RegionDirection {
 public:
  /// Made primitive, so that equal directions have equal integers. Implicit, as it loses nothing.
  RegionDirection(const SphereDirection& direction);  // NOLINT(google-explicit-constructor)

  const SphereDirection& exact() const { return exact_; }
  RegionDirection operator-() const { return {-exact_, {-rounded_.x, -rounded_.y, -rounded_.z}}; }

  /// Sign of the scalar product. Exact.
  ///
  /// With u = 2^-53: components are rounded, below 2 in magnitude, each within u of itself; products are rounded once
  /// and sums twice, which comes to less than 6 u times the sum of the magnitudes of the products, and what falls below
  /// the range of doubles to less than 2^-1000.
  friend Sign dot_sign(const RegionDirection& a, const RegionDirection& b) {
    const double x = a.rounded_.x * b.rounded_.x;
    const double y = a.rounded_.y * b.rounded_.y;
    const double z = a.rounded_.z * b.rounded_.z;
    const double sum = x + y + z;
    const double bound = 6 * 0x1p-53 * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 0x1p-1000;
    if (sum > bound) return Sign::positive;
    if (sum < -bound) return Sign::negative;
    return dot_sign(a.exact_, b.exact_);
  }
  /// Enough for a positive scalar product with a vector whose components were rounded once; the bound is that of
  /// dot_sign.
  bool is_surely_positive(const Vector3& v) const {
    const double x = rounded_.x * v.x;
    const double y = rounded_.y * v.y;
    const double z = rounded_.z * v.z;
    const double size = std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
    return x + y + z > 6 * 0x1p-53 * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 0x1p-1000 * size + 0x1p-1000;
  }
  friend RegionDirection cross(const RegionDirection& a, const RegionDirection& b) { return cross(a.exact_, b.exact_); }
  friend bool operator==(const RegionDirection& a, const RegionDirection& b) { return are_equal(a.exact_, b.exact_); }

 private:
  RegionDirection(SphereDirection exact, const Vector3& rounded) : exact_(std::move(exact)), rounded_(rounded) {}

  SphereDirection exact_;
  Vector3 rounded_;  ///< times a power of two
};

}  // namespace quoin
