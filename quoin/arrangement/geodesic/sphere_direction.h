// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"
#include "quoin/number/rational.h"

namespace quoin {

/// A direction of space: the ray from the origin through three integers without a common factor of two. Vectors of
/// doubles, integers and rationals convert exactly and are never normalised.
///
/// The zero vector and vectors that are not finite convert too; they are no directions, `is_valid` tells, and whoever
/// takes a direction as input refuses them by name. Up to 126 bits nothing is allocated.
class SphereDirection {
 public:
  using Int128 = fixed_int_detail::Int128;
  /// Components below 2^126 in magnitude are kept without allocation.
  static constexpr unsigned small_bits = 126;

  SphereDirection(const Vector3& vector);                     // NOLINT(google-explicit-constructor)
  SphereDirection(const std::array<Integer, 3>& vector);      // NOLINT(google-explicit-constructor)
  SphereDirection(const std::array<Rational, 3>& vector);     // NOLINT(google-explicit-constructor)
  SphereDirection(const std::array<std::int64_t, 3>& vector)  // NOLINT(google-explicit-constructor)
      : SphereDirection(Small{vector[0], vector[1], vector[2]}) {}

  /// Finite and not zero.
  bool is_valid() const { return is_finite_ && bits_ > 0; }
  bool is_finite() const { return is_finite_; }
  Sign sign(std::size_t axis) const {
    if (!big_.empty()) return big_[axis].sign();
    return static_cast<Sign>((small_[axis] > 0) - (small_[axis] < 0));
  }
  /// Bits of the largest component, without a sign.
  unsigned bits() const { return bits_; }
  bool is_small() const { return big_.empty(); }
  /// Only of a small one.
  Int128 small(std::size_t axis) const { return small_[axis]; }
  Integer integer(std::size_t axis) const;
  std::array<Integer, 3> integers() const { return {integer(0), integer(1), integer(2)}; }

  SphereDirection operator-() const;
  /// The same ray, the integers without any common factor.
  SphereDirection primitive() const;

  /// Direction of the vector product; the zero vector if and only if a and b are equal or opposite.
  friend SphereDirection cross(const SphereDirection& a, const SphereDirection& b);
  /// Sign of the scalar product.
  friend Sign dot_sign(const SphereDirection& a, const SphereDirection& b);

 private:
  using Small = std::array<Int128, 3>;
  /// Components of at most 126 bits.
  explicit SphereDirection(const Small& vector) : small_(vector) { reduce(); }

  /// Divides by the common power of two, moves to the form without allocation where it fits, counts bits.
  void reduce();
  void reduce_small();

  Small small_{};
  std::vector<Integer> big_;  ///< three components, or none: then `small_` holds
  unsigned bits_ = 0;
  bool is_finite_ = true;
};

}  // namespace quoin
