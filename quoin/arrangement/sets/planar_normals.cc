// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_normals.h"

#include <algorithm>
#include <utility>

namespace quoin::planar {

namespace {

/// A vector of integers in a given direction, as short as possible, and how it lies in its octant.
struct Octant {
  Integer large;  // the larger of both magnitudes
  Integer small;
  Integer square;  // of the length
  bool is_steep;   // y is the larger one
  bool x_negative;
  bool y_negative;

  explicit Octant(const RationalPoint2& vector) {
    Integer x = vector.x.numerator() * vector.y.denominator();
    Integer y = vector.y.numerator() * vector.x.denominator();
    Integer divisor;
    mpz_gcd(divisor.raw(), x.raw(), y.raw());
    mpz_divexact(x.raw(), x.raw(), divisor.raw());
    mpz_divexact(y.raw(), y.raw(), divisor.raw());
    square = x * x + y * y;
    x_negative = x.sign() == Sign::negative;
    y_negative = y.sign() == Sign::negative;
    large = abs(std::move(x));
    small = abs(std::move(y));
    is_steep = small > large;
    if (is_steep) std::swap(large, small);
  }
  /// (along, across) of the octant in the plane.
  RationalPoint2 placed(const Rational& along, const Rational& across) const {
    const Rational& x = is_steep ? across : along;
    const Rational& y = is_steep ? along : across;
    return {x_negative ? -x : x, y_negative ? -y : y};
  }
  /// Turned from the axis by twice the angle with the tangent t / 2^bits.
  RationalPoint2 unit(const Integer& t, std::size_t bits) const {
    const Integer one = Integer(1) << (2 * bits);
    const Integer length = one + t * t;
    return placed(Rational(one - t * t, length), Rational(t << (bits + 1), length));
  }
  /// Neighbouring integers around 2^bits small / (large + length): the tangent of half the angle from the axis.
  std::pair<Integer, Integer> half_tangents(std::size_t bits) const {
    const std::size_t extra = bits + 2;
    Integer root = square << (2 * extra);
    mpz_sqrt(root.raw(), root.raw());
    Integer low = small << (bits + extra);
    Integer high = low;
    const Integer least = (large << extra) + root;  // the length's 2^extra-fold is in [root, root + 1)
    const Integer most = least + Integer(1);
    mpz_fdiv_q(low.raw(), low.raw(), most.raw());
    mpz_cdiv_q(high.raw(), high.raw(), least.raw());
    return {low, high};
  }
};

bool is_close(const RationalPoint2& unit, const RationalPoint2& vector, const Rational& cosine) {
  const Rational along = unit.x * vector.x + unit.y * vector.y;
  return along.sign() == Sign::positive &&
         along * along >= cosine * cosine * (vector.x * vector.x + vector.y * vector.y);
}

}  // namespace

UnitBracket unit_bracket(const RationalPoint2& vector, const Rational& cosine) {
  const Octant octant(vector);
  if (mpz_perfect_square_p(octant.square.raw()) != 0) {
    Integer length;
    mpz_sqrt(length.raw(), octant.square.raw());
    const RationalPoint2 unit = octant.placed(Rational(octant.large, length), Rational(octant.small, length));
    return {unit, unit, true};
  }
  const Rational gap = Rational(1) - cosine;
  const std::size_t gap_bits =
      gap.denominator().bit_length() - std::min(gap.denominator().bit_length() - 1, gap.numerator().bit_length());
  for (std::size_t bits = gap_bits / 2 + 1;; ++bits) {
    const auto [low, high] = octant.half_tangents(bits);
    UnitBracket result{octant.unit(low, bits), octant.unit(high, bits), false};
    if (!is_close(result.clockwise, vector, cosine) || !is_close(result.counterclockwise, vector, cosine)) continue;
    const Rational turn = result.clockwise.x * vector.y - result.clockwise.y * vector.x;
    if (turn.sign() == Sign::negative) std::swap(result.clockwise, result.counterclockwise);
    return result;
  }
}

}  // namespace quoin::planar
