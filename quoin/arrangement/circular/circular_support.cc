// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_support.h"

namespace quoin {
namespace {

/// The smallest common multiple.
Integer common_multiple(const Integer& a, const Integer& b) {
  Integer result;
  mpz_lcm(result.raw(), a.raw(), b.raw());
  return result;
}

/// value times scale, which is an integer.
Integer scaled(const Rational& value, const Integer& scale) {
  Integer result = value.numerator() * scale;
  mpz_divexact(result.raw(), result.raw(), value.denominator().raw());
  return result;
}

}  // namespace

HomogeneousCircle::HomogeneousCircle(const RationalCircle& circle)
    : w(common_multiple(circle.x.denominator(), circle.y.denominator())) {
  const Integer denominator = circle.squared_radius.denominator();
  if (mpz_divisible_p((w * w).raw(), denominator.raw()) == 0) w = common_multiple(w, denominator);
  x = scaled(circle.x, w);
  y = scaled(circle.y, w);
  square = scaled(circle.squared_radius, w * w);
}

HomogeneousLine::HomogeneousLine(const RationalLine& line)
    : w(common_multiple(common_multiple(line.x.denominator(), line.y.denominator()),
                        common_multiple(line.end_x.denominator(), line.end_y.denominator()))) {
  x = scaled(line.x, w);
  y = scaled(line.y, w);
  end_x = scaled(line.end_x, w);
  end_y = scaled(line.end_y, w);
}

HomogeneousPoint::HomogeneousPoint(const RationalPoint2& point)
    : w(common_multiple(point.x.denominator(), point.y.denominator())) {
  x = scaled(point.x, w);
  y = scaled(point.y, w);
}

RationalCircle CircularPools::exact_circle(std::uint32_t support) const {
  const CircularSupport& s = supports[support];
  if (s.form == CircularForm::rational_circle) {
    const HomogeneousCircle& c = circles[s.rational];
    return {Rational(c.x, c.w), Rational(c.y, c.w), Rational(c.square, c.w * c.w)};
  }
  if (s.form == CircularForm::squared_radius) return {s.x, s.y, s.squared_radius};
  return {s.x, s.y, Rational(s.radius) * Rational(s.radius)};
}

RationalLine CircularPools::exact_line(std::uint32_t support) const {
  const CircularSupport& s = supports[support];
  if (s.form == CircularForm::rational_line) {
    const HomogeneousLine& l = lines[s.rational];
    return {Rational(l.x, l.w), Rational(l.y, l.w), Rational(l.end_x, l.w), Rational(l.end_y, l.w)};
  }
  return {s.x, s.y, s.end_x, s.end_y};
}

RationalPoint2 CircularPools::exact_point(std::uint32_t rational) const {
  const HomogeneousPoint& p = points[rational];
  return {Rational(p.x, p.w), Rational(p.y, p.w)};
}

}  // namespace quoin
