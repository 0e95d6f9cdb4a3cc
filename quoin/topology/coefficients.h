// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/base/error.h"
#include "quoin/number/integer.h"

/// Rings in which columns are reduced: entries of boundaries are 1 and -1, and a pivot is a unit.
namespace quoin::coefficients {

/// Integers modulo 2: an entry is there or not.
struct Two {
  struct Value {};
};

/// Integers modulo a prime below 2^31.
class Prime {
 public:
  using Value = std::uint32_t;
  explicit Prime(std::uint32_t p) : p_(p) {}

  Value of_sign(int sign) const { return sign > 0 ? 1 : p_ - 1; }
  static bool is_zero(Value a) { return a == 0; }
  static bool is_unit(Value a) { return a != 0; }
  /// The f with a + f b = 0, of a unit b.
  Value annihilator(Value a, Value b) const { return times(p_ - a, inverse(b)); }
  void add_multiple(Value& a, Value f, Value b) const {
    a = static_cast<Value>((a + static_cast<std::uint64_t>(f) * b) % p_);
  }

 private:
  Value times(Value a, Value b) const { return static_cast<Value>(static_cast<std::uint64_t>(a) * b % p_); }
  Value inverse(Value a) const {  // a^(p - 2)
    Value result = 1;
    for (std::uint32_t e = p_ - 2; e > 0; e >>= 1) {
      if ((e & 1) != 0) result = times(result, a);
      a = times(a, a);
    }
    return result;
  }

  std::uint32_t p_;
};

/// An integer did not fit into 64 bits; the caller starts again with those of any size.
class Overflow : public Error {
 public:
  Overflow() : Error("an integer does not fit into 64 bits") {}
};

/// Integers of 64 bits. @throws Overflow
struct Narrow {
  using Value = std::int64_t;
  static Value of_sign(int sign) { return sign; }
  static bool is_zero(Value a) { return a == 0; }
  static bool is_unit(Value a) { return a == 1 || a == -1; }
  static Value annihilator(Value a, Value b) {
    if (a == INT64_MIN) throw Overflow();
    return b > 0 ? -a : a;
  }
  static void add_multiple(Value& a, Value f, Value b) {
    Value product = 0;
    if (__builtin_mul_overflow(f, b, &product) || __builtin_add_overflow(a, product, &a)) throw Overflow();
  }
};

/// Integers of any size.
struct Wide {
  using Value = Integer;
  static Value of_sign(int sign) { return {sign}; }
  static bool is_zero(const Value& a) { return a.sign() == Sign::zero; }
  static bool is_unit(const Value& a) { return a == Integer(1) || a == Integer(-1); }
  static Value annihilator(const Value& a, const Value& b) { return b.sign() == Sign::positive ? -a : a; }
  static void add_multiple(Value& a, const Value& f, const Value& b) { a += f * b; }
};

}  // namespace quoin::coefficients
