// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/kernel/point.h"
#include "quoin/number/rational.h"

/// Exact formulas of lines through two points and of their crossings, for any number type.
///
/// A line through a and b with d = b - a is dy x - dx y = k, k = ax dy - ay dx; coordinates are relative to an origin,
/// so that all are differences of input coordinates, of 2^(B + 1) at most. Bits of the largest magnitude: k 2B + 3, a
/// crossing's weight 2B + 3 and coordinates 3B + 5, order along x 5B + 9, side of a crossing 4B + 10: within
/// CallNumbers<B>.
namespace quoin::detail {

template <class N>
struct ExactLine {
  typename N::Linear ax, ay, dx, dy;
};

/// (x / w, y / w), w > 0.
template <class N>
struct ExactPoint {
  typename N::Cubic x, y;
  typename N::Quadratic w;
};

template <class N>
ExactPoint<N> exact_point(const typename N::Linear& x, const typename N::Linear& y) {
  return {typename N::Cubic(x), typename N::Cubic(y), typename N::Quadratic(1)};
}

template <class N>
ExactPoint<N> exact_crossing(const ExactLine<N>& s, const ExactLine<N>& t) {
  using Quadratic = typename N::Quadratic;
  using Cubic = typename N::Cubic;
  const Quadratic ks = cross<Quadratic>(s.ax, s.ay, s.dx, s.dy);
  const Quadratic kt = cross<Quadratic>(t.ax, t.ay, t.dx, t.dy);
  ExactPoint<N> result{product<Cubic>(s.dx, kt) - product<Cubic>(t.dx, ks),
                       product<Cubic>(s.dy, kt) - product<Cubic>(t.dy, ks), cross<Quadratic>(s.dx, s.dy, t.dx, t.dy)};
  if (result.w.sign() == Sign::negative) result = {-result.x, -result.y, -result.w};
  return result;
}

/// Order of p and q by x, or by y.
template <class N>
Sign compare_coordinate(const ExactPoint<N>& p, const ExactPoint<N>& q, bool by_y) {
  using Quintic = typename N::Quintic;
  return (product<Quintic>(by_y ? p.y : p.x, q.w) - product<Quintic>(by_y ? q.y : q.x, p.w)).sign();
}

/// Positive: p lies to the left of the line, that is above it if dx > 0.
template <class N>
Sign side_of_line(const ExactPoint<N>& p, const ExactLine<N>& line) {
  using Cubic = typename N::Cubic;
  using Quartic = typename N::Quartic;
  const Cubic x = p.x - product<Cubic>(line.ax, p.w);
  const Cubic y = p.y - product<Cubic>(line.ay, p.w);
  return (product<Quartic>(line.dx, y) - product<Quartic>(line.dy, x)).sign();
}

/// numerator / denominator times 2^exponent, off by 2^-51 of its size at most; the largest double instead of infinity.
template <class Numerator, class Denominator>
double rounded_quotient(const Numerator& numerator, const Denominator& denominator, int exponent) {
  if (numerator.sign() == Sign::zero) return 0;
  const LeadingBits n = leading_bits(numerator);
  const LeadingBits d = leading_bits(denominator);
  const double size =
      std::ldexp(nearest_mantissa(n) / nearest_mantissa(d), static_cast<int>(n.exponent - d.exponent) + exponent);
  const double clamped = std::min(size, std::numeric_limits<double>::max());
  return numerator.sign() == denominator.sign() ? clamped : -clamped;
}

inline double clamped_double(const Rational& value) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(value.to_double(), -largest, largest);
}

}  // namespace quoin::detail
