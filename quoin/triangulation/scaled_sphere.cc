// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/scaled_sphere.h"

#include <cmath>
#include <cstdint>

#include "quoin/kernel/call_grid.h"

namespace quoin::detail {

namespace {

using Numbers = CallNumbers<61>;  // its widths hold
using Linear = Numbers::Linear;
using Quadratic = Numbers::Quadratic;
using Cubic = Numbers::Cubic;
using Quintic = Numbers::Quintic;
using IntegerPoint = std::array<std::int64_t, 3>;

/// A coordinate that vanishes without being zero has underflowed.
bool to_integers(const Point3& p, double scale, IntegerPoint& out) {
  bool is_integer = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scaled = p[axis] * scale;
    is_integer &= std::fabs(scaled) <= 0x1p61;
    const auto integer = static_cast<std::int64_t>(is_integer ? scaled : 0);
    is_integer &= static_cast<double>(integer) == scaled && (integer != 0 || p[axis] == 0);
    out[axis] = integer;
  }
  return is_integer;
}

struct Row {
  Linear x;
  Linear y;
  Linear z;

  Row(const IntegerPoint& p, const IntegerPoint& q) : x(p[0] - q[0]), y(p[1] - q[1]), z(p[2] - q[2]) {}
  Quadratic lift() const { return product<Quadratic>(x, x) + product<Quadratic>(y, y) + product<Quadratic>(z, z); }
};

Quadratic minor(const Row& a, const Row& b) {
  return cross<Quadratic>(a.x, a.y, b.x, b.y);
}

/// z times the minor of the other two columns, for three rows.
Cubic minor(const Row& a, const Quadratic& bc, const Row& b, const Quadratic& ac, const Row& c, const Quadratic& ab) {
  return product<Cubic>(bc, a.z) - product<Cubic>(ac, b.z) + product<Cubic>(ab, c.z);
}

}  // namespace

bool in_sphere_of_integers(const std::array<const Point3*, 5>& points, double scale, int& sign) {
  std::array<IntegerPoint, 5> p;
  for (std::size_t i = 0; i < 5; ++i) {
    if (!to_integers(*points[i], scale, p[i])) return false;
  }
  const Row a(p[0], p[4]);
  const Row b(p[1], p[4]);
  const Row c(p[2], p[4]);
  const Row d(p[3], p[4]);
  const Quadratic ab = minor(a, b);
  const Quadratic ac = minor(a, c);
  const Quadratic ad = minor(a, d);
  const Quadratic bc = minor(b, c);
  const Quadratic bd = minor(b, d);
  const Quadratic cd = minor(c, d);
  const Quintic positive =
      product<Quintic>(minor(b, cd, c, bd, d, bc), a.lift()) + product<Quintic>(minor(a, bd, b, ad, d, ab), c.lift());
  const Quintic negative =
      product<Quintic>(minor(a, cd, c, ad, d, ac), b.lift()) + product<Quintic>(minor(a, bc, b, ac, c, ab), d.lift());
  sign = to_int((positive - negative).sign());
  return true;
}

}  // namespace quoin::detail
