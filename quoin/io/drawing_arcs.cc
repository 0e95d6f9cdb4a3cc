// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/drawing_arcs.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin::io {

namespace {

constexpr std::size_t digits = 200;

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<std::size_t>(std::abs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

// A number in [value, value (1 + 2^-198)], or exactly the value.
struct Root {
  Rational value;
  bool is_exact = true;
};

// Of a number >= 0. With v = n/d the root is sqrt(n d) / d, from the integer root of n d 4^k.
Root square_root(const Rational& v) {
  if (v.sign() == Sign::zero) return {};
  Integer product = v.numerator() * v.denominator();
  const std::size_t bits = product.bit_length();
  const std::size_t k = bits < 2 * digits ? digits - bits / 2 : 0;
  product <<= 2 * k;
  Integer root;
  Integer remainder;
  mpz_sqrtrem(root.raw(), remainder.raw(), product.raw());
  return {Rational(root, v.denominator() << k), remainder.sign() == Sign::zero};
}

// At most the largest double: no such bound is met in a drawing whose coordinates are doubles.
double upper(const Rational& value) {
  return std::min(Interval::around(value).upper(), std::numeric_limits<double>::max());
}

// |b - a|^2 / 4.
Rational half_chord_squared(const Point2& a, const Point2& b) {
  const Rational dx = Rational(b.x) - Rational(a.x);
  const Rational dy = Rational(b.y) - Rational(a.y);
  return (dx * dx + dy * dy) / Rational(4);
}

double upper_root(const Rational& square) {
  return upper(square_root(square).value * (Rational(1) + power_of_two(-190)));
}

double upper_product(double a, double b) {
  return upper(Rational(a) * Rational(b));
}

// Rounds a bulge that is known up to `slack` (zero: exactly).
std::optional<RoundedBulge> rounded(const Rational& bulge, const Rational& slack, const Rational& chord_squared) {
  RoundedBulge result;
  result.bulge = bulge.to_double();
  if (!std::isfinite(result.bulge)) return std::nullopt;
  const Rational error = abs(bulge - Rational(result.bulge)) + slack;
  if (error.sign() != Sign::zero) result.distance = upper_product(upper(error), upper_root(chord_squared));
  return result;
}

Rational relative_slack(const Rational& value, bool is_exact) {
  return is_exact ? Rational() : abs(value) * power_of_two(-190);
}

// Fixed-point numbers: integers times 2^-digits.
Integer fixed(const Rational& v) {
  Integer quotient;
  mpz_fdiv_q(quotient.raw(), (v.numerator() << digits).raw(), v.denominator().raw());
  return quotient;
}

Rational value_of(const Integer& number) {
  return {number, Integer(1) << digits};
}

void divide(Integer& number, unsigned long divisor) {
  mpz_fdiv_q_ui(number.raw(), number.raw(), divisor);
}

// Pi within 2^-190, by Machin's formula: pi = 16 arctan(1/5) - 4 arctan(1/239).
const Rational& pi() {
  static const Rational value = [] {
    const auto arctangent_of_inverse = [](unsigned long n) {
      Integer sum;
      Integer power = Integer(1) << digits;
      divide(power, n);
      for (unsigned long k = 1; power.sign() == Sign::positive; k += 2) {
        Integer term = power;
        divide(term, k);
        sum += k % 4 == 1 ? term : -term;
        divide(power, n * n);
      }
      return sum;
    };
    return value_of(Integer(16) * arctangent_of_inverse(5) - Integer(4) * arctangent_of_inverse(239));
  }();
  return value;
}

struct SineCosine {
  Rational sine;
  Rational cosine;
};

// Of an angle in [0, 90) degrees, each within 2^-185: Taylor's series up to terms below 2^-200; about 50 roundings of
// 2^-200 each, and that of pi.
SineCosine sine_cosine_of_acute(const Rational& degrees) {
  if (degrees.sign() == Sign::zero) return {Rational(0), Rational(1)};
  const Integer x = fixed(degrees * pi() / Rational(180));
  Integer sine;
  Integer cosine;
  Integer term = Integer(1) << digits;
  for (unsigned long k = 0; term.sign() == Sign::positive; ++k) {
    Integer& sum = k % 2 == 0 ? cosine : sine;
    if (k % 4 < 2) {
      sum += term;
    } else {
      sum -= term;
    }
    term *= x;
    term >>= digits;
    divide(term, k + 1);
  }
  return {value_of(sine), value_of(cosine)};
}

Integer floor_of(const Rational& v) {
  Integer quotient;
  mpz_fdiv_q(quotient.raw(), v.numerator().raw(), v.denominator().raw());
  return quotient;
}

// In [0, 360).
Rational once_around(const Rational& degrees) {
  return degrees - Rational(360) * Rational(floor_of(degrees / Rational(360)));
}

struct Direction {
  Rational x;
  Rational y;
  bool is_exact = false;
};

// Of an angle in [0, 360) degrees; exact for multiples of 90, else within 2^-185.
Direction direction_of(const Rational& degrees) {
  const auto quadrant = mpz_get_ui(floor_of(degrees / Rational(90)).raw());
  const Rational rest = degrees - Rational(static_cast<std::int64_t>(quadrant) * 90);
  const SineCosine p = sine_cosine_of_acute(rest);
  const bool is_exact = rest.sign() == Sign::zero;
  switch (quadrant) {
    case 0:
      return {p.cosine, p.sine, is_exact};
    case 1:
      return {-p.sine, p.cosine, is_exact};
    case 2:
      return {-p.cosine, -p.sine, is_exact};
    default:
      return {p.sine, -p.cosine, is_exact};
  }
}

RoundedPoint point_on_circle(const Point2& center, double radius, const Direction& direction) {
  const Rational r(radius);
  const Rational x = Rational(center.x) + r * direction.x;
  const Rational y = Rational(center.y) + r * direction.y;
  RoundedPoint result{{x.to_double(), y.to_double()}, 0};
  if (!std::isfinite(result.point.x) || !std::isfinite(result.point.y)) return result;
  Rational error = abs(x - Rational(result.point.x)) + abs(y - Rational(result.point.y));
  if (!direction.is_exact) error += r * power_of_two(-180);
  result.distance = upper(error);
  return result;
}

}  // namespace

std::optional<RoundedBulge> bulge_through(const Point2& a, const Point2& m, const Point2& b) {
  // With u = a - m, v = b - m and the angle t between them, the arc turns through 2 pi - 2 t, and its bulge is
  // cot(t/2) = (|u||v| + u.v) / |u x v| = |u x v| / (|u||v| - u.v).
  const Rational ux = Rational(a.x) - Rational(m.x);
  const Rational uy = Rational(a.y) - Rational(m.y);
  const Rational vx = Rational(b.x) - Rational(m.x);
  const Rational vy = Rational(b.y) - Rational(m.y);
  const Rational dot = ux * vx + uy * vy;
  const Rational cross = ux * vy - uy * vx;
  if (cross.sign() == Sign::zero) {
    if (dot.sign() == Sign::negative) return RoundedBulge{};
    return std::nullopt;
  }
  const Root lengths = square_root((ux * ux + uy * uy) * (vx * vx + vy * vy));
  const Rational bulge = dot.sign() == Sign::negative ? -cross / (lengths.value - dot) : -(lengths.value + dot) / cross;
  return rounded(bulge, relative_slack(bulge, lengths.is_exact), half_chord_squared(a, b));
}

std::optional<RoundedBulge> bulge_of_radius(const Point2& a, const Point2& b, double radius, bool is_large,
                                            bool is_counterclockwise) {
  const Rational r(radius);
  const Rational square = half_chord_squared(a, b);
  const Rational rest = r * r - square;
  if (rest.sign() != Sign::positive) {
    RoundedBulge half{is_counterclockwise ? 1.0 : -1.0, 0, 0};
    if (rest.sign() == Sign::negative) {
      const Root h = square_root(square);
      half.radius_change = upper(h.value - r + relative_slack(h.value, h.is_exact));
    }
    return half;
  }
  const Root h = square_root(square);
  const Root s = square_root(rest);  // from the chord to the centre
  Rational bulge = is_large ? (r + s.value) / h.value : h.value / (r + s.value);
  if (!is_counterclockwise) bulge = -bulge;
  auto result = rounded(bulge, relative_slack(bulge, h.is_exact && s.is_exact), square);
  if (!result) return std::nullopt;
  if (result->bulge == 0) {
    result->radius_change = std::numeric_limits<double>::infinity();
  } else if (result->distance > 0) {
    const Rational q = abs(Rational(result->bulge));
    const Rational radius_of_double = h.value * (Rational(1) + q * q) / (Rational(2) * q);
    result->radius_change = upper(abs(radius_of_double - r) + relative_slack(radius_of_double, h.is_exact));
  }
  return result;
}

std::optional<RoundedArc> arc_of_angles(const Point2& center, double radius, double start_degrees, double end_degrees) {
  const Rational first(start_degrees);
  const Rational sweep = once_around(Rational(end_degrees) - first);
  RoundedArc arc;
  if (sweep.sign() == Sign::zero) {
    arc.is_whole = true;
    return arc;
  }
  const RoundedPoint start = point_on_circle(center, radius, direction_of(once_around(first)));
  const RoundedPoint end = point_on_circle(center, radius, direction_of(once_around(Rational(end_degrees))));
  for (const double x : {start.point.x, start.point.y, end.point.x, end.point.y}) {
    if (!std::isfinite(x)) return std::nullopt;
  }
  arc.start = start.point;
  arc.end = end.point;
  const double ends = upper(Rational(start.distance) + Rational(end.distance));
  if (arc.start == arc.end) {
    // The two ends are within `ends` of each other, and so the gap, or the arc, within that times pi / 2 of its ends.
    arc.is_whole = sweep > Rational(180);
    arc.distance = upper_product(ends, 3);
    return arc;
  }
  const SineCosine quarter = sine_cosine_of_acute(sweep / Rational(4));
  if (quarter.cosine < power_of_two(-100)) {  // the gap turns through 4 asin(cosine)
    arc.is_whole = true;
    arc.distance = upper(Rational(radius) * Rational(8) * (abs(quarter.cosine) + power_of_two(-180)));
    return arc;
  }
  const bool is_half = sweep == Rational(180);
  const Rational bulge = is_half ? Rational(1) : quarter.sine / quarter.cosine;
  const Rational slack = is_half ? Rational() : (Rational(1) + bulge * bulge) * power_of_two(-180);
  const auto nearest = rounded(bulge, slack, half_chord_squared(arc.start, arc.end));
  if (!nearest) return std::nullopt;
  arc.bulge = nearest->bulge;
  if (arc.bulge == 0 || ends > 0 || nearest->distance > 0) {
    // Moving the ends turns and scales the arc: each of its points moves by at most both moves times its distance from
    // an end over the chord, which is at most 1 or the diameter over the chord, (1 + b^2) / 2b.
    Rational spread(1);
    if (bulge > Rational(1)) spread = (Rational(1) + bulge * bulge) / (Rational(2) * bulge) + slack;
    arc.distance = upper(Rational(ends) * spread + Rational(nearest->distance));
  }
  return arc;
}

std::optional<RoundedPoint> top_of_arc(const Point2& a, const Point2& b, double bulge) {
  const Rational half(Integer(1), Integer(2));
  const Rational height = Rational(bulge) * half;
  const Rational x = (Rational(a.x) + Rational(b.x)) * half + height * (Rational(b.y) - Rational(a.y));
  const Rational y = (Rational(a.y) + Rational(b.y)) * half - height * (Rational(b.x) - Rational(a.x));
  RoundedPoint top{{x.to_double(), y.to_double()}, 0};
  if (!std::isfinite(top.point.x) || !std::isfinite(top.point.y)) return std::nullopt;
  top.distance = upper(abs(x - Rational(top.point.x)) + abs(y - Rational(top.point.y)));
  return top;
}

std::optional<RoundedRadius> radius_of_bulge(const Point2& a, const Point2& b, double bulge) {
  const Rational square = half_chord_squared(a, b);
  const Rational q = abs(Rational(bulge));
  const Rational radius = square_root(square).value * (Rational(1) + q * q) / (Rational(2) * q);
  const double nearest = radius.to_double();
  std::optional<RoundedRadius> best;
  for (const double candidate : {nearest, std::nextafter(nearest, 0.0), std::nextafter(nearest, HUGE_VAL)}) {
    if (!std::isfinite(candidate) || !(candidate > 0)) continue;
    const auto read = bulge_of_radius(a, b, candidate, std::fabs(bulge) > 1, bulge > 0);
    if (!read) continue;
    const double distance = distance_of_bulges(a, b, read->bulge, bulge);
    if (!best || distance < best->distance) best = RoundedRadius{candidate, distance};
  }
  return best;
}

double distance_of_bulges(const Point2& a, const Point2& b, double first, double second) {
  if (first == second) return 0;
  return upper_product(upper(abs(Rational(first) - Rational(second))), upper_root(half_chord_squared(a, b)));
}

std::optional<DrawingCircle> circle_over_diameter(const Point2& a, const Point2& b) {
  const Rational half(Integer(1), Integer(2));
  const Rational x = (Rational(a.x) + Rational(b.x)) * half;
  const Rational y = (Rational(a.y) + Rational(b.y)) * half;
  const Root radius = square_root(half_chord_squared(a, b));
  const DrawingCircle circle{{x.to_double(), y.to_double()}, radius.value.to_double()};
  for (const double value : {circle.center.x, circle.center.y, circle.radius}) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  const bool is_exact = radius.is_exact && Rational(circle.radius) == radius.value && Rational(circle.center.x) == x &&
                        Rational(circle.center.y) == y;
  return is_exact ? std::optional(circle) : std::nullopt;
}

}  // namespace quoin::io
