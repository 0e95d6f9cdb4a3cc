// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/number/integer.h"
#include "quoin/number/rational.h"

/// What the predicates of CircularFamily should say, found in another way: coordinates with 5,000 bits behind the
/// point, solved from the equations of the supports, and orders beside a point by evaluation a little further on.
namespace quoin::testing {

/// A real number up to a few units of 2^-5000.
class LongReal {
 public:
  static constexpr std::size_t bits = 5000;

  LongReal() = default;
  LongReal(const Rational& value) {  // NOLINT(google-explicit-constructor)
    const Integer numerator = value.numerator() << bits;
    mpz_fdiv_q(value_.raw(), numerator.raw(), value.denominator().raw());
  }
  static LongReal power_of_two(int exponent) {
    LongReal result;
    result.value_ = Integer(1) << static_cast<std::size_t>(static_cast<int>(bits) + exponent);
    return result;
  }

  friend LongReal operator+(LongReal a, const LongReal& b) { return a.value_ += b.value_, a; }
  friend LongReal operator-(LongReal a, const LongReal& b) { return a.value_ -= b.value_, a; }
  friend LongReal operator*(LongReal a, const LongReal& b) { return a.value_ *= b.value_, a.value_ >>= bits, a; }
  friend LongReal operator/(LongReal a, const LongReal& b) {
    a.value_ <<= bits;
    mpz_fdiv_q(a.value_.raw(), a.value_.raw(), b.value_.raw());
    return a;
  }
  /// Of a number that is not negative but for its error.
  friend LongReal root(LongReal a) {
    if (a.value_.sign() != Sign::positive) return {};
    a.value_ <<= bits;
    mpz_sqrt(a.value_.raw(), a.value_.raw());
    return a;
  }
  /// Zero if closer to it than 2^-2200: numbers that come from the inputs of tests are zero or far larger.
  Sign sign() const { return value_.bit_length() < bits - 2200 ? Sign::zero : value_.sign(); }
  double to_double() const { return Rational(value_, Integer(1) << bits).to_double(); }

 private:
  Integer value_;
};

inline LongReal abs(const LongReal& a) {
  return a.sign() == Sign::negative ? LongReal() - a : a;
}

struct LongPoint {
  LongReal x;
  LongReal y;
};

inline Sign compare_lexicographically(const LongPoint& p, const LongPoint& q) {
  const Sign x = (p.x - q.x).sign();
  return x != Sign::zero ? x : (p.y - q.y).sign();
}

class CircularOracle {
 public:
  explicit CircularOracle(const CircularFamily& family) : family_(family) {}

  LongPoint point(const CircularPoint& p) const {
    switch (p.kind) {
      case CircularPointKind::doubles:
        return {Rational(p.x), Rational(p.y)};
      case CircularPointKind::rational:
        return {family_.pools().exact_point(p.rational).x, family_.pools().exact_point(p.rational).y};
      case CircularPointKind::extreme: {
        const Circle c = circle(p.first);
        const LongReal r = root(c.r2);
        return {p.root > 0 ? c.x + r : c.x - r, c.y};
      }
      case CircularPointKind::crossing:
        break;
    }
    LongPoint common[2];
    const int count = meet(p.first, p.second, common);
    return common[count == 2 && p.root > 0 ? 1 : 0];
  }

  /// Common points of two different supports in lexicographic order, and how many.
  int meet(std::uint32_t a, std::uint32_t b, LongPoint out[2]) const {
    const bool line_a = is_line(a);
    const bool line_b = is_line(b);
    if (line_a && line_b) return meet_lines(line(a), line(b), out);
    if (line_a) return meet_line(circle(b), line(a), out);
    if (line_b) return meet_line(circle(a), line(b), out);
    const Circle one = circle(a);
    const Circle two = circle(b);
    // On the radical line (c2 - c1) . p = half of |c2|^2 - r2^2 - |c1|^2 + r1^2.
    const LongReal dx = two.x - one.x;
    const LongReal dy = two.y - one.y;
    const LongReal d2 = dx * dx + dy * dy;
    if (d2.sign() == Sign::zero) return 0;
    const LongReal half(Rational(0.5));
    const LongReal offset =
        half * (two.x * two.x + two.y * two.y - two.r2 - one.x * one.x - one.y * one.y + one.r2) / d2;
    const LongPoint foot{offset * dx, offset * dy};
    return meet_line(one, {foot, {foot.x - dy, foot.y + dx}}, out);
  }

  /// y of a branch that is not vertical at x.
  LongReal y_at(BranchId branch, const LongReal& x) const {
    const auto id = static_cast<std::uint32_t>(CircularFamily::support(branch).index());
    if (is_line(id)) {
      const Line l = line(id);
      return l.from.y + (x - l.from.x) * (l.to.y - l.from.y) / (l.to.x - l.from.x);
    }
    const Circle c = circle(id);
    const LongReal height = root(c.r2 - (x - c.x) * (x - c.x));
    return CircularFamily::is_upper(branch) ? c.y + height : c.y - height;
  }
  bool is_in_range(BranchId branch, const LongReal& x) const {
    const auto id = static_cast<std::uint32_t>(CircularFamily::support(branch).index());
    if (is_line(id)) return !family_.is_vertical(branch) || (x - line(id).from.x).sign() == Sign::zero;
    const Circle c = circle(id);
    return ((x - c.x) * (x - c.x) - c.r2).sign() != Sign::positive;
  }

  /// Of branches through p, at the given side of it: +1 right, -1 left. A vertical branch is above right, below left.
  Sign order_beside(BranchId a, BranchId b, const LongPoint& p, int side) const {
    const bool vertical_a = family_.is_vertical(a);
    const bool vertical_b = family_.is_vertical(b);
    if (vertical_a || vertical_b) return static_cast<Sign>(side * (static_cast<int>(vertical_a) - vertical_b));
    const LongReal step = LongReal::power_of_two(-450);
    const LongReal x = side > 0 ? p.x + step : p.x - step;
    return (y_at(a, x) - y_at(b, x)).sign();
  }

 private:
  struct Circle {
    LongReal x;
    LongReal y;
    LongReal r2;
  };
  struct Line {
    LongPoint from;
    LongPoint to;
  };

  bool is_line(std::uint32_t id) const { return family_.is_line(CircularSupportId(id)); }
  Circle circle(std::uint32_t id) const {
    const RationalCircle c = family_.circle(CircularSupportId(id));
    return {c.x, c.y, c.squared_radius};
  }
  Line line(std::uint32_t id) const {
    const RationalLine l = family_.line(CircularSupportId(id));
    return {{l.x, l.y}, {l.end_x, l.end_y}};
  }

  /// Roots of the quadratic in the parameter of the line.
  static int meet_line(const Circle& c, const Line& l, LongPoint out[2]) {
    const LongReal ex = l.to.x - l.from.x;
    const LongReal ey = l.to.y - l.from.y;
    const LongReal wx = l.from.x - c.x;
    const LongReal wy = l.from.y - c.y;
    const LongReal q = ex * ex + ey * ey;
    const LongReal h = ex * wx + ey * wy;
    const LongReal discriminant = h * h - q * (wx * wx + wy * wy - c.r2);
    if (discriminant.sign() == Sign::negative) return 0;
    const bool single = discriminant.sign() == Sign::zero;
    const LongReal half = single ? LongReal() : root(discriminant) / q;
    const LongReal middle = LongReal() - h / q;
    const LongReal t[2] = {middle - half, middle + half};
    for (int i = 0; i < 2; ++i) out[i] = {l.from.x + t[i] * ex, l.from.y + t[i] * ey};
    if (single) return 1;
    if (compare_lexicographically(out[1], out[0]) == Sign::negative) std::swap(out[0], out[1]);
    return 2;
  }

  static int meet_lines(const Line& a, const Line& b, LongPoint out[2]) {
    const LongReal ex = a.to.x - a.from.x;
    const LongReal ey = a.to.y - a.from.y;
    const LongReal fx = b.to.x - b.from.x;
    const LongReal fy = b.to.y - b.from.y;
    const LongReal d = ex * fy - ey * fx;
    if (d.sign() == Sign::zero) return 0;
    const LongReal t = ((b.from.x - a.from.x) * fy - (b.from.y - a.from.y) * fx) / d;
    out[0] = {a.from.x + t * ex, a.from.y + t * ey};
    return 1;
  }

  const CircularFamily& family_;
};

}  // namespace quoin::testing
