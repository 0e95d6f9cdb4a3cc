// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/rational.h"

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

}  // namespace quoin
