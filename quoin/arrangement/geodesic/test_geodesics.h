// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/number/rational.h"

/// Slow definitions that geodesic predicates are tested against, straight from longitude and latitude and in rationals
/// only, and directions that are likely to coincide.
namespace quoin::test_geodesics {

using Triple = std::array<Rational, 3>;

inline Triple cross_product(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational scalar_product(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Triple opposite(const Triple& a) {
  return {-a[0], -a[1], -a[2]};
}
inline bool is_zero(const Triple& a) {
  return a == Triple{};
}
inline bool same_ray(const Triple& a, const Triple& b) {
  return is_zero(cross_product(a, b)) && scalar_product(a, b).sign() == Sign::positive;
}
inline bool is_pole(const Triple& a) {
  return a[0].sign() == Sign::zero && a[1].sign() == Sign::zero;
}
inline bool is_identified(const Triple& a) {
  return a[0].sign() == Sign::negative && a[1].sign() == Sign::zero;
}
inline Triple to_rationals(const std::array<Integer, 3>& a) {
  return {Rational(a[0]), Rational(a[1]), Rational(a[2])};
}
inline std::string text(const Triple& a) {
  return "(" + a[0].to_string() + ", " + a[1].to_string() + ", " + a[2].to_string() + ")";
}

inline Sign compare(const Rational& a, const Rational& b) {
  return a < b ? Sign::negative : a > b ? Sign::positive : Sign::zero;
}

/// A point of the parameter rectangle. At a pole `ray` is the horizontal direction of the meridian.
struct Place {
  Triple ray;
  Side side = Side::interior;
};

/// -1 on the left side, 5 on the right one, and between them alternately open quadrants and the axes between them.
inline int longitude_class(const Place& p) {
  if (is_identified(p.ray)) return p.side == Side::right ? 5 : -1;
  const Sign x = p.ray[0].sign();
  const Sign y = p.ray[1].sign();
  if (x == Sign::positive) return 2;
  if (x == Sign::zero) return y == Sign::negative ? 1 : 3;
  return y == Sign::negative ? 0 : 4;
}

/// By quadrant, then by the tangent.
inline Sign compare_longitude(const Place& p, const Place& q) {
  const int a = longitude_class(p);
  const int b = longitude_class(q);
  if (a != b) return a < b ? Sign::negative : Sign::positive;
  if (a % 2 != 0) return Sign::zero;
  return compare(p.ray[1] / p.ray[0], q.ray[1] / q.ray[0]);
}

/// The square of sin v with the sign of v.
inline Rational signed_square_of_sine(const Triple& ray) {
  return ray[2] * abs(ray[2]) / scalar_product(ray, ray);
}

inline Sign compare_places(const Place& p, const Place& q) {
  const Sign order = compare_longitude(p, q);
  if (order != Sign::zero) return order;
  const auto level = [](const Place& a) { return a.side == Side::bottom ? -1 : a.side == Side::top ? 1 : 0; };
  if (level(p) != level(q)) return level(p) < level(q) ? Sign::negative : Sign::positive;
  if (level(p) != 0) return Sign::zero;
  return compare(signed_square_of_sine(p.ray), signed_square_of_sine(q.ray));
}

/// A circle that is not vertical, or the half meridian through `half`.
struct Curve {
  Triple normal;
  bool is_vertical = false;
  Triple half;
};

/// Height of the circle above a horizontal vector, on the vertical line through it.
inline Rational height(const Curve& c, const Rational& x, const Rational& y) {
  return -(c.normal[0] * x + c.normal[1] * y) / c.normal[2];
}

inline Sign side_of_curve(const Place& p, const Curve& c) {
  if (c.is_vertical) return Sign::zero;
  if (p.side == Side::bottom) return Sign::negative;
  if (p.side == Side::top) return Sign::positive;
  return compare(p.ray[2], height(c, p.ray[0], p.ray[1]));
}

/// Order of the curves just beside p, which lies on both: at the horizontal vector moved along its tangent. The
/// difference of the heights is linear there.
inline Sign compare_beside(const Curve& a, const Curve& b, const Place& p, int direction) {
  const Sign vertical = direction > 0 ? Sign::positive : Sign::negative;
  if (a.is_vertical || b.is_vertical)
    return a.is_vertical == b.is_vertical ? Sign::zero : a.is_vertical ? vertical : -vertical;
  const Rational x = p.ray[0] - Rational(direction) * p.ray[1];
  const Rational y = p.ray[1] + Rational(direction) * p.ray[0];
  return compare(height(a, x, y), height(b, x, y));
}

inline bool is_on_half(const Triple& ray, const Curve& c) {
  return (ray[0] * c.half[1] - ray[1] * c.half[0]).sign() == Sign::zero &&
         (ray[0] * c.half[0] + ray[1] * c.half[1]).sign() == Sign::positive;
}

inline bool is_on_curve(const Place& p, const Curve& c) {
  if (p.side == Side::bottom || p.side == Side::top) return c.is_vertical && is_on_half(p.ray, c);
  if (scalar_product(p.ray, c.normal).sign() != Sign::zero) return false;
  return !c.is_vertical || (is_on_half(p.ray, c) && p.side != Side::right);
}

/// All common points of two curves, in order.
inline std::vector<Place> common_places(const Curve& a, const Curve& b) {
  std::vector<Place> places;
  const Triple d = cross_product(a.normal, b.normal);
  if (is_zero(d) || (a.is_vertical && b.is_vertical)) return places;
  for (const Triple& ray : {d, opposite(d)}) {
    for (const Side side : {Side::left, Side::right}) {
      if (!is_identified(ray) && side == Side::right) continue;
      const Place p{ray, is_identified(ray) ? side : Side::interior};
      if (is_on_curve(p, a) && is_on_curve(p, b)) places.push_back(p);
    }
  }
  std::sort(places.begin(), places.end(),
            [](const Place& p, const Place& q) { return compare_places(p, q) == Sign::negative; });
  return places;
}

/// Angle about the normal from `start` counterclockwise to p orders before that to q; all on the plane.
inline bool comes_before(const Triple& normal, const Triple& start, const Triple& p, const Triple& q) {
  const auto turn = [&](const Triple& a, const Triple& b) {
    return scalar_product(normal, cross_product(a, b)).sign();
  };
  const auto sector = [&](const Triple& a) {
    if (turn(start, a) == Sign::positive) return 1;
    if (turn(start, a) == Sign::negative) return 3;
    return scalar_product(start, a).sign() == Sign::positive ? 0 : 2;
  };
  if (sector(p) != sector(q)) return sector(p) < sector(q);
  return turn(p, q) == Sign::positive;
}

/// q, on the plane, lies on the closed arc; equal ends mean the whole circle.
inline bool is_on_arc(const Triple& source, const Triple& target, const Triple& normal, const Triple& q) {
  return same_ray(source, target) || !comes_before(normal, source, target, q);
}

/// The kinds of directions that tests draw. `underflow`: beside small integers components so small that doubles of
/// their products vanish.
enum class Draw { tiny, short_integers, nearly_tiny, doubles, long_integers, underflow, mixed };
inline constexpr std::array<Draw, 7> all_draws{Draw::tiny,    Draw::short_integers, Draw::nearly_tiny,
                                               Draw::doubles, Draw::long_integers,  Draw::underflow,
                                               Draw::mixed};

/// Draws directions of a kind; never zero.
class Directions {
 public:
  Directions(Draw draw, std::uint64_t seed) : draw_(draw), random_(seed) {}

  std::uint64_t below(std::uint64_t bound) { return random_() % bound; }

  Triple next() {
    Draw draw = draw_;
    if (draw == Draw::mixed) draw = all_draws[below(6)];
    while (true) {
      Triple d;
      for (Rational& value : d) value = component(draw);
      if (draw == Draw::underflow) {
        const Rational scale(std::ldexp(1.0, -520 - static_cast<int>(below(2)) * 520));
        const bool is_upright = below(2) == 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if ((axis == 2) != is_upright) d[axis] = component(Draw::doubles) * scale;
        }
      }
      if (!is_zero(d)) return d;
    }
  }

 private:
  Rational integer_of_bits(unsigned bits) {
    Integer value;
    for (unsigned done = 0; done < bits; done += 30) value = (value << 30) + Integer(static_cast<int>(below(1U << 30)));
    return below(2) == 0 ? Rational(value) : Rational(-value);
  }

  Rational component(Draw draw) {
    const auto tiny = [&] { return Rational(static_cast<int>(below(5)) - 2); };
    switch (draw) {
      case Draw::short_integers:
        return static_cast<int>(below(1U << 21)) - (1 << 20);
      case Draw::nearly_tiny: {
        constexpr std::array<int, 8> exponents{20, 30, 41, 43, 45, 49, 51, 60};
        const int exponent = below(8) == 0 ? 1040 : exponents[below(8)];
        return below(3) == 0 ? tiny() + tiny() * Rational(std::ldexp(1.0, -exponent)) : tiny();
      }
      case Draw::doubles:
        return Rational(std::ldexp(static_cast<double>(below(1ULL << 53)), -52) - 1);
      case Draw::long_integers: {
        constexpr std::array<unsigned, 4> bits{60, 120, 240, 480};
        return integer_of_bits(bits[below(4)]);
      }
      default:
        return tiny();
    }
  }

  Draw draw_;
  std::mt19937_64 random_;
};

/// The curve of a branch.
inline Curve curve_of(const GeodesicFamily& family, BranchId b) {
  Curve c;
  c.normal = to_rationals(family.normal(b));
  c.is_vertical = family.is_vertical(b);
  // The half meridian that runs upward about its normal: h = e_z x n.
  if (c.is_vertical) c.half = {-c.normal[1], c.normal[0], 0};
  return c;
}

/// For messages.
inline std::string named(Draw draw, std::uint64_t seed) {
  return "draw " + std::to_string(static_cast<int>(draw)) + " seed " + std::to_string(seed);
}

}  // namespace quoin::test_geodesics
