// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"

/// Correct rounding of quotients of exact numbers.
namespace quoin::detail {

/// value 2^exponent, correctly rounded wherever the result is normal or the product is exact.
inline double scaled(double value, std::int64_t exponent) {
  if (exponent >= -960 && exponent <= 960 && std::fabs(value) <= 0x1p60) [[likely]] {
    return value * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  }
  return std::ldexp(value, static_cast<int>(std::clamp<std::int64_t>(exponent, -100'000, 100'000)));
}

/// What the leading bits say about the double nearest to a positive quotient q: it is `floor` 2^unit or
/// (floor + 1) 2^unit, the latter certainly if `is_upper`; if not `is_certain`, q must be compared with the middle.
struct RoundedQuotient {
  std::uint64_t floor = 0;
  std::int64_t unit = 0;
  bool is_upper = false;
  bool is_certain = true;
};

/// Of x 2^exponent / w, from the leading bits of x and w.
///
/// With x in [a, a + 1) 2^i and w in [c, c + 1) 2^j, a and c in [2^63, 2^64), Q = 2^63 (x 2^-i) / (w 2^-j) is below
/// (a + 1) 2^63 / c <= a 2^63 / c + 1 and at least a 2^63 / (c + 1) > a 2^63 / c - 2; so with q = floor(a 2^63 / c), in
/// [2^62, 2^64), Q lies in (q - 2, q + 2). At least 10 bits of q are beyond a double's precision: rounding is certain
/// unless their part is within 2 of its middle.
inline RoundedQuotient round_leading_bits(const LeadingBits& x, const LeadingBits& w, std::int64_t exponent) {
  using fixed_int_detail::UInt128;
  const auto q = static_cast<std::uint64_t>((static_cast<UInt128>(x.bits) << 63) / w.bits);
  const int length = 64 - std::countl_zero(q);
  const std::int64_t q_unit = x.exponent - w.exponent - 63 + exponent;
  const std::int64_t drop = std::max<std::int64_t>(length - 53, -1074 - q_unit);
  RoundedQuotient result;
  result.unit = q_unit + drop;
  if (drop >= length) {  // below 2^-1074, or within 2 units of it
    result.is_certain = drop > length + 2;
    return result;
  }
  const std::uint64_t rest = q & ((std::uint64_t{1} << drop) - 1);
  const std::uint64_t middle = std::uint64_t{1} << (drop - 1);
  result.floor = q >> drop;
  result.is_upper = rest > middle;
  result.is_certain = rest + 2 < middle || rest > middle + 2;
  return result;
}

/// Sign of x 2^shift - odd w for positive x and w and 0 < odd < 2^55, where both sides are within a factor of 16.
template <std::size_t N, std::size_t M>
Sign compare_multiple(const FixedInt<N>& x, std::int64_t shift, std::uint64_t odd, const FixedInt<M>& w) {
  constexpr std::size_t width = std::max(N, M + 1) + 1;
  FixedInt<width> left(x);
  FixedInt<width> right = multiply<width>(w, FixedInt<1>(static_cast<std::int64_t>(odd)));
  if (shift >= 0) {
    left = shift_left(left, static_cast<std::size_t>(shift));
  } else {
    right = shift_left(right, static_cast<std::size_t>(-shift));
  }
  return compare(left, right);
}

inline Sign compare_multiple(const Integer& x, std::int64_t shift, std::uint64_t odd, const Integer& w) {
  Integer left = x;
  Integer right = w * Integer(static_cast<std::int64_t>(odd));
  if (shift >= 0) {
    left <<= static_cast<std::size_t>(shift);
  } else {
    right <<= static_cast<std::size_t>(-shift);
  }
  return (left - right).sign();
}

/// The double nearest to x 2^exponent / w, ties to even, infinite beyond the largest one by half a unit; w > 0. +0 for
/// zero.
template <class X, class W>
double nearest_quotient(const X& x, const W& w, std::int64_t exponent) {
  if (x.sign() == Sign::zero) return 0;
  const RoundedQuotient q = round_leading_bits(leading_bits(x), leading_bits(w), exponent);
  bool up = q.is_upper;
  if (!q.is_certain) [[unlikely]] {
    // x 2^exponent / w against (floor + 1/2) 2^unit
    const X positive = x.sign() == Sign::negative ? -x : x;
    const Sign side = compare_multiple(positive, exponent - q.unit + 1, 2 * q.floor + 1, w);
    up = side == Sign::positive || (side == Sign::zero && (q.floor & 1) != 0);
  }
  const double size =
      scaled(static_cast<double>(static_cast<std::int64_t>(q.floor + static_cast<std::uint64_t>(up))), q.unit);
  return x.sign() == Sign::negative ? 0.0 - size : size;
}

/// mantissa 2^exponent, the mantissa of 53 bits (0 for 0).
struct Decoded {
  std::int64_t mantissa;
  int exponent;
};

inline Decoded decode(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {static_cast<std::int64_t>(fraction * 0x1p53), exponent - 53};
}

/// Whether `nearest`, which is nearest_quotient(x, w, exponent), is x 2^exponent / w itself.
template <class X, class W>
bool is_quotient(double nearest, const X& x, const W& w, std::int64_t exponent) {
  if (x.sign() == Sign::zero) return true;
  if (nearest == 0 || !std::isfinite(nearest)) return false;
  const Decoded size = decode(std::fabs(nearest));
  const X positive = x.sign() == Sign::negative ? -x : x;
  return compare_multiple(positive, exponent - size.exponent, static_cast<std::uint64_t>(size.mantissa), w) ==
         Sign::zero;
}

}  // namespace quoin::detail
