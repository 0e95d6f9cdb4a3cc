// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/one_root.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "quoin/number/bounded_int.h"

namespace quoin {
namespace {

using Random = std::mt19937_64;

/// floor and ceiling of sqrt(value) 2^bits
std::pair<Integer, Integer> root_bounds(const Integer& value, std::size_t bits) {
  const Integer scaled = value << (2 * bits);
  std::pair<Integer, Integer> result;
  mpz_sqrt(result.first.raw(), scaled.raw());
  result.second = result.first * result.first == scaled ? result.first : result.first + Integer(1);
  return result;
}

/// Sign of a + b sqrt c - e sqrt f by enclosures of more and more bits. The product of the number and its conjugates is
/// an integer, so that it is zero, or at least one over the product of the others: enough bits separate it from zero.
Sign enclosed_sign(const Integer& a, const Integer& b, const Integer& c, const Integer& e, const Integer& f) {
  for (std::size_t bits = 16;; bits *= 2) {
    const auto term = [&](const Integer& factor, const Integer& radicand) {
      const auto [low, high] = root_bounds(radicand, bits);
      return factor.sign() == Sign::negative ? std::pair(factor * high, factor * low)
                                             : std::pair(factor * low, factor * high);
    };
    const auto [b_low, b_high] = term(b, c);
    const auto [e_low, e_high] = term(-e, f);
    const Integer low = (a << bits) + b_low + e_low;
    const Integer high = (a << bits) + b_high + e_high;
    if (low.sign() == Sign::positive) return Sign::positive;
    if (high.sign() == Sign::negative) return Sign::negative;
    if (low.sign() == Sign::zero && high.sign() == Sign::zero) return Sign::zero;
    const std::size_t size =
        2 + std::max({a.bit_length(), b.bit_length() + c.bit_length(), e.bit_length() + f.bit_length()});
    if (bits > 4 * size + 64) return Sign::zero;  // |value| < 2^-bits 2^(size), below 2^(-3 size)
  }
}

template <std::size_t B>
struct Numbers {
  BoundedInt<B> a, b, c, e, f;
};

std::int64_t draw(Random& random, int bits) {
  const auto value = static_cast<std::int64_t>(random() >> (64 - bits));
  return random() % 2 == 0 ? value : -value;
}

/// With a bias to small numbers, squares, multiples by squares, and sums that cancel.
template <std::size_t B>
Numbers<B> numbers(Random& random) {
  const int bits = random() % 2 == 0 ? 3 : static_cast<int>(B) / 2 - 1;
  std::int64_t a = draw(random, bits);
  std::int64_t b = draw(random, bits);
  std::int64_t c = std::abs(draw(random, bits));
  const std::int64_t e = draw(random, bits);
  std::int64_t f = std::abs(draw(random, bits));
  if (random() % 3 == 0) c = std::abs(draw(random, bits / 2)) * std::abs(draw(random, bits / 2));
  if (random() % 3 == 0) {
    const std::int64_t root = std::abs(draw(random, bits / 2));
    c = root * root;
    if (random() % 2 == 0) {
      b = draw(random, bits / 2);
      a = -b * root + draw(random, 1);
    }
  }
  if (random() % 3 == 0) f = c;
  return {BoundedInt<B>(a), BoundedInt<B>(b), BoundedInt<B>(c), BoundedInt<B>(random() % 4 == 0 ? b : e),
          BoundedInt<B>(f)};
}

template <std::size_t B>
void check_signs(Random& random) {
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const Numbers<B> n = numbers<B>(random);
    const Integer a = to_integer(n.a.limbs());
    const Integer b = to_integer(n.b.limbs());
    const Integer c = to_integer(n.c.limbs());
    const Integer e = to_integer(n.e.limbs());
    const Integer f = to_integer(n.f.limbs());
    SCOPED_TRACE(a.to_string() + " + " + b.to_string() + " sqrt " + c.to_string() + " - " + e.to_string() + " sqrt " +
                 f.to_string());
    const Sign one = enclosed_sign(a, b, c, Integer(), Integer());
    ASSERT_EQ(sign_of_one_root(n.a, n.b, n.c), one);
    ASSERT_EQ(sign_of_one_root(Rational(a), Rational(b), Rational(c)), one);
    const Sign two = enclosed_sign(a, b, c, e, f);
    ASSERT_EQ(sign_of_two_roots(n.a, n.b, n.c, n.e, n.f), two);
    ASSERT_EQ(sign_of_two_roots(Rational(a), Rational(b), Rational(c), Rational(e), Rational(f)), two);
    zeros += two == Sign::zero ? 1 : 0;
  }
  EXPECT_GT(zeros, 200);
}

TEST(OneRoot, SignsAgreeWithEnclosures) {
  Random random(1);
  check_signs<20>(random);
  check_signs<62>(random);
  check_signs<100>(random);
}

TEST(OneRoot, OrderIsAntisymmetricAndTransitive) {
  Random random(2);
  using Number = OneRoot<BoundedInt<20>, BoundedInt<20>, BoundedInt<20>>;
  for (int i = 0; i < 20000; ++i) {
    Number numbers[3];
    BoundedInt<20> radicands[3];
    for (int k = 0; k < 3; ++k) {
      numbers[k] = {BoundedInt<20>(draw(random, 3)), BoundedInt<20>(draw(random, 2)),
                    BoundedInt<20>(1 + std::abs(draw(random, 2)))};
      radicands[k] = BoundedInt<20>(std::abs(draw(random, 3)));
    }
    const auto order = [&](int j, int k) {
      return compare_one_root(numbers[j], radicands[j], numbers[k], radicands[k]);
    };
    for (int j = 0; j < 3; ++j) {
      ASSERT_EQ(order(j, j), Sign::zero);
      for (int k = 0; k < 3; ++k) ASSERT_EQ(order(j, k), -order(k, j));
    }
    if (order(0, 1) != Sign::positive && order(1, 2) != Sign::positive) {
      ASSERT_NE(order(0, 2), Sign::positive);
      ASSERT_EQ(order(0, 2) == Sign::zero, order(0, 1) == Sign::zero && order(1, 2) == Sign::zero);
    }
  }
}

TEST(BoundedInt, SumsAndProductsAreExactAtTheirBounds) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t top = (std::int64_t{1} << 40) - 1;
    const std::int64_t x = i % 3 == 0 ? top : draw(random, 40);
    const std::int64_t y = i % 5 == 0 ? -top : draw(random, 40);
    const BoundedInt<40> a(x);
    const BoundedInt<40> b(y);
    const auto product = a * b;
    ASSERT_EQ(to_integer(product.limbs()), Integer(x) * Integer(y));
    ASSERT_EQ(to_integer((product * product * a).limbs()),
              Integer(x) * Integer(y) * Integer(x) * Integer(y) * Integer(x));
    ASSERT_EQ(to_integer((product + product).limbs()), Integer(x) * Integer(y) * Integer(2));
    ASSERT_EQ(to_integer((product - a).limbs()), Integer(x) * Integer(y) - Integer(x));
    ASSERT_EQ(to_double(product), Rational(Integer(x) * Integer(y)).to_double());
  }
}

}  // namespace
}  // namespace quoin
