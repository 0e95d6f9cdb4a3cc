// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "quoin/base/error.h"
#include "quoin/kernel/constructions_exact.h"
#include "quoin/kernel/constructions_rounding.h"
#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/number/whole_double.h"

/// Bodies of ExactTable; each instantiation is compiled in a source of its own.
namespace quoin::detail {

template <class Wide, class Narrow>
Wide widened(const Narrow& a) {
  return Wide(a);
}

template <class T>
bool is_zero(const std::array<T, 3>& v) {
  return v[0].sign() == Sign::zero && v[1].sign() == Sign::zero && v[2].sign() == Sign::zero;
}

template <class T>
void negate(std::array<T, 3>& v) {
  for (T& c : v) c = -c;
}

constexpr unsigned next_axis(unsigned axis) {
  return axis == 2 ? 0 : axis + 1;
}
constexpr unsigned previous_axis(unsigned axis) {
  return axis == 0 ? 2 : axis - 1;
}

// ---- Reading explicit points ----

inline Integer shifted(const Decoded& d, int lo) {
  const int shift = d.exponent - lo;
  Integer mantissa(d.mantissa);
  if (d.mantissa == 0) return mantissa;
  return shift >= 0 ? mantissa << static_cast<std::size_t>(shift) : mantissa >> static_cast<std::size_t>(-shift);
}

template <class N>
typename N::Coordinate ExplicitPoints<N>::in_units(double x) const {
  if constexpr (std::is_same_v<Coordinate, Integer>) {
    return shifted(decode(x), lo_);
  } else {
    const double scaled = x * scale_first_ * scale_second_;
    if constexpr (Coordinate::limb_count == 1) {
      return Coordinate(static_cast<std::int64_t>(scaled));
    } else {
      return from_whole_double(scaled);
    }
  }
}

// ---- Making planes, lines and points ----

template <class N>
std::array<typename N::Coordinate, 3> ExactTable<N>::difference(PointId q, PointId p) const {
  const auto a = explicit_[q];
  const auto b = explicit_[p];
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// n . p
template <class N>
typename N::Offset ExactTable<N>::offset_at(const Plane& plane, PointId p) const {
  return detail::dot<typename N::Offset>(plane.normal, explicit_[p]);
}

/// Multiplies by the common denominator.
inline void clear_denominators(std::span<Rational*> values) {
  Integer common(1);
  for (const Rational* v : values) mpz_lcm(common.raw(), common.raw(), mpq_denref(v->raw()));
  for (Rational* v : values) *v *= Rational(common);
}

inline LeadingBits leading_bits(const Rational& integral) {
  return quoin::leading_bits(integral.numerator());
}
using quoin::leading_bits;

/// The components scaled by 2^-(result) so that the largest lies in [1/2, 1], rounded to nearest.
template <class T>
std::int64_t unit_scaled(const std::array<T, 3>& v, std::array<double, 3>& out) {
  std::array<LeadingBits, 3> leading;
  std::optional<std::int64_t> top;
  for (unsigned i = 0; i < 3; ++i) {
    if (v[i].sign() == Sign::zero) continue;
    leading[i] = leading_bits(v[i]);
    top = std::max(top.value_or(leading[i].exponent), leading[i].exponent);
  }
  const std::int64_t exponent = top.value_or(0) + 64;
  for (unsigned i = 0; i < 3; ++i) {
    const double size = v[i].sign() == Sign::zero
                            ? 0.0
                            : scaled(nearest_mantissa(leading[i]) * 0x1p-64, leading[i].exponent + 64 - exponent);
    out[i] = v[i].sign() == Sign::negative ? -size : size;
  }
  return exponent;
}

template <class N>
filter::Plane ExactTable<N>::finish(Plane& plane) const {
  if (is_zero(plane.normal)) throw InternalError("a plane through collinear points was asked for");
  if constexpr (std::is_same_v<N, NumbersRational>) {
    std::array<Rational*, 4> values{&plane.normal[0], &plane.normal[1], &plane.normal[2], &plane.offset};
    clear_denominators(values);
  }
  std::array<double, 3> n{};
  const std::int64_t exponent = unit_scaled(plane.normal, n);
  double e = 0;
  if (plane.offset.sign() != Sign::zero) {
    const LeadingBits leading = leading_bits(plane.offset);
    e = scaled(nearest_mantissa(leading) * 0x1p-64, leading.exponent + 64 - exponent + explicit_.lo());
    if (plane.offset.sign() == Sign::negative) e = -e;
  }
  return {n[0], n[1], n[2], e};
}

template <class N>
filter::Plane ExactTable<N>::set_plane(PlaneId id, PointId a, PointId b, PointId c) {
  Plane& plane = planes_[id.index()];
  plane.normal = cross<typename N::Normal>(difference(b, a), difference(c, a));
  plane.offset = offset_at(plane, a);
  return finish(plane);
}

template <class N>
typename ExactTable<N>::Plane ExactTable<N>::axis_plane(PointId p, PointId q, unsigned axis) const {
  Plane plane;
  const auto direction = difference(q, p);
  const unsigned i = next_axis(axis);
  const unsigned j = previous_axis(axis);
  plane.normal[axis] = typename N::Normal(0);
  plane.normal[i] = widened<typename N::Normal>(-direction[j]);
  plane.normal[j] = widened<typename N::Normal>(direction[i]);
  plane.offset = offset_at(plane, p);
  return plane;
}

template <class N>
filter::Plane ExactTable<N>::set_axis_plane(PlaneId id, PointId p, PointId q, unsigned axis) {
  Plane& plane = planes_[id.index()];
  plane = axis_plane(p, q, axis);
  return finish(plane);
}

template <class N>
filter::Line ExactTable<N>::finish(Line& line) const {
  if (is_zero(line.direction)) throw InternalError("a line without direction was asked for");
  if constexpr (std::is_same_v<N, NumbersRational>) {
    std::array<Rational*, 3> values{&line.direction[0], &line.direction[1], &line.direction[2]};
    clear_denominators(values);
  }
  std::array<double, 3> d{};
  unit_scaled(line.direction, d);
  return {d[0], d[1], d[2]};
}

template <class N>
filter::Line ExactTable<N>::set_line(LineId id, PointId p, PointId q) {
  Line& line = lines_[id.index()];
  const auto direction = difference(q, p);
  for (unsigned i = 0; i < 3; ++i) line.direction[i] = widened<typename N::Direction>(direction[i]);
  return finish(line);
}

template <class N>
filter::Line ExactTable<N>::set_line(LineId id, PlaneId p, PlaneId q) {
  Line& line = lines_[id.index()];
  line.direction = cross<typename N::Direction>(plane(p).normal, plane(q).normal);
  return finish(line);
}

/// Makes the weight positive and rounds.
template <class N>
Point3 ExactTable<N>::finish(PointId id) {
  Point& point = constructed(id);
  const Sign sign = point.weight.sign();
  if (sign == Sign::zero) throw InternalError("a point of parallel lines and planes was asked for");
  if (sign == Sign::negative) {
    negate(point.numerator);
    point.weight = -point.weight;
  }
  if constexpr (std::is_same_v<N, NumbersRational>) {
    for (Rational& x : point.numerator) x /= point.weight;
    point.weight = Rational(1);
  }
  return round(id);
}

template <class N>
Point3 ExactTable<N>::round(PointId id) const {
  if constexpr (std::is_same_v<N, NumbersRational>) {
    const RationalPoint3 p = exact(id);
    return {p.x.to_double() + 0.0, p.y.to_double() + 0.0, p.z.to_double() + 0.0};
  } else {
    const Point& p = constructed(id);
    return {nearest_quotient(p.numerator[0], p.weight, explicit_.lo()),
            nearest_quotient(p.numerator[1], p.weight, explicit_.lo()),
            nearest_quotient(p.numerator[2], p.weight, explicit_.lo())};
  }
}

/// W = n . (q - p), X = W p + (e - n . p)(q - p).
template <class N>
Point3 ExactTable<N>::set_meeting(PointId id, PointId p, PointId q, const Plane& m) {
  using LineWeight = typename N::Offset;  // 3B + 7 bits
  using LineNumerator = typename N::LineNumerator;
  Point& point = constructed(id);
  const auto from = explicit_[p];
  const auto direction = difference(q, p);
  const auto weight = detail::dot<LineWeight>(m.normal, direction);
  const LineWeight height = m.offset - offset_at(m, p);
  for (unsigned i = 0; i < 3; ++i) {
    point.numerator[i] = widened<typename N::Numerator>(
        LineNumerator(product<LineNumerator>(weight, from[i]) + product<LineNumerator>(height, direction[i])));
  }
  point.weight = widened<typename N::Weight>(weight);
  return finish(id);
}

template <class N>
Point3 ExactTable<N>::set_point(PointId id, PointId p, PointId q, PlaneId plane_id) {
  return set_meeting(id, p, q, plane(plane_id));
}

template <class N>
Point3 ExactTable<N>::set_crossing(PointId id, PointId p, PointId q, PointId r, PointId s, unsigned axis) {
  return set_meeting(id, p, q, axis_plane(r, s, axis));
}

/// W = det(n1, n2, n3), X = e1 (n2 x n3) + e2 (n3 x n1) + e3 (n1 x n2).
template <class N>
Point3 ExactTable<N>::set_point(PointId id, PlaneId p_id, PlaneId q_id, PlaneId r_id) {
  Point& point = constructed(id);
  const Plane& p = plane(p_id);
  const Plane& q = plane(q_id);
  const Plane& r = plane(r_id);
  const auto qr = cross<typename N::Direction>(q.normal, r.normal);
  const auto rp = cross<typename N::Direction>(r.normal, p.normal);
  const auto pq = cross<typename N::Direction>(p.normal, q.normal);
  point.weight = detail::dot<typename N::Weight>(p.normal, qr);
  for (unsigned i = 0; i < 3; ++i) {
    point.numerator[i] = product<typename N::Numerator>(qr[i], p.offset) +
                         product<typename N::Numerator>(rp[i], q.offset) +
                         product<typename N::Numerator>(pq[i], r.offset);
  }
  return finish(id);
}

template <class N>
Point3 ExactTable<N>::set_point(PointId id, std::array<PointId, 3> corners, std::array<std::uint32_t, 3> weights) {
  Point& point = constructed(id);
  point.weight = typename N::Weight(static_cast<std::int64_t>(weights[0]) + weights[1] + weights[2]);
  for (auto& x : point.numerator) x = typename N::Numerator(0);
  for (unsigned k = 0; k < 3; ++k) {
    const auto corner = explicit_[corners[k]];
    const typename N::Coordinate weight(static_cast<std::int64_t>(weights[k]));
    for (unsigned i = 0; i < 3; ++i) {
      point.numerator[i] = point.numerator[i] + product<typename N::Numerator>(corner[i], weight);
    }
  }
  return finish(id);
}

// ---- Predicates ----

template <class N>
Sign ExactTable<N>::orientation(PointId a, PointId b, PointId c, PointId d) const {
  const auto normal = cross<typename N::Normal>(difference(b, a), difference(c, a));
  return detail::dot<typename N::Offset>(normal, difference(d, a)).sign();
}

template <class N>
Sign ExactTable<N>::turn(PointId a, PointId b, PointId c, unsigned axis) const {
  const unsigned i = next_axis(axis);
  const unsigned j = previous_axis(axis);
  const typename N::Coordinate ai = explicit_.coordinate(a, i);
  const typename N::Coordinate aj = explicit_.coordinate(a, j);
  return cross<typename N::Normal>(typename N::Coordinate(explicit_.coordinate(b, i) - ai),
                                   typename N::Coordinate(explicit_.coordinate(b, j) - aj),
                                   typename N::Coordinate(explicit_.coordinate(c, i) - ai),
                                   typename N::Coordinate(explicit_.coordinate(c, j) - aj))
      .sign();
}

template <class N>
Sign ExactTable<N>::side(PointId point, PlaneId id) const {
  const Plane& m = plane(id);
  if (is_explicit(point)) return (offset_at(m, point) - m.offset).sign();
  const Point& p = constructed(point);
  return (detail::dot<typename N::Side>(p.numerator, m.normal) - product<typename N::Side>(p.weight, m.offset)).sign();
}

template <class N>
Sign ExactTable<N>::compare(PointId p, PointId q, unsigned axis) const {
  if (is_explicit(p) && is_explicit(q)) {
    return (explicit_.coordinate(p, axis) - explicit_.coordinate(q, axis)).sign();
  }
  if (is_explicit(p)) return -compare(q, p, axis);
  const Point& a = constructed(p);
  if (is_explicit(q)) {
    return (a.numerator[axis] - product<typename N::Numerator>(a.weight, explicit_.coordinate(q, axis))).sign();
  }
  const Point& b = constructed(q);
  return (product<typename N::Comparison>(a.numerator[axis], b.weight) -
          product<typename N::Comparison>(b.numerator[axis], a.weight))
      .sign();
}

template <class N>
Sign ExactTable<N>::turn_any(PointId a, PointId b, PointId c, unsigned axis) const {
  if (is_explicit(c)) return turn(a, b, c, axis);
  const unsigned i = next_axis(axis);
  const unsigned j = previous_axis(axis);
  const typename N::Coordinate ai = explicit_.coordinate(a, i);
  const typename N::Coordinate aj = explicit_.coordinate(a, j);
  const typename N::Coordinate bi = explicit_.coordinate(b, i) - ai;
  const typename N::Coordinate bj = explicit_.coordinate(b, j) - aj;
  const Point& p = constructed(c);
  const typename N::Numerator pi = p.numerator[i] - product<typename N::Numerator>(p.weight, ai);
  const typename N::Numerator pj = p.numerator[j] - product<typename N::Numerator>(p.weight, aj);
  return (product<typename N::Side>(pj, bi) - product<typename N::Side>(pi, bj)).sign();
}

template <class N>
Sign ExactTable<N>::normal_component(PlaneId id, unsigned axis) const {
  return plane(id).normal[axis].sign();
}

template <class N>
Sign ExactTable<N>::dot(PlaneId p, PlaneId q) const {
  return detail::dot<typename N::Dot>(plane(p).normal, plane(q).normal).sign();
}

template <class N>
Sign ExactTable<N>::component(LineId line, unsigned axis) const {
  return lines_[line.index()].direction[axis].sign();
}

template <class N>
Sign ExactTable<N>::turn(LineId a, LineId b, unsigned axis) const {
  const auto& d = lines_[a.index()].direction;
  const auto& e = lines_[b.index()].direction;
  const unsigned i = next_axis(axis);
  const unsigned j = previous_axis(axis);
  return cross<typename N::Turn>(d[i], d[j], e[i], e[j]).sign();
}

template <class N>
Sign ExactTable<N>::triple(LineId line, PlaneId p, PlaneId q) const {
  const auto pq = cross<typename N::Direction>(plane(p).normal, plane(q).normal);
  return detail::dot<typename N::Triple>(lines_[line.index()].direction, pq).sign();
}

// ---- Leaving the table ----

template <std::size_t M>
Rational to_rational(const FixedInt<M>& a) {
  return Rational(to_integer(a));
}
inline Rational to_rational(const Integer& a) {
  return Rational(a);
}
inline Rational to_rational(const Rational& a) {
  return a;
}

/// 2^exponent
inline Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<std::size_t>(std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

template <std::size_t M>
Integer integral(const FixedInt<M>& a) {
  return to_integer(a);
}
inline Integer integral(const Integer& a) {
  return a;
}
inline Integer integral(const Rational& a) {
  return a.numerator();
}

template <class N>
std::array<Integer, 4> ExactTable<N>::homogeneous(PointId id) const {
  if constexpr (std::is_same_v<N, NumbersRational>) {
    RationalPoint3 p = exact(id);
    Rational weight(1);
    std::array<Rational*, 4> values{&p.x, &p.y, &p.z, &weight};
    clear_denominators(values);
    return {p.x.numerator(), p.y.numerator(), p.z.numerator(), weight.numerator()};
  } else {
    if (is_explicit(id)) {
      const auto p = explicit_[id];
      return {integral(p[0]), integral(p[1]), integral(p[2]), Integer(1)};
    }
    const Point& p = constructed(id);
    return {integral(p.numerator[0]), integral(p.numerator[1]), integral(p.numerator[2]), integral(p.weight)};
  }
}

template <class N>
std::array<Integer, 3> ExactTable<N>::direction(LineId id) const {
  const auto& d = lines_[id.index()].direction;  // integers, of rationals too: see finish
  return {integral(d[0]), integral(d[1]), integral(d[2])};
}

template <class N>
RationalPoint3 ExactTable<N>::exact(PointId id) const {
  const Rational unit = power_of_two(explicit_.lo());
  const auto quotient = [&](const auto& x, const Rational& w) { return to_rational(x) * unit / w; };
  if (is_explicit(id)) {
    const auto p = explicit_[id];
    return {quotient(p[0], 1), quotient(p[1], 1), quotient(p[2], 1)};
  }
  const Point& p = constructed(id);
  const Rational w = to_rational(p.weight);
  if (w.sign() == Sign::zero) throw InternalError("a point was asked for that has not been set");
  return {quotient(p.numerator[0], w), quotient(p.numerator[1], w), quotient(p.numerator[2], w)};
}

template <class N>
bool ExactTable<N>::is_exact(PointId id, const Point3& rounded) const {
  if constexpr (std::is_same_v<N, NumbersRational>) {
    const auto equals = [](double x, const Rational& value) { return std::isfinite(x) && Rational(x) == value; };
    const RationalPoint3 p = exact(id);
    return equals(rounded.x, p.x) && equals(rounded.y, p.y) && equals(rounded.z, p.z);
  } else {
    if (is_explicit(id)) return explicit_.is_double(id);
    const Point& p = constructed(id);
    return is_quotient(rounded.x, p.numerator[0], p.weight, explicit_.lo()) &&
           is_quotient(rounded.y, p.numerator[1], p.weight, explicit_.lo()) &&
           is_quotient(rounded.z, p.numerator[2], p.weight, explicit_.lo());
  }
}

/// Divided by the content, so that equal planes of one side have equal equations.
template <class N>
std::array<Rational, 4> ExactTable<N>::plane_equation(PlaneId id) const {
  const Plane& m = plane(id);
  std::array<Rational, 4> result{to_rational(m.normal[0]), to_rational(m.normal[1]), to_rational(m.normal[2]),
                                 to_rational(m.offset) * power_of_two(explicit_.lo())};
  std::array<Rational*, 4> values{&result[0], &result[1], &result[2], &result[3]};
  clear_denominators(values);
  Integer content;
  for (const Rational& c : result) mpz_gcd(content.raw(), content.raw(), mpq_numref(c.raw()));
  if (content.sign() == Sign::zero) throw InternalError("a plane was asked for that has not been set");
  for (Rational& c : result) c /= Rational(content);
  return result;
}

template <class N>
ExactTable<N> ExactTable<N>::subset(std::span<const PointId> points, std::size_t explicit_count,
                                    const Point3* rounded) const {
  ExactTable result(explicit_.chosen(points.first(explicit_count), rounded), explicit_count);
  result.points_.reserve(points.size() - explicit_count);
  for (const PointId p : points.subspan(explicit_count)) result.points_.push_back(constructed(p));
  return result;
}

}  // namespace quoin::detail
