// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmp.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "quoin/base/sign.h"

namespace quoin {

/// An integer of any size; a value type over GMP's mpz.
class Integer {
 public:
  Integer() noexcept { mpz_init(value_); }
  Integer(std::int64_t value) { mpz_init_set_si(value_, value); }    // NOLINT(google-explicit-constructor)
  Integer(int value) : Integer(static_cast<std::int64_t>(value)) {}  // NOLINT(google-explicit-constructor)
  /// A finite double without fraction; the fraction of others is cut off.
  explicit Integer(double value) { mpz_init_set_d(value_, value); }
  Integer(const Integer& other) { mpz_init_set(value_, other.value_); }
  Integer(Integer&& other) noexcept : Integer() { mpz_swap(value_, other.value_); }
  Integer& operator=(const Integer& other) {
    mpz_set(value_, other.value_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    mpz_swap(value_, other.value_);
    return *this;
  }
  ~Integer() { mpz_clear(value_); }

  /// Decimal digits with an optional sign. @throws InputError on anything else
  static Integer parse(std::string_view text);
  std::string to_string() const;

  Sign sign() const { return static_cast<Sign>(mpz_sgn(value_)); }
  /// Bits of the magnitude; 0 for zero.
  std::size_t bit_length() const { return sign() == Sign::zero ? 0 : mpz_sizeinbase(value_, 2); }
  /// Number of zero bits below the lowest set bit; 0 for zero.
  std::size_t trailing_zeros() const { return sign() == Sign::zero ? 0 : mpz_scan1(value_, 0); }

  Integer& operator+=(const Integer& other) { return mpz_add(value_, value_, other.value_), *this; }
  Integer& operator-=(const Integer& other) { return mpz_sub(value_, value_, other.value_), *this; }
  Integer& operator*=(const Integer& other) { return mpz_mul(value_, value_, other.value_), *this; }
  /// Multiplied by 2^bits.
  Integer& operator<<=(std::size_t bits) { return mpz_mul_2exp(value_, value_, bits), *this; }
  /// Divided by 2^bits, rounded down.
  Integer& operator>>=(std::size_t bits) { return mpz_fdiv_q_2exp(value_, value_, bits), *this; }
  Integer operator-() const {
    Integer result(*this);
    mpz_neg(result.value_, result.value_);
    return result;
  }
  friend Integer operator+(Integer a, const Integer& b) { return std::move(a += b); }
  friend Integer operator-(Integer a, const Integer& b) { return std::move(a -= b); }
  friend Integer operator*(Integer a, const Integer& b) { return std::move(a *= b); }
  friend Integer operator<<(Integer a, std::size_t bits) { return std::move(a <<= bits); }
  friend Integer operator>>(Integer a, std::size_t bits) { return std::move(a >>= bits); }
  /// a / b rounded down; b is not zero.
  friend Integer floor_quotient(const Integer& a, const Integer& b) {
    Integer result;
    mpz_fdiv_q(result.value_, a.value_, b.value_);
    return result;
  }
  friend Integer abs(Integer a) {
    mpz_abs(a.value_, a.value_);
    return a;
  }

  friend bool operator==(const Integer& a, const Integer& b) { return mpz_cmp(a.value_, b.value_) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return mpz_cmp(a.value_, b.value_) <=> 0;
  }

  mpz_srcptr raw() const { return value_; }
  mpz_ptr raw() { return value_; }

 private:
  mpz_t value_;
};

}  // namespace quoin
