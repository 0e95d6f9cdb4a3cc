// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/fixed_int.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace quoin {
namespace {

using Random = std::mt19937_64;

/// Random limbs with a bias to all zeros, all ones and single bits, where carries run far.
std::uint64_t extreme_limb(Random& random) {
  switch (random() % 6) {
    case 0:
      return 0;
    case 1:
      return ~std::uint64_t{0};
    case 2:
      return std::uint64_t{1} << (random() % 64);
    case 3:
      return ~(std::uint64_t{1} << (random() % 64));
    default:
      return random();
  }
}

template <std::size_t N>
FixedInt<N> extreme_number(Random& random) {
  FixedInt<N> result;
  for (std::size_t i = 0; i < N; ++i) result.set_limb(i, extreme_limb(random));
  return result;
}

/// value modulo 2^(64 limbs) in [-2^(64 limbs - 1), 2^(64 limbs - 1))
Integer wrapped(const Integer& value, std::size_t limbs) {
  const Integer modulus = Integer(1) << (64 * limbs);
  Integer result = value - ((value >> (64 * limbs)) << (64 * limbs));
  if (result >= modulus >> 1) result -= modulus;
  return result;
}

template <std::size_t N>
void check_linear(Random& random) {
  for (int i = 0; i < 300; ++i) {
    const auto a = extreme_number<N>(random);
    const auto b = random() % 8 == 0 ? a : extreme_number<N>(random);
    const Integer x = to_integer(a);
    const Integer y = to_integer(b);
    SCOPED_TRACE(x.to_string() + " and " + y.to_string());
    ASSERT_EQ(to_integer(a + b), wrapped(x + y, N));
    ASSERT_EQ(to_integer(a - b), wrapped(x - y, N));
    ASSERT_EQ(to_integer(-a), wrapped(-x, N));
    ASSERT_EQ(a.sign(), x.sign());
    ASSERT_EQ(a.is_negative(), x.sign() == Sign::negative);
    ASSERT_EQ(compare(a, b), (x - y).sign());
    ASSERT_EQ(a == b, x == y);
    const std::size_t bits = random() % (64 * N);
    ASSERT_EQ(to_integer(shift_left(a, bits)), wrapped(x << bits, N)) << bits;
    ASSERT_EQ(to_integer(FixedInt<N + 3>(a)), x);
    ASSERT_EQ(to_integer(FixedInt<(N + 1) / 2 + (N == 1)>(a)), wrapped(x, (N + 1) / 2 + (N == 1)));
  }
}

template <std::size_t R, std::size_t N, std::size_t M>
void check_product(Random& random) {
  for (int i = 0; i < 100; ++i) {
    const auto a = extreme_number<N>(random);
    const auto b = extreme_number<M>(random);
    SCOPED_TRACE(to_integer(a).to_string() + " times " + to_integer(b).to_string());
    ASSERT_EQ(to_integer(multiply<R>(a, b)), wrapped(to_integer(a) * to_integer(b), R)) << R << " " << N << " " << M;
  }
}

template <std::size_t N, std::size_t M>
void check_products(Random& random) {
  check_product<1, N, M>(random);
  check_product<N, N, M>(random);
  check_product<M, N, M>(random);
  check_product<N + M - 1, N, M>(random);
  check_product<N + M, N, M>(random);
  check_product<N + M + 1, N, M>(random);
  check_product<N + M + 3, N, M>(random);
}

template <std::size_t N>
void check_leading_bits(Random& random) {
  for (int i = 0; i < 300; ++i) {
    const auto a = extreme_number<N>(random);
    if (a.is_zero()) continue;
    const Integer x = abs(to_integer(a));
    SCOPED_TRACE(x.to_string());
    const LeadingBits leading = leading_bits(a);
    const LeadingBits same = leading_bits(x);
    ASSERT_NE(leading.bits >> 63, 0U);
    ASSERT_EQ(leading.bits, same.bits);
    ASSERT_EQ(leading.exponent, same.exponent);
    ASSERT_EQ(leading.sticky, same.sticky);
    ASSERT_EQ(leading.exponent, static_cast<std::int64_t>(x.bit_length()) - 64);
    // The 64 leading bits and whether anything follows them, by shifting.
    const Integer wide = x << 64;
    const Integer top = wide >> x.bit_length();
    Integer bits = Integer(static_cast<std::int64_t>(leading.bits >> 1));
    bits = (bits << 1) + Integer(static_cast<std::int64_t>(leading.bits & 1));
    ASSERT_EQ(bits, top);
    ASSERT_EQ(leading.sticky, (top << x.bit_length()) != wide);
    // The nearest 53-bit number: no farther than half a unit of 2^11, ties to even.
    const double mantissa = nearest_mantissa(leading);
    const Integer error = abs((Integer(mantissa) << x.bit_length()) - wide);
    const Integer half_unit = Integer(1024) << x.bit_length();
    ASSERT_LE(error, half_unit);
    if (error == half_unit) {
      ASSERT_EQ(std::fmod(mantissa * 0x1p-11, 2.0), 0.0);
    }
  }
}

TEST(FixedInt, LinearOperationsAgreeWithIntegersModuloTheWidth) {
  Random random(1);
  [&]<std::size_t... N>(std::index_sequence<N...>) {
    (check_linear<N + 1>(random), ...);
  }
  (std::make_index_sequence<26>());
}

TEST(FixedInt, ProductsOfAllWidthsAgreeWithIntegersModuloTheWidth) {
  Random random(2);
  [&]<std::size_t... N>(std::index_sequence<N...>) {
    (check_products<N + 1, 1>(random), ...);
    (check_products<N + 1, 2>(random), ...);
    (check_products<N + 1, 3>(random), ...);
    (check_products<2, N + 1>(random), ...);
    (check_products<N + 1, N + 1>(random), ...);
  }
  (std::make_index_sequence<9>());
  check_products<14, 12>(random);
  check_products<14, 4>(random);
  check_products<8, 8>(random);
  check_products<6, 12>(random);
  check_product<26, 14, 12>(random);
  check_product<18, 12, 6>(random);
}

TEST(FixedInt, LeadingBitsAreThoseOfTheMagnitude) {
  Random random(3);
  [&]<std::size_t... N>(std::index_sequence<N...>) {
    (check_leading_bits<N + 1>(random), ...);
  }
  (std::make_index_sequence<14>());
}

TEST(FixedInt, ExtremeOperands) {
  const FixedInt<1> least(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(to_integer(multiply<2>(least, least)), Integer(1) << 126);
  EXPECT_EQ(leading_bits(least).bits, std::uint64_t{1} << 63);
  EXPECT_EQ(leading_bits(least).exponent, 0);
  EXPECT_FALSE(leading_bits(least).sticky);
  FixedInt<2> low;
  low.set_limb(1, std::uint64_t{1} << 63);
  EXPECT_EQ(to_integer(multiply<4>(low, low)), Integer(1) << 254);
  EXPECT_EQ(compare(low, FixedInt<2>(0)), Sign::negative);
  EXPECT_EQ(compare(FixedInt<2>(0), low), Sign::positive);
  EXPECT_EQ(FixedInt<3>(-1).sign(), Sign::negative);
  EXPECT_EQ(FixedInt<3>(0).sign(), Sign::zero);
  EXPECT_EQ(FixedInt<3>(FixedInt<1>(-5)), FixedInt<3>(-5));
}

}  // namespace
}  // namespace quoin
