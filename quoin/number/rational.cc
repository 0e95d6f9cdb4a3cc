// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/rational.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/error.h"

namespace quoin {

Rational::Rational(const Integer& numerator, const Integer& denominator) : Rational() {
  if (denominator.sign() == Sign::zero) throw InputError("a denominator is zero");
  mpz_set(mpq_numref(value_), numerator.raw());
  mpz_set(mpq_denref(value_), denominator.raw());
  mpq_canonicalize(value_);
}

Rational Rational::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return Rational(Integer::parse(text));
  const Integer denominator = Integer::parse(text.substr(slash + 1));
  if (denominator.sign() == Sign::zero)
    throw InputError("a denominator is zero: '" + std::string(text.substr(0, 60)) + "'");
  return {Integer::parse(text.substr(0, slash)), denominator};
}

std::string Rational::to_string() const {
  const std::string p = numerator().to_string();
  const Integer q = denominator();
  return q == Integer(1) ? p : p + "/" + q.to_string();
}

Integer Rational::numerator() const {
  Integer result;
  mpz_set(result.raw(), mpq_numref(value_));
  return result;
}

Integer Rational::denominator() const {
  Integer result;
  mpz_set(result.raw(), mpq_denref(value_));
  return result;
}

double Rational::to_double() const {
  if (sign() == Sign::zero) return 0;
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

}  // namespace quoin
