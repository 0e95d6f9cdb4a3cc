// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_family.h"

#include <cmath>
#include <string>
#include <utility>

#include "quoin/arrangement/circular/circular_exact.h"
#include "quoin/base/error.h"
#include "quoin/number/error_free.h"

namespace quoin {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view reason) {
  throw InputError(std::string(name) + ": " + std::string(reason));
}

void check_value(double value, std::string_view name, std::string_view what) {
  const double size = std::fabs(value);
  if (std::isnan(value)) refuse(name, std::string(what) + " is not a number");
  if (size > 0x1p200) refuse(name, std::string(what) + " is above 2^200");
  if (size != 0 && size < 0x1p-200) refuse(name, std::string(what) + " is not zero but below 2^-200");
}

void check_point(const Point2& p, std::string_view name) {
  check_value(p.x, name, "x");
  check_value(p.y, name, "y");
}

void check_point(const RationalPoint2& p, std::string_view name) {
  check_point(Point2{p.x.to_double(), p.y.to_double()}, name);
}

bool is_double(const Rational& value) {
  return Rational(value.to_double()) == value;
}

/// What rounding cuts off, rounded.
double tail(const Rational& value) {
  return (value - Rational(value.to_double())).to_double();
}

Rational squared_distance(const RationalCircle& circle, const RationalPoint2& p) {
  const Rational x = p.x - circle.x;
  const Rational y = p.y - circle.y;
  return x * x + y * y;
}

RationalPoint2 to_rational(const Point2& p) {
  return {p.x, p.y};
}

CurveId next_curve(PieceList<CircularFamily>& list) {
  return CurveId(list.curve_count++);
}

}  // namespace

CircularSupportId CircularFamily::add_circle_support(const Point2& centre, double radius, std::string_view name) {
  check_point(centre, name);
  check_value(radius, name, "radius");
  if (!(radius > 0)) refuse(name, "radius is not positive");
  CircularSupport s;
  s.x = centre.x;
  s.y = centre.y;
  s.radius = radius;
  const TwoDoubles square = two_product(radius, radius);
  s.squared_radius = square.value;
  s.squared_radius_tail = square.tail;
  s.form = CircularForm::radius;
  for (const double value : {s.x, s.y, s.radius}) raise_magnitude(value);
  pools_.supports.push_back(s);
  return CircularSupportId(pools_.supports.size() - 1);
}

CircularSupportId CircularFamily::add_circle_support(const RationalCircle& circle, std::string_view name) {
  CircularSupport s;
  s.x = circle.x.to_double();
  s.y = circle.y.to_double();
  check_point(Point2{s.x, s.y}, name);
  if (circle.squared_radius.sign() != Sign::positive) refuse(name, "squared radius is not positive");
  s.squared_radius = circle.squared_radius.to_double();
  if (!(s.squared_radius >= 0x1p-400)) refuse(name, "radius is below 2^-200");
  if (!(s.squared_radius <= 0x1p400)) refuse(name, "radius is above 2^200");
  s.radius = std::sqrt(s.squared_radius);
  s.x_tail = tail(circle.x);
  s.y_tail = tail(circle.y);
  s.squared_radius_tail = tail(circle.squared_radius);
  s.form = CircularForm::rational_circle;
  if (is_double(circle.x) && is_double(circle.y)) {
    if (Rational(s.radius) * Rational(s.radius) == circle.squared_radius) {
      s.form = CircularForm::radius;
    } else if (is_double(circle.squared_radius)) {
      s.form = CircularForm::squared_radius;
    }
  }
  if (s.form == CircularForm::rational_circle) {
    s.rational = static_cast<std::uint32_t>(pools_.circles.size());
    pools_.circles.emplace_back(circle);
  }
  for (const double value : {s.x, s.y, s.radius}) raise_magnitude(value);
  pools_.supports.push_back(s);
  return CircularSupportId(pools_.supports.size() - 1);
}

CircularSupportId CircularFamily::add_line_support(const Point2& a, const Point2& b, std::string_view name) {
  check_point(a, name);
  check_point(b, name);
  if (a == b) refuse(name, "its ends are the same point");
  const bool ordered = lexicographically_less(a, b);
  const Point2& from = ordered ? a : b;
  const Point2& to = ordered ? b : a;
  CircularSupport s;
  s.x = from.x;
  s.y = from.y;
  s.end_x = to.x;
  s.end_y = to.y;
  s.dx = to.x - from.x;
  s.dy = to.y - from.y;
  s.form = CircularForm::segment;
  s.vertical = s.dx == 0;
  for (const double value : {a.x, a.y, b.x, b.y}) raise_magnitude(value);
  pools_.supports.push_back(s);
  return CircularSupportId(pools_.supports.size() - 1);
}

CircularSupportId CircularFamily::add_line_support(const RationalPoint2& a, const RationalPoint2& b,
                                                   std::string_view name) {
  check_point(a, name);
  check_point(b, name);
  if (a == b) refuse(name, "its ends are the same point");
  if (is_double(a.x) && is_double(a.y) && is_double(b.x) && is_double(b.y)) {
    return add_line_support(Point2{a.x.to_double(), a.y.to_double()}, Point2{b.x.to_double(), b.y.to_double()}, name);
  }
  const bool ordered = a.x < b.x || (a.x == b.x && a.y < b.y);
  const RationalPoint2& from = ordered ? a : b;
  const RationalPoint2& to = ordered ? b : a;
  CircularSupport s;
  s.x = from.x.to_double();
  s.y = from.y.to_double();
  s.x_tail = tail(from.x);
  s.y_tail = tail(from.y);
  s.end_x = to.x.to_double();
  s.end_y = to.y.to_double();
  s.dx = (to.x - from.x).to_double();
  s.dy = (to.y - from.y).to_double();
  s.form = CircularForm::rational_line;
  s.vertical = to.x == from.x;
  const double length = std::max(std::fabs(s.dx), std::fabs(s.dy));
  if (!(length >= 0x1p-250)) refuse(name, "its ends are closer than 2^-250");
  if (!s.vertical && std::fabs(s.dx) < 0x1p-600) refuse(name, "it is vertical but for less than 2^-600");
  s.rational = static_cast<std::uint32_t>(pools_.lines.size());
  pools_.lines.emplace_back(RationalLine{from.x, from.y, to.x, to.y});
  for (const double value : {s.x, s.y, s.end_x, s.end_y}) raise_magnitude(value);
  pools_.supports.push_back(s);
  return CircularSupportId(pools_.supports.size() - 1);
}

CircularPoint CircularFamily::point(const Point2& p, std::string_view name) {
  check_point(p, name);
  raise_magnitude(p.x);
  raise_magnitude(p.y);
  return query(p);
}

CircularPoint CircularFamily::point(const RationalPoint2& p, std::string_view name) {
  const Point2 near{p.x.to_double(), p.y.to_double()};
  if (is_double(p.x) && is_double(p.y)) return point(near, name);
  check_point(near, name);
  raise_magnitude(near.x);
  raise_magnitude(near.y);
  Point result = query(near);
  result.kind = CircularPointKind::rational;
  result.exact_x = is_double(p.x);
  result.exact_y = is_double(p.y);
  result.rational = static_cast<std::uint32_t>(pools_.points.size());
  pools_.points.emplace_back(p);
  return result;
}

bool CircularFamily::put_on(Point& p, CircularSupportId support) const {
  const auto id = static_cast<std::uint32_t>(support.index());
  if (p.first == id || p.second == id) return true;
  if (side_of(p, id) != Sign::zero) return false;
  const bool explicit_point = p.kind == CircularPointKind::doubles || p.kind == CircularPointKind::rational;
  if (!explicit_point || (p.first != Point::none && p.second != Point::none)) return true;
  const auto half = is_line(support) ? std::int8_t{0} : static_cast<std::int8_t>(find_half(p, id));
  (p.first == Point::none ? p.half_first : p.half_second) = half;
  (p.first == Point::none ? p.first : p.second) = id;
  return true;
}

CurveId CircularFamily::append_circle(Pieces& list, CircularSupportId circle) const {
  const CurveId curve = next_curve(list);
  const std::uint32_t left = list.add_point(extreme(circle, false));
  const std::uint32_t right = list.add_point(extreme(circle, true));
  list.pieces.push_back({CircularFamily::lower_half(circle), left, right, curve, false});
  list.pieces.push_back({CircularFamily::upper_half(circle), left, right, curve, true});
  return curve;
}

template <class Coordinates>
CurveId CircularFamily::append_segment(Pieces& list, const Coordinates& from, const Coordinates& to,
                                       std::string_view name) {
  const CircularSupportId line = add_line_support(from, to, name);
  CircularPoint ends[2] = {point(from, name), point(to, name)};
  for (CircularPoint& end : ends) end.first = static_cast<std::uint32_t>(line.index());
  const bool reversed = compare_xy(ends[1], ends[0]) == Sign::negative;
  const std::uint32_t left = list.add_point(ends[reversed ? 1 : 0]);
  const std::uint32_t right = list.add_point(ends[reversed ? 0 : 1]);
  const CurveId curve = next_curve(list);
  list.pieces.push_back({CircularFamily::line_branch(line), left, right, curve, reversed});
  return curve;
}

/// Of a point on a circle, which half a counterclockwise walk goes on (`leaving`) or comes from.
bool CircularFamily::walks_upper(CircularSupportId circle, const Point& p, bool leaving) const {
  const CircularPoint left = extreme(circle, false);
  if (compare_xy(p, left) == Sign::zero) return !leaving;
  const CircularPoint right = extreme(circle, true);
  if (compare_xy(p, right) == Sign::zero) return leaving;
  return compare_y_at_x(p, CircularFamily::upper_half(circle)) == Sign::zero;
}

CurveId CircularFamily::add_circle(Pieces& list, const Point2& centre, double radius, std::string_view name) {
  return append_circle(list, add_circle_support(centre, radius, name));
}

CurveId CircularFamily::add_circle(Pieces& list, const RationalCircle& circle, std::string_view name) {
  return append_circle(list, add_circle_support(circle, name));
}

CurveId CircularFamily::add_segment(Pieces& list, const Point2& from, const Point2& to, std::string_view name) {
  return append_segment(list, from, to, name);
}

CurveId CircularFamily::add_segment(Pieces& list, const RationalPoint2& from, const RationalPoint2& to,
                                    std::string_view name) {
  return append_segment(list, from, to, name);
}

CurveId CircularFamily::add_arc(Pieces& list, CircularSupportId circle, CircularPoint from, CircularPoint to,
                                Direction direction, std::string_view name) {
  if (!put_on(from, circle)) refuse(name, "its start does not lie on the circle");
  if (!put_on(to, circle)) refuse(name, "its end does not lie on the circle");
  if (compare_xy(from, to) == Sign::zero) refuse(name, "its ends are the same point");
  const bool clockwise = direction == Direction::clockwise;
  if (clockwise) std::swap(from, to);
  const CurveId curve = next_curve(list);
  const bool last_upper = walks_upper(circle, to, false);
  bool upper = walks_upper(circle, from, true);
  CircularPoint here = from;
  std::uint32_t here_index = list.add_point(from);
  while (true) {
    // The lower half is walked to the right, the upper half to the left.
    const bool last = upper == last_upper && compare_xy(here, to) == (upper ? Sign::positive : Sign::negative);
    const CircularPoint next = last ? to : extreme(circle, !upper);
    const std::uint32_t next_index = list.add_point(next);
    const BranchId branch = upper ? CircularFamily::upper_half(circle) : CircularFamily::lower_half(circle);
    const std::uint32_t left = upper ? next_index : here_index;
    const std::uint32_t right = upper ? here_index : next_index;
    list.pieces.push_back({branch, left, right, curve, upper != clockwise});
    if (last) return curve;
    here = next;
    here_index = next_index;
    upper = !upper;
  }
}

CurveId CircularFamily::add_arc(Pieces& list, const Point2& centre, double radius, const Point2& from, const Point2& to,
                                Direction direction, std::string_view name) {
  const CircularSupportId circle = add_circle_support(centre, radius, name);
  return add_arc(list, circle, point(from, name), point(to, name), direction, name);
}

CurveId CircularFamily::add_arc(Pieces& list, const RationalCircle& circle, const RationalPoint2& from,
                                const RationalPoint2& to, Direction direction, std::string_view name) {
  if (squared_distance(circle, from) != circle.squared_radius) refuse(name, "its start does not lie on the circle");
  if (squared_distance(circle, to) != circle.squared_radius) refuse(name, "its end does not lie on the circle");
  const CircularSupportId id = add_circle_support(circle, name);
  return add_arc(list, id, point(from, name), point(to, name), direction, name);
}

CurveId CircularFamily::add_bulge_arc(Pieces& list, const Point2& from, const Point2& to, double bulge,
                                      std::string_view name) {
  check_value(bulge, name, "bulge");
  check_point(from, name);
  check_point(to, name);
  if (from == to) refuse(name, "its ends are the same point");
  if (bulge == 0) return add_segment(list, from, to, name);
  const RationalPoint2 p = to_rational(from);
  const RationalPoint2 q = to_rational(to);
  const Rational b(bulge);
  const Rational height = (Rational(1) - b * b) / (Rational(4) * b);  // of the centre above the chord, in chords
  const Rational half(0.5);
  RationalCircle circle{(p.x + q.x) * half - (q.y - p.y) * height, (p.y + q.y) * half + (q.x - p.x) * height, 0};
  circle.squared_radius = squared_distance(circle, p);
  return add_arc(list, circle, p, q, bulge > 0 ? Direction::counterclockwise : Direction::clockwise, name);
}

CurveId CircularFamily::add_point(Pieces& list, const Point2& p, std::string_view name) {
  const std::uint32_t index = list.add_point(point(p, name));
  const CurveId curve = next_curve(list);
  list.lone_points.push_back({index, curve});
  return curve;
}

CurveId CircularFamily::add_point(Pieces& list, const RationalPoint2& p, std::string_view name) {
  const std::uint32_t index = list.add_point(point(p, name));
  const CurveId curve = next_curve(list);
  list.lone_points.push_back({index, curve});
  return curve;
}

}  // namespace quoin
