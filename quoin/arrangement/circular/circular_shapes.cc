// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_shapes.h"

#include <algorithm>
#include <cmath>

#include "quoin/arrangement/circular/circular_exact.h"

namespace quoin {
namespace {

constexpr double u = 0x1p-53;

/// A point of a half circle by its angle above (or below) the horizontal through the centre: 0 right, pi left.
struct HalfCircle {
  const CircularSupport& circle;
  double up;

  HalfCircle(const CircularFamily& family, BranchId branch)
      : circle(family.rounded(CircularFamily::support(branch))), up(CircularFamily::is_upper(branch) ? 1 : -1) {}

  double height(const Point2& p) const { return std::max(0.0, up * (p.y - circle.y)); }
  double angle(const Point2& p) const { return std::atan2(height(p), p.x - circle.x); }
  Point2 at(double angle) const {
    return {circle.x + circle.radius * std::cos(angle), circle.y + up * circle.radius * std::sin(angle)};
  }
};

}  // namespace

/// Positions are within the error, which also pays for the rounding of the centre plus the radius.
Box2 box(const CircularFamily& family, BranchId branch, const CircularPoint& left, const CircularPoint& right) {
  const Point2 a = family.position(left);
  const Point2 b = family.position(right);
  Box2 ends(a, b);
  if (!family.is_line(branch)) {
    const HalfCircle half(family, branch);
    const bool has_top = a.x <= half.circle.x + 2 * family.error() && b.x >= half.circle.x - 2 * family.error();
    if (has_top) ends.extend({half.circle.x, half.circle.y + half.up * half.circle.radius});
  }
  const double error = 1.5 * family.error();
  return {{ends.low().x - error, ends.low().y - error}, {ends.high().x + error, ends.high().y + error}};
}

Point2 arc_midpoint(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                    const CircularPoint& right) {
  const Point2 a = family.position(left);
  const Point2 b = family.position(right);
  if (family.is_line(branch)) return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
  const HalfCircle half(family, branch);
  return half.at(0.5 * (half.angle(a) + half.angle(b)));
}

/// A chord over the angle t is at most r (1 - cos(t / 2)) = 2 r sin(t / 4)^2 away from its arc.
std::vector<Point2> flatten(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                            const CircularPoint& right, double tolerance) {
  const Point2 a = family.position(left);
  const Point2 b = family.position(right);
  std::vector<Point2> chain{a};
  if (!family.is_line(branch)) {
    const HalfCircle half(family, branch);
    const double from = half.angle(a);
    const double to = half.angle(b);
    const double ratio = std::clamp(tolerance / half.circle.radius, 0x1p-60, 1.0);
    const double step = 4 * std::asin(std::sqrt(0.5 * ratio));
    const double count = std::clamp(std::ceil((from - to) / step), 1.0, 0x1p16);
    for (double i = 1; i < count; ++i) chain.push_back(half.at(from + (to - from) * (i / count)));
  }
  chain.push_back(b);
  return chain;
}

/// Line: dx (y1 + y2) / 2; dx errs by 2e, the mean by e, for e = error(). Circle, relative to its centre: X H / 2 +-
/// r^2 angle / 2 at both ends, plus the centre's y times dx. An end that moves by e moves X H by (|X| + |H|) e + e^2
/// and the angle by 2 e / r at most (it is at a distance of at least r - 2 e; where r < 4 e, everything is below 8 e
/// r), so the sum by less than 8 e r; roundings are below 32 u times the sum of the terms.
CertifiedDouble area_under(const CircularFamily& family, BranchId branch, const CircularPoint& left,
                           const CircularPoint& right) {
  const Point2 a = family.position(left);
  const Point2 b = family.position(right);
  const double e = family.error();
  const double dx = b.x - a.x;
  if (family.is_line(branch)) {
    const double mean = 0.5 * (a.y + b.y);
    const double size = std::fabs(a.y) + std::fabs(b.y);
    return {dx * mean, 1.01 * e * (std::fabs(dx) + size + 2 * e) + 8 * u * std::fabs(dx) * size};
  }
  const HalfCircle half(family, branch);
  const double r = half.circle.radius;
  const double r2 = half.circle.squared_radius;
  const double turn = half.angle(a) - half.angle(b);
  const double corner_a = (a.x - half.circle.x) * half.height(a);
  const double corner_b = (b.x - half.circle.x) * half.height(b);
  const double cap = 0.5 * (corner_b - corner_a + r2 * turn);
  const double error = 8 * e * (r + std::fabs(half.circle.y)) + 32 * u * (4 * r2 + std::fabs(half.circle.y * dx)) +
                       16 * e * (e + std::fabs(dx) * u);
  return {half.circle.y * dx + half.up * cap, error};
}

LineCoefficients coefficients(const CircularFamily& family, CircularSupportId id) {
  const RationalLine line = family.line(id);
  const Rational dx = line.end_x - line.x;
  const Rational dy = line.end_y - line.y;
  return {-dy, dx, dx * line.y - dy * line.x};
}

OneRootPoint exact_coordinates(const CircularFamily& family, const CircularPoint& p) {
  circular_exact::IntegerPoint q = circular_exact::integers(family.pools(), p);
  return {Rational(q.ax, q.d), Rational(q.bx, q.d), Rational(q.ay, q.d), Rational(q.by, q.d), Rational(q.c)};
}

RationalBounds bounds_of(const Rational& a, const Rational& b, const Rational& c, std::size_t bits) {
  // sqrt(n / m) = sqrt(n m) / m; one more unit of 2^-bits / m where it is no integer.
  const Integer m = c.denominator();
  const Integer scaled = (c.numerator() * m) << (2 * bits);
  Integer root;
  mpz_sqrt(root.raw(), scaled.raw());
  const bool exact = root * root == scaled;
  const Integer unit = m << bits;
  const Rational low = a + b * Rational(root, unit);
  if (exact || b.sign() == Sign::zero) return {low, low};
  const Rational high = a + b * Rational(root + Integer(1), unit);
  return low < high ? RationalBounds{low, high} : RationalBounds{high, low};
}

}  // namespace quoin
