// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/sphere_direction.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace quoin {
namespace {

using fixed_int_detail::Int128;
using fixed_int_detail::UInt128;

UInt128 magnitude_of(Int128 value) {
  return value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

unsigned bit_width(UInt128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  if (high != 0) return 64 + static_cast<unsigned>(std::bit_width(high));
  return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(value)));
}

/// Of a nonzero value.
unsigned trailing_zeros(UInt128 value) {
  const auto low = static_cast<std::uint64_t>(value);
  if (low != 0) return static_cast<unsigned>(std::countr_zero(low));
  return 64 + static_cast<unsigned>(std::countr_zero(static_cast<std::uint64_t>(value >> 64)));
}

FixedInt<2> to_fixed(Int128 value) {
  FixedInt<2> fixed;
  fixed.set_limb(0, static_cast<std::uint64_t>(value));
  fixed.set_limb(1, static_cast<std::uint64_t>(value >> 64));
  return fixed;
}

/// Below 2^126 in magnitude.
Int128 to_int128(const Integer& value) {
  std::array<std::uint64_t, 2> limbs{};
  mpz_export(limbs.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, value.raw());
  const auto size = static_cast<Int128>((static_cast<UInt128>(limbs[1]) << 64) | limbs[0]);
  return value.sign() == Sign::negative ? -size : size;
}

/// value = mantissa 2^exponent, the mantissa odd, or zero.
struct OddMantissa {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

OddMantissa decompose(double value) {
  if (value == 0) return {};
  constexpr std::uint64_t hidden = std::uint64_t{1} << 52;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>((bits >> 52) & 0x7FF);
  const std::uint64_t size = biased == 0 ? bits & (hidden - 1) : (bits & (hidden - 1)) | hidden;
  const int zeros = std::countr_zero(size);
  const auto odd = static_cast<std::int64_t>(size >> zeros);
  return {value < 0 ? -odd : odd, std::max(biased, 1) - 1075 + zeros};
}

}  // namespace

SphereDirection::SphereDirection(const Vector3& vector) {
  is_finite_ = std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
  if (!is_finite_) return;
  const std::array<OddMantissa, 3> parts{decompose(vector.x), decompose(vector.y), decompose(vector.z)};
  int lowest = 2000;
  int highest = -2000;
  for (const OddMantissa& part : parts) {
    if (part.mantissa == 0) continue;
    lowest = std::min(lowest, part.exponent);
    highest = std::max(highest, part.exponent + static_cast<int>(bit_width(magnitude_of(part.mantissa))));
  }
  if (highest - lowest <= static_cast<int>(small_bits)) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (parts[i].mantissa != 0) {
        small_[i] = static_cast<Int128>(parts[i].mantissa) * (Int128{1} << (parts[i].exponent - lowest));
      }
    }
  } else {
    for (const OddMantissa& part : parts) {
      big_.emplace_back(part.mantissa);
      if (part.mantissa != 0) big_.back() <<= static_cast<std::size_t>(part.exponent - lowest);
    }
  }
  reduce();
}

SphereDirection::SphereDirection(const std::array<Integer, 3>& vector) : big_(vector.begin(), vector.end()) {
  reduce();
}

SphereDirection::SphereDirection(const std::array<Rational, 3>& vector) {
  const std::array<Integer, 3> divisors{vector[0].denominator(), vector[1].denominator(), vector[2].denominator()};
  for (std::size_t i = 0; i < 3; ++i) {
    big_.push_back(vector[i].numerator() * divisors[(i + 1) % 3] * divisors[(i + 2) % 3]);
  }
  reduce();
}

Integer SphereDirection::integer(std::size_t axis) const {
  return is_small() ? to_integer(to_fixed(small_[axis])) : big_[axis];
}

SphereDirection SphereDirection::operator-() const {
  SphereDirection result(*this);
  for (Int128& value : result.small_) value = -value;
  for (Integer& value : result.big_) value = -value;
  return result;
}

SphereDirection SphereDirection::primitive() const {
  std::array<Integer, 3> values = integers();
  Integer divisor;
  for (const Integer& value : values) mpz_gcd(divisor.raw(), divisor.raw(), value.raw());
  if (divisor.sign() == Sign::zero) return *this;
  for (Integer& value : values) mpz_divexact(value.raw(), value.raw(), divisor.raw());
  return values;
}

void SphereDirection::reduce() {
  if (is_small()) {
    reduce_small();
    return;
  }
  std::size_t twos = SIZE_MAX;
  for (const Integer& value : big_) {
    if (value.sign() != Sign::zero) twos = std::min(twos, value.trailing_zeros());
  }
  bits_ = 0;
  for (Integer& value : big_) {
    if (value.sign() == Sign::zero) continue;
    value >>= twos;
    bits_ = std::max(bits_, static_cast<unsigned>(value.bit_length()));
  }
  if (bits_ > small_bits) return;
  for (std::size_t i = 0; i < 3; ++i) small_[i] = to_int128(big_[i]);
  big_.clear();
}

void SphereDirection::reduce_small() {
  const UInt128 any = magnitude_of(small_[0]) | magnitude_of(small_[1]) | magnitude_of(small_[2]);
  if (any == 0) return;
  const unsigned twos = trailing_zeros(any);
  for (Int128& value : small_) value >>= twos;
  bits_ = bit_width(any) - twos;
}

SphereDirection cross(const SphereDirection& a, const SphereDirection& b) {
  if (a.is_small() && b.is_small() && a.bits() + b.bits() + 1 <= SphereDirection::small_bits) {
    SphereDirection::Small product;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      product[i] = a.small_[j] * b.small_[k] - a.small_[k] * b.small_[j];
    }
    return SphereDirection(product);
  }
  const std::array<Integer, 3> s = a.integers();
  const std::array<Integer, 3> t = b.integers();
  return std::array<Integer, 3>{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
}

Sign dot_sign(const SphereDirection& a, const SphereDirection& b) {
  if (a.is_small() && b.is_small()) {
    const auto term = [&](std::size_t i) { return multiply<4>(to_fixed(a.small_[i]), to_fixed(b.small_[i])); };
    return (term(0) + term(1) + term(2)).sign();
  }
  Integer sum;
  for (std::size_t i = 0; i < 3; ++i) sum += a.integer(i) * b.integer(i);
  return sum.sign();
}

}  // namespace quoin
