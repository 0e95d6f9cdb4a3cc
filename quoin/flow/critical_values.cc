// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/critical_values.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "quoin/flow/face_formulas.h"
#include "quoin/triangulation/voronoi.h"

namespace quoin {

namespace {

using flow::between;
using flow::Vector;

template <class N>
N square_of_edge(const Point3& a, const Point3& b) {
  const Vector<N> v = between<N>(a, b);
  return dot(v, v) / N(4);
}

/// The product of the squared sides over four times the square of twice the area.
template <class N>
N square_of_triangle(const Point3& p, const Point3& q, const Point3& r) {
  const Vector<N> a = between<N>(p, q);
  const Vector<N> b = between<N>(p, r);
  const Vector<N> c = between<N>(q, r);
  const Vector<N> n = cross(a, b);
  return dot(a, a) * dot(b, b) * dot(c, c) / (N(4) * dot(n, n));
}

/// The circumcentre as centre / (2 det) from p.
template <class N>
struct Sphere {
  Vector<N> centre;
  N det;

  Sphere(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
    const Vector<N> a = between<N>(p, q);
    const Vector<N> b = between<N>(p, r);
    const Vector<N> c = between<N>(p, s);
    const Vector<N> bc = cross(b, c);
    det = dot(a, bc);
    centre = bc * dot(a, a) + cross(c, a) * dot(b, b) + cross(a, b) * dot(c, c);
  }
};

template <class N>
N square_of_simplex(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
  const Sphere<N> sphere(p, q, r, s);
  return dot(sphere.centre, sphere.centre) / (N(4) * sphere.det * sphere.det);
}

/// The middle of p + v / divisor, if that is known well enough.
std::optional<Point3> near_point(const Point3& p, const Vector<Interval>& v, const Interval& divisor) {
  Point3 found;
  double largest = 0;
  double widest = 0;
  std::size_t axis = 0;
  for (const Interval* along : {&v.x, &v.y, &v.z}) {
    const Interval at = Interval(p[axis]) + *along / divisor;
    found[axis] = at.lower() / 2 + at.upper() / 2;
    largest = std::max({largest, std::fabs(p[axis]), std::fabs(found[axis])});
    widest = std::max(widest, at.upper() - at.lower());
    ++axis;
  }
  if (!(widest <= 0x1p-31 * largest) || !std::isfinite(largest)) return std::nullopt;
  return found;
}

}  // namespace

Interval CriticalValues::of_edge(std::uint32_t cell, unsigned edge) const {
  return square_of_edge<Interval>(corner(cell, edge_slots[edge][0]), corner(cell, edge_slots[edge][1]));
}
Rational CriticalValues::exactly_of_edge(std::uint32_t cell, unsigned edge) const {
  return square_of_edge<Rational>(corner(cell, edge_slots[edge][0]), corner(cell, edge_slots[edge][1]));
}

Interval CriticalValues::of_facet(CellFacet facet) const {
  const std::array<unsigned, 3>& s = facet_slots[facet.slot];
  return square_of_triangle<Interval>(corner(facet.cell, s[0]), corner(facet.cell, s[1]), corner(facet.cell, s[2]));
}
Rational CriticalValues::exactly_of_facet(CellFacet facet) const {
  const std::array<unsigned, 3>& s = facet_slots[facet.slot];
  return square_of_triangle<Rational>(corner(facet.cell, s[0]), corner(facet.cell, s[1]), corner(facet.cell, s[2]));
}

Interval CriticalValues::of_cell(std::uint32_t cell) const {
  return square_of_simplex<Interval>(corner(cell, 0), corner(cell, 1), corner(cell, 2), corner(cell, 3));
}
Rational CriticalValues::exactly_of_cell(std::uint32_t cell) const {
  return square_of_simplex<Rational>(corner(cell, 0), corner(cell, 1), corner(cell, 2), corner(cell, 3));
}

RationalPoint3 CriticalValues::midpoint(std::uint32_t cell, unsigned edge) const {
  const Point3 a = corner(cell, edge_slots[edge][0]);
  const Point3 b = corner(cell, edge_slots[edge][1]);
  return (exact_point(a) + exact_point(b)) * (Rational(1) / Rational(2));
}

RationalPoint3 CriticalValues::centre(CellFacet facet) const {
  const std::array<unsigned, 3>& s = facet_slots[facet.slot];
  const Point3 first = corner(facet.cell, s[0]);
  const flow::Circle<Rational> circle({first, corner(facet.cell, s[1]), corner(facet.cell, s[2])});
  const RationalPoint3 doubled{circle.centre.x, circle.centre.y, circle.centre.z};
  return exact_point(first) + doubled * (Rational(1) / (circle.square_normal * Rational(2)));
}

RationalPoint3 CriticalValues::centre(std::uint32_t cell) const {
  return circumcentre(corner(cell, 0), corner(cell, 1), corner(cell, 2), corner(cell, 3));
}

Point3 CriticalValues::near_midpoint(std::uint32_t cell, unsigned edge) const {
  const Point3 a = corner(cell, edge_slots[edge][0]);
  const Point3 b = corner(cell, edge_slots[edge][1]);
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

Point3 CriticalValues::near_centre(CellFacet facet) const {
  const std::array<unsigned, 3>& s = facet_slots[facet.slot];
  const Point3 first = corner(facet.cell, s[0]);
  const flow::Circle<Interval> circle({first, corner(facet.cell, s[1]), corner(facet.cell, s[2])});
  const std::optional<Point3> found = near_point(first, circle.centre, circle.square_normal * Interval(2));
  return found ? *found : to_nearest_doubles(centre(facet));
}

Point3 CriticalValues::near_centre(std::uint32_t cell) const {
  const Point3 first = corner(cell, 0);
  const Sphere<Interval> sphere(first, corner(cell, 1), corner(cell, 2), corner(cell, 3));
  const std::optional<Point3> found = near_point(first, sphere.centre, sphere.det * Interval(2));
  return found ? *found : to_nearest_doubles(centre(cell));
}

// sqrt H <= sqrt L + d, that is H - L - d^2 <= 2 d sqrt L.
bool differ_by_at_most(const Rational& square_low, const Rational& square_high, const Rational& most) {
  const Rational left = square_high - square_low - most * most;
  return left.sign() != Sign::positive || left * left <= Rational(4) * most * most * square_low;
}

}  // namespace quoin
