// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

/// Smallest spheres that are orthogonal to weighted points, as polynomials of coordinates, for all exact number types:
/// integers of any size, and those whose widths the compiler derives.
///
/// One point of a simplex, p, is the origin; another, q, is a row: the vector u = q - p and its lift |u|^2 + w_p - w_q,
/// which is twice u x for the centre x of any sphere orthogonal to both. The power of the sphere, which is its squared
/// radius where weights are zero, is |x|^2 - w_p; of the smallest such sphere x lies in the span of the rows.
namespace quoin::sphere_formulas {

template <class Number, class Lift = Number>
struct Row {
  std::array<Number, 3> vector;
  Lift lift;
};

template <class A, class B>
auto dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class A, class B>
auto cross(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  using Number = decltype(a[0] * b[0] - a[0] * b[0]);
  return std::array<Number, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class A, class B>
auto scaled(const std::array<A, 3>& a, const B& factor) {
  using Number = decltype(a[0] * factor);
  return std::array<Number, 3>{a[0] * factor, a[1] * factor, a[2] * factor};
}

template <class A, class B>
auto sum(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  using Number = decltype(a[0] + b[0]);
  return std::array<Number, 3>{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class A, class B>
auto difference(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  using Number = decltype(a[0] - b[0]);
  return std::array<Number, 3>{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// 4 |x|^2 as a quotient; the denominator is positive where the points are affinely independent.
template <class Numerator, class Denominator>
struct Quotient {
  Numerator numerator;
  Denominator denominator;
};
template <class Numerator, class Denominator>
Quotient(Numerator, Denominator) -> Quotient<Numerator, Denominator>;

template <class R>
auto centre_square(const R& u) {
  return Quotient{u.lift * u.lift, dot(u.vector, u.vector)};
}

/// 2 x = ((l_u v - l_v u) x n) / |n|^2 with n = u x v.
template <class R>
auto centre_square(const R& u, const R& v) {
  const auto across = difference(scaled(v.vector, u.lift), scaled(u.vector, v.lift));
  const auto normal = cross(u.vector, v.vector);
  return Quotient{dot(across, across), dot(normal, normal)};
}

/// 2 x = (l_u v x w + l_v w x u + l_w u x v) / det(u, v, w).
template <class R>
auto centre_square(const R& u, const R& v, const R& w) {
  const auto vw = cross(v.vector, w.vector);
  const auto centre = sum(sum(scaled(vw, u.lift), scaled(cross(w.vector, u.vector), v.lift)),
                          scaled(cross(u.vector, v.vector), w.lift));
  const auto volume = dot(u.vector, vw);
  return Quotient{dot(centre, centre), volume * volume};
}

/// A positive multiple of |q - x|^2 - w_q less the power of the smallest sphere of the origin, or of it and the rows
/// before the last, which is q: negative where q lies inside.
template <class R>
auto excess(const R& q) {
  return q.lift;
}
template <class R>
auto excess(const R& u, const R& q) {
  return q.lift * dot(u.vector, u.vector) - u.lift * dot(u.vector, q.vector);
}
template <class R>
auto excess(const R& u, const R& v, const R& q) {
  const auto normal = cross(u.vector, v.vector);
  const auto across = difference(scaled(v.vector, u.lift), scaled(u.vector, v.lift));
  return q.lift * dot(normal, normal) - dot(q.vector, cross(across, normal));
}

}  // namespace quoin::sphere_formulas
