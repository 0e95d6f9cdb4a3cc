// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmp.h>

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "quoin/base/sign.h"
#include "quoin/number/integer.h"

namespace quoin {

/// A rational number, always in lowest terms with a positive denominator; a value type over GMP's mpq.
class Rational {
 public:
  Rational() { mpq_init(value_); }
  Rational(std::int64_t value) : Rational() { mpq_set_si(value_, value, 1); }  // NOLINT(google-explicit-constructor)
  Rational(int value) : Rational(static_cast<std::int64_t>(value)) {}          // NOLINT(google-explicit-constructor)
  /// Exact; the value must be finite.
  Rational(double value) : Rational() { mpq_set_d(value_, value); }  // NOLINT(google-explicit-constructor)
  // NOLINTNEXTLINE(google-explicit-constructor)
  Rational(const Integer& value) : Rational() { mpq_set_z(value_, value.raw()); }
  /// The denominator must not be zero.
  Rational(const Integer& numerator, const Integer& denominator);
  Rational(const Rational& other) : Rational() { mpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { mpq_swap(value_, other.value_); }
  Rational& operator=(const Rational& other) {
    mpq_set(value_, other.value_);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    mpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { mpq_clear(value_); }

  /// "p" or "p/q" in decimal digits with an optional sign. @throws InputError on anything else or q = 0
  static Rational parse(std::string_view text);
  /// "p" or "p/q".
  std::string to_string() const;

  Sign sign() const { return static_cast<Sign>(mpq_sgn(value_)); }
  Integer numerator() const;
  Integer denominator() const;
  /// The nearest double, ties to even; infinity beyond the largest one by half a unit or more.
  double to_double() const;

  Rational& operator+=(const Rational& other) { return mpq_add(value_, value_, other.value_), *this; }
  Rational& operator-=(const Rational& other) { return mpq_sub(value_, value_, other.value_), *this; }
  Rational& operator*=(const Rational& other) { return mpq_mul(value_, value_, other.value_), *this; }
  /// The divisor must not be zero.
  Rational& operator/=(const Rational& other) { return mpq_div(value_, value_, other.value_), *this; }
  Rational operator-() const {
    Rational result(*this);
    mpq_neg(result.value_, result.value_);
    return result;
  }
  friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
  friend Rational abs(Rational a) {
    mpq_abs(a.value_, a.value_);
    return a;
  }

  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.value_, b.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return mpq_cmp(a.value_, b.value_) <=> 0;
  }

  mpq_srcptr raw() const { return value_; }
  mpq_ptr raw() { return value_; }

 private:
  mpq_t value_;
};

}  // namespace quoin
