// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular_predicates2.h"

#include <cmath>

#include "quoin/number/rational.h"
#include "quoin/triangulation/tie_rule2.h"

namespace quoin {

namespace {

// Relative to d, exact.
struct ExactRow {
  Rational x, y, lift;
  ExactRow(const WeightedPoint2& p, const WeightedPoint2& d)
      : x(Rational(p.point.x) - Rational(d.point.x)),
        y(Rational(p.point.y) - Rational(d.point.y)),
        lift(x * x + y * y - Rational(p.weight) + Rational(d.weight)) {}
};

Rational cross(const ExactRow& a, const ExactRow& b) {
  return a.x * b.y - a.y * b.x;
}

struct Row {
  double x, y, square, weight;
  Row(const WeightedPoint2& p, const WeightedPoint2& d)
      : x(p.point.x - d.point.x), y(p.point.y - d.point.y), square(x * x + y * y), weight(p.weight - d.weight) {}
  double minor(const Row& b) const { return x * b.y - y * b.x; }
  double lift() const { return square - weight; }
};

bool is_less(const WeightedPoint2& a, const WeightedPoint2& b) {
  return lexicographically_less(a.point, b.point);
}

// Of collinear points the order along their line is the lexicographic one.
Sign order_on_line(const WeightedPoint2& a, const WeightedPoint2& b) {
  return is_less(a, b) ? Sign::negative : Sign::positive;
}

// d below the segment or line of a, b, the largest of the three lifted a little.
bool is_in_segment_by_tie(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& d) {
  const bool a_is_larger = is_less(b, a);
  const WeightedPoint2& largest = a_is_larger ? a : b;
  const WeightedPoint2& other = a_is_larger ? b : a;
  if (is_less(largest, d)) return false;
  // Lifting an end lifts the line on its side of the other end.
  return order_on_line(other, largest) == order_on_line(other, d);
}

bool is_in_circle_by_tie(const std::array<const WeightedPoint2*, 3>& t, const WeightedPoint2& d) {
  using Corner = const WeightedPoint2*;
  return detail::is_in_circle_when_lifted<Corner>(
      t, &d, [](Corner p, Corner q) { return is_less(*p, *q); },
      [](Corner p, Corner q, Corner r) { return orientation(p->point, q->point, r->point); });
}

}  // namespace

// With S the sum of the squares and W that of the magnitudes of weight differences: minors are off by 8 u S, of size 2
// S; lifts by 4 u S + 2 u W and, their difference, u (S + W): 6 u (2 S + W) at most, of size S + W. Terms: 12 + 8 and
// their product 2, three of them 66, sums 10: 76 u S (2 S + W) = 8.44e-15. Products that underflow lose 2^-1075, times
// at most 2^202, at most 15 of them.
Sign in_power_circle(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                     const WeightedPoint2& d) {
  const Row ra(a, d);
  const Row rb(b, d);
  const Row rc(c, d);
  const double value = ra.lift() * rb.minor(rc) + rb.lift() * rc.minor(ra) + rc.lift() * ra.minor(rb);
  const double squares = ra.square + rb.square + rc.square;
  const double weights = std::fabs(ra.weight) + std::fabs(rb.weight) + std::fabs(rc.weight);
  const double size = 2 * squares + weights;
  if (size <= 0x1p200) {
    const int sign = filter::certain_sign(value, 8.6e-15 * squares * size + 0x1p-860);
    if (sign != 0) return static_cast<Sign>(sign);
  }
  if (a.weight == d.weight && b.weight == d.weight && c.weight == d.weight) {
    return in_circle(a.point, b.point, c.point, d.point);
  }
  const ExactRow ea(a, d);
  const ExactRow eb(b, d);
  const ExactRow ec(c, d);
  return (ea.lift * cross(eb, ec) + eb.lift * cross(ec, ea) + ec.lift * cross(ea, eb)).sign();
}

Sign in_power_segment(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& d) {
  const ExactRow ea(a, d);
  const ExactRow eb(b, d);
  const bool by_y = ea.x.sign() == Sign::zero && eb.x.sign() == Sign::zero;
  const Rational& at_a = by_y ? ea.y : ea.x;
  const Rational& at_b = by_y ? eb.y : eb.x;
  // The height of the line at d.
  return (ea.lift * at_b - eb.lift * at_a).sign() * (at_b - at_a).sign();
}

bool RegularPredicates2::in_conflict(const TriangleLinks2& t, const WeightedPoint2& d) const {
  for (unsigned slot = 0; slot < 3; ++slot) {
    if (t.corner[slot] != infinite_) continue;
    const WeightedPoint2& from = points_[t.corner[next_slot(slot)]];
    const WeightedPoint2& to = points_[t.corner[previous_slot(slot)]];
    const Sign side = orientation(from.point, to.point, d.point);
    if (side != Sign::zero) return side == Sign::positive;
    const Sign below = in_power_segment(from, to, d);
    return below == Sign::zero ? is_in_segment_by_tie(from, to, d) : below == Sign::positive;
  }
  const std::array<const WeightedPoint2*, 3> p{&points_[t.corner[0]], &points_[t.corner[1]], &points_[t.corner[2]]};
  const Sign below = in_power_circle(*p[0], *p[1], *p[2], d);
  return below == Sign::zero ? is_in_circle_by_tie(p, d) : below == Sign::positive;
}

bool is_seen_between(const WeightedPoint2& before, const WeightedPoint2& middle, const WeightedPoint2& after) {
  const Sign below = in_power_segment(before, after, middle);
  return below == Sign::zero ? is_in_segment_by_tie(before, after, middle) : below == Sign::positive;
}

}  // namespace quoin
