// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "quoin/arrangement/circular/circular_support.h"
#include "quoin/number/one_root.h"

/// The formulas of the exact tier, for every arithmetic. Bits are derived by BoundedInt; the types of `IntegersOf` name
/// the widest result of each kind, which the compiler checks by widening.
///
/// Circles (x1, y1, r1) and (x2, y2, r2), d = c2 - c1, k = d.d + r1^2 - r2^2: they meet at
///   c1 + (k d +- sqrt(D) d') / (2 d.d),  D = 4 d.d r1^2 - k^2,  d' = d turned by 90 degrees.
/// Circle and line (p, e), w = c - p, n = e x w: they meet at
///   c + (n (e.y, -e.x) +- sqrt(D) e) / e.e,  D = r^2 e.e - n^2.
namespace quoin::circular_exact {

/// Integers of coordinates below 2^B.
template <std::size_t B>
struct IntegersOf {
  using Coordinate = BoundedInt<B>;
  using SquaredRadius = BoundedInt<2 * B>;
  using Numerator = BoundedInt<3 * B + 6>;
  using Factor = BoundedInt<B + 2>;
  using Denominator = BoundedInt<2 * B + 4>;
  using Radicand = BoundedInt<4 * B + 9>;
};

/// Integers of any size.
struct Integers {
  using Coordinate = Integer;
  using SquaredRadius = Integer;
  using Numerator = Integer;
  using Factor = Integer;
  using Denominator = Integer;
  using Radicand = Integer;
};

template <class Numbers>
struct ExactCircle {
  typename Numbers::Coordinate x;
  typename Numbers::Coordinate y;
  typename Numbers::SquaredRadius squared_radius;
};

template <class Numbers>
struct ExactLine {
  typename Numbers::Coordinate x;
  typename Numbers::Coordinate y;
  typename Numbers::Coordinate end_x;
  typename Numbers::Coordinate end_y;
};

/// ((ax + bx sqrt c) / d, (ay + by sqrt c) / d), d > 0, c >= 0.
template <class Numbers>
struct ExactPoint {
  typename Numbers::Numerator ax;
  typename Numbers::Numerator ay;
  typename Numbers::Factor bx;
  typename Numbers::Factor by;
  typename Numbers::Radicand c;
  typename Numbers::Denominator d;
};

/// Where two supports meet: the points with both signs of the factors, which are lexicographically positive. Where the
/// radicand is negative there is none; where the denominator is zero the supports are concentric or parallel.
template <class Numbers>
ExactPoint<Numbers> meet(const ExactCircle<Numbers>& one, const ExactCircle<Numbers>& two) {
  const auto dx = two.x - one.x;
  const auto dy = two.y - one.y;
  const auto d2 = dx * dx + dy * dy;
  const auto twice = d2 + d2;
  const auto k = d2 + (one.squared_radius - two.squared_radius);
  const bool flip = dy.sign() == Sign::positive || (dy.sign() == Sign::zero && dx.sign() == Sign::negative);
  return {one.x * twice + k * dx,
          one.y * twice + k * dy,
          flip ? dy : -dy,
          flip ? -dx : dx,
          twice * (one.squared_radius + one.squared_radius) - k * k,
          twice};
}

template <class Numbers>
ExactPoint<Numbers> meet(const ExactCircle<Numbers>& circle, const ExactLine<Numbers>& line) {
  const auto dx = line.end_x - line.x;
  const auto dy = line.end_y - line.y;
  const auto n = dx * (circle.y - line.y) - dy * (circle.x - line.x);
  const auto d2 = dx * dx + dy * dy;
  return {circle.x * d2 + n * dy, circle.y * d2 - n * dx, dx, dy, circle.squared_radius * d2 - n * n, d2};
}

template <class Numbers>
ExactPoint<Numbers> meet(const ExactLine<Numbers>& line, const ExactCircle<Numbers>& circle) {
  return meet(circle, line);
}

template <class Numbers>
ExactPoint<Numbers> meet(const ExactLine<Numbers>& one, const ExactLine<Numbers>& two) {
  const auto dx = one.end_x - one.x;
  const auto dy = one.end_y - one.y;
  const auto ex = two.end_x - two.x;
  const auto ey = two.end_y - two.y;
  auto d = dx * ey - dy * ex;
  auto n = (two.x - one.x) * ey - (two.y - one.y) * ex;
  if (d.sign() == Sign::negative) {
    d = -d;
    n = -n;
  }
  using Factor = typename Numbers::Factor;
  return {one.x * d + n * dx, one.y * d + n * dy, Factor(0), Factor(0), typename Numbers::Radicand(0), d};
}

/// The point with the given sign of the root.
template <class Numbers>
ExactPoint<Numbers> take_root(ExactPoint<Numbers> point, int root) {
  using Factor = typename Numbers::Factor;
  if (root < 0) {
    point.bx = -point.bx;
    point.by = -point.by;
  } else if (root == 0) {
    point.bx = Factor(0);
    point.by = Factor(0);
    point.c = typename Numbers::Radicand(0);
  }
  return point;
}

template <class Numbers>
Sign side(const ExactPoint<Numbers>& p, const ExactCircle<Numbers>& circle) {
  const auto ax = p.ax - circle.x * p.d;
  const auto ay = p.ay - circle.y * p.d;
  const auto product = ax * p.bx + ay * p.by;
  return sign_of_one_root(ax * ax + ay * ay + (p.bx * p.bx + p.by * p.by) * p.c - circle.squared_radius * (p.d * p.d),
                          product + product, p.c);
}

template <class Numbers>
Sign side(const ExactPoint<Numbers>& p, const ExactLine<Numbers>& line) {
  const auto dx = line.end_x - line.x;
  const auto dy = line.end_y - line.y;
  return sign_of_one_root(dx * (p.ay - line.y * p.d) - dy * (p.ax - line.x * p.d), dx * p.by - dy * p.bx, p.c);
}

template <class Numbers>
Sign compare_y_to_centre(const ExactPoint<Numbers>& p, const ExactCircle<Numbers>& circle) {
  return sign_of_one_root(p.ay - circle.y * p.d, p.by, p.c);
}

// The tangent of a circle at p is p - c turned by 90 degrees.

template <class Numbers>
Sign turn(const ExactPoint<Numbers>& p, const ExactCircle<Numbers>& a, const ExactCircle<Numbers>& b) {
  const auto dx = b.x - a.x;
  const auto dy = b.y - a.y;
  return sign_of_one_root((p.ax - a.x * p.d) * dy - (p.ay - a.y * p.d) * dx, p.bx * dy - p.by * dx, p.c);
}

template <class Numbers>
Sign turn(const ExactPoint<Numbers>& p, const ExactCircle<Numbers>& a, const ExactLine<Numbers>& b) {
  const auto dx = b.end_x - b.x;
  const auto dy = b.end_y - b.y;
  return sign_of_one_root((p.ax - a.x * p.d) * dx + (p.ay - a.y * p.d) * dy, p.bx * dx + p.by * dy, p.c);
}

template <class Numbers>
Sign turn(const ExactPoint<Numbers>& p, const ExactLine<Numbers>& a, const ExactCircle<Numbers>& b) {
  return -turn(p, b, a);
}

template <class Numbers>
Sign turn(const ExactPoint<Numbers>& /*p*/, const ExactLine<Numbers>& a, const ExactLine<Numbers>& b) {
  return ((b.end_x - b.x) * (a.end_y - a.y) - (b.end_y - b.y) * (a.end_x - a.x)).sign();
}

}  // namespace quoin::circular_exact
