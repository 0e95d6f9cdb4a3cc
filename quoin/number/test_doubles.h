// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

/// Families of doubles for tests of numbers and predicates.
namespace quoin::testing {

using Random = std::mt19937_64;

/// Every finite double with the same chance: exponents over the whole range, subnormals and both zeros among them.
inline double any_finite(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

/// Both signs, full mantissas, exponents drawn from [least, most].
inline double with_exponent(Random& random, int least, int most) {
  const int exponent = std::uniform_int_distribution<int>(least, most)(random);
  const double mantissa = std::uniform_real_distribution<double>(1, 2)(random);
  return std::ldexp((random() & 1) != 0 ? mantissa : -mantissa, exponent);
}

/// A small integer of magnitude at most `size`.
inline double small_integer(Random& random, int size) {
  return std::uniform_int_distribution<int>(-size, size)(random);
}

/// What sums and products go wrong at: powers of two and their neighbours, the ends of the range, halves of an ulp.
inline double awkward(Random& random) {
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return std::ldexp(1.0, static_cast<int>(random() % 2046) - 1022);
    case 2:
      return std::nextafter(std::ldexp(1.0, static_cast<int>(random() % 2046) - 1022), 0.0);
    case 3:
      return -0x1.fffffffffffffp1023;
    case 4:
      return 0x1.fffffffffffffp1023;
    case 5:
      return std::ldexp(small_integer(random, 8), -1074);
    case 6:
      return with_exponent(random, -60, 60);
    default:
      return any_finite(random);
  }
}

}  // namespace quoin::testing
