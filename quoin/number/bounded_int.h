// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "quoin/base/sign.h"
#include "quoin/number/fixed_int.h"

namespace quoin {

/// An integer whose magnitude is below 2^Bits, known at compile time. Sums and products have the type that holds them,
/// so that an expression is exact by construction and every step of it as narrow as may be.
template <std::size_t Bits>
class BoundedInt {
 public:
  static constexpr std::size_t bits = Bits;
  using Limbs = FixedInt<limbs_for_bits(Bits + 1)>;

  BoundedInt() = default;
  /// |value| < 2^Bits.
  explicit BoundedInt(std::int64_t value) : limbs_(value) {}
  /// The value must fit.
  explicit BoundedInt(const Limbs& limbs) : limbs_(limbs) {}
  /// Into a wider type.
  template <std::size_t Narrow>
  requires(Narrow < Bits) BoundedInt(const BoundedInt<Narrow>& other)  // NOLINT(google-explicit-constructor)
      : limbs_(other.limbs()) {}

  const Limbs& limbs() const { return limbs_; }
  Sign sign() const { return limbs_.sign(); }

  BoundedInt operator-() const { return BoundedInt(-limbs_); }

 private:
  Limbs limbs_;
};

template <std::size_t A, std::size_t B>
inline BoundedInt<std::max(A, B) + 1> operator+(const BoundedInt<A>& a, const BoundedInt<B>& b) {
  using Sum = BoundedInt<std::max(A, B) + 1>;
  using Limbs = typename Sum::Limbs;
  return Sum(Limbs(a.limbs()) + Limbs(b.limbs()));
}

template <std::size_t A, std::size_t B>
inline BoundedInt<std::max(A, B) + 1> operator-(const BoundedInt<A>& a, const BoundedInt<B>& b) {
  using Difference = BoundedInt<std::max(A, B) + 1>;
  using Limbs = typename Difference::Limbs;
  return Difference(Limbs(a.limbs()) - Limbs(b.limbs()));
}

template <std::size_t A, std::size_t B>
inline BoundedInt<A + B> operator*(const BoundedInt<A>& a, const BoundedInt<B>& b) {
  using Product = BoundedInt<A + B>;
  return Product(multiply<Product::Limbs::limb_count>(a.limbs(), b.limbs()));
}

/// The nearest double; magnitudes below 2^1023.
template <std::size_t Bits>
inline double to_double(const BoundedInt<Bits>& a) {
  static_assert(Bits < 1023);
  if (a.sign() == Sign::zero) return 0;
  const LeadingBits leading = leading_bits(a.limbs());
  const double size = std::ldexp(nearest_mantissa(leading), static_cast<int>(leading.exponent));
  return a.sign() == Sign::negative ? -size : size;
}

}  // namespace quoin
