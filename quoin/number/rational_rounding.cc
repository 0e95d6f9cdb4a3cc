// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "quoin/number/fixed_int.h"
#include "quoin/number/rational.h"
#include "quoin/number/two_doubles.h"

namespace quoin {

namespace {

/// The exponent of a power of two.
std::optional<std::int64_t> exponent_of_power(mpz_srcptr q) {
  const mp_bitcnt_t zeros = mpz_scan1(q, 0);
  if (mpz_sizeinbase(q, 2) != zeros + 1) return std::nullopt;
  return static_cast<std::int64_t>(zeros);
}

/// Whether numbers whose leading bits have this exponent are normal doubles, rounded or not.
bool is_normal(std::int64_t exponent) {
  return exponent >= -1022 - 63 && exponent < 1023 - 64;
}

double with_sign_of(mpz_srcptr p, double magnitude) {
  return mpz_sgn(p) < 0 ? -magnitude : magnitude;
}

/// Of p/2^k that is not zero, if it is well within the range of doubles; no division and no copy.
std::optional<double> nearest_dyadic(mpq_srcptr value) {
  const std::optional<std::int64_t> k = exponent_of_power(mpq_denref(value));
  if (!k) return std::nullopt;
  const LeadingBits leading = leading_bits(mpq_numref(value));
  const std::int64_t exponent = leading.exponent - *k;
  if (!is_normal(exponent)) return std::nullopt;
  return with_sign_of(mpq_numref(value), std::ldexp(nearest_mantissa(leading), static_cast<int>(exponent)));
}

/// r/2^k, if that is a double well within their range.
std::optional<double> exact_dyadic(mpz_srcptr r, std::int64_t k) {
  if (mpz_sgn(r) == 0) return 0.0;
  const LeadingBits leading = leading_bits(r);
  const std::int64_t exponent = leading.exponent - k;
  constexpr std::uint64_t beyond_double = (1U << 11U) - 1;
  if (leading.sticky || (leading.bits & beyond_double) != 0 || !is_normal(exponent)) return std::nullopt;
  return with_sign_of(r, std::ldexp(nearest_mantissa(leading), static_cast<int>(exponent)));
}

std::optional<TwoDoubles> as_two_doubles_anywhere(const Rational& value) {
  const double high = value.to_double();
  if (!std::isfinite(high)) return std::nullopt;
  const Rational rest = value - Rational(high);
  const double tail = rest.to_double();
  if (!std::isfinite(tail) || Rational(tail) != rest) return std::nullopt;
  return TwoDoubles{high, tail};
}

}  // namespace

double Rational::to_double() const {
  if (sign() == Sign::zero) return 0;
  if (const std::optional<double> quick = nearest_dyadic(value_)) return *quick;
  Integer p = abs(numerator());
  Integer q = denominator();
  // Scale so that the quotient has the bits a double of its size has: 53, or fewer for subnormals.
  const auto size =
      static_cast<long>(p.bit_length()) - static_cast<long>(q.bit_length());  // 2^(size-1) < p/q < 2^(size+1)
  long exponent = std::max(size - 54, -1074L);
  if (exponent >= 0) {
    q <<= static_cast<std::size_t>(exponent);
  } else {
    p <<= static_cast<std::size_t>(-exponent);
  }
  Integer quotient;
  Integer rest;
  mpz_tdiv_qr(quotient.raw(), rest.raw(), p.raw(), q.raw());
  // At most 55 bits: drop those beyond 53 into a sticky remainder, unless the lowest place is that of subnormals.
  bool sticky = rest.sign() != Sign::zero;
  Sign half = Sign::zero;  // the dropped part against one half unit
  const std::size_t bits = quotient.bit_length();
  if (bits > 53) {
    const std::size_t drop = bits - 53;
    Integer low;
    mpz_tdiv_r_2exp(low.raw(), quotient.raw(), drop);
    const Integer middle = Integer(1) << (drop - 1);
    half = low == middle ? (sticky ? Sign::positive : Sign::zero) : low > middle ? Sign::positive : Sign::negative;
    quotient >>= drop;
    exponent += static_cast<long>(drop);
  } else {
    const Integer twice = rest << 1;
    half = twice == q ? Sign::zero : twice > q ? Sign::positive : Sign::negative;
  }
  const bool odd = mpz_odd_p(quotient.raw()) != 0;
  if (half == Sign::positive || (half == Sign::zero && odd)) quotient += Integer(1);
  const double magnitude = std::ldexp(mpz_get_d(quotient.raw()), static_cast<int>(std::min(exponent, 4000L)));
  return sign() == Sign::negative ? -magnitude : magnitude;
}

std::optional<TwoDoubles> as_two_doubles(const Rational& value) {
  if (value.sign() == Sign::zero) return TwoDoubles{0, 0};
  const std::optional<std::int64_t> k = exponent_of_power(mpq_denref(value.raw()));
  const std::optional<double> high = nearest_dyadic(value.raw());
  if (!k || !high) return as_two_doubles_anywhere(value);
  // The value is p/2^k; `high`, an odd m times 2^e, is of no smaller unit.
  int e = 0;
  auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(*high, &e), 53));
  e -= 53;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(m));
  m >>= zeros;
  Integer rest(m);
  rest <<= static_cast<std::size_t>(e + zeros + *k);
  mpz_sub(rest.raw(), mpq_numref(value.raw()), rest.raw());
  const std::optional<double> tail = exact_dyadic(rest.raw(), *k);
  if (!tail) return as_two_doubles_anywhere(value);
  return TwoDoubles{*high, *tail};
}

}  // namespace quoin
