// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_family.h"

#include <limits>
#include <string>

#include "quoin/arrangement/linear/linear_reader.h"
#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"

namespace quoin {

namespace {

using detail::CallValues;
using detail::on_grid;
using detail::RationalCallNumbers;

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_finite(const Point2& p, std::string_view name) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InputError(std::string(name) + ": a coordinate is not finite");
}

Point2 rounded(const RationalPoint2& p) {
  return {detail::clamped_double(p.x), detail::clamped_double(p.y)};
}

bool is_before(const RationalPoint2& a, const RationalPoint2& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

double largest_coordinate(const Point2& a, const Point2& b) {
  return std::max(std::max(std::fabs(a.x), std::fabs(a.y)), std::max(std::fabs(b.x), std::fabs(b.y)));
}

Sign reversed_if(bool reverse, Sign sign) {
  return reverse ? -sign : sign;
}

}  // namespace

BranchId LinearFamily::push_line(const Line& line, std::uint32_t rational) {
  if (lines_.size() >= LinearPoint::explicit_tag) throw InputError("more lines than an arrangement holds");
  if (rational != no_rational && !is_rounded_) {
    is_rounded_ = true;
    rational_of_line_.assign(lines_.size(), no_rational);
  }
  lines_.push_back(line);
  if (is_rounded_) rational_of_line_.push_back(rational);
  size_ = std::max(size_, largest_coordinate({line.ax, line.ay}, {line.bx, line.by}));
  error_ = std::max(0x1p-46 * size_, 0x1p-1000);
  return BranchId(lines_.size() - 1);
}

BranchId LinearFamily::add_line(const Point2& a, const Point2& b, std::string_view name) {
  require_finite(a, name);
  require_finite(b, name);
  if (a == b) throw InputError(std::string(name) + ": its two points are equal");
  if (lexicographically_less(b, a)) return push_line({b.x, b.y, a.x, a.y}, no_rational);
  return push_line({a.x, a.y, b.x, b.y}, no_rational);
}

BranchId LinearFamily::add_line(const RationalPoint2& a, const RationalPoint2& b, std::string_view name) {
  if (a == b) throw InputError(std::string(name) + ": its two points are equal");
  const bool swap = is_before(b, a);
  const RationalPoint2& first = swap ? b : a;
  const RationalPoint2& second = swap ? a : b;
  const Point2 ra = rounded(first);
  const Point2 rb = rounded(second);
  if (Rational(ra.x) == first.x && Rational(ra.y) == first.y && Rational(rb.x) == second.x &&
      Rational(rb.y) == second.y) {
    return push_line({ra.x, ra.y, rb.x, rb.y}, no_rational);
  }
  const auto index = static_cast<std::uint32_t>(rationals_.size());
  rationals_.push_back(first);
  rationals_.push_back(second);
  return push_line({ra.x, ra.y, rb.x, rb.y}, index);
}

LinearPoint LinearFamily::point(const Point2& p, std::string_view name) {
  require_finite(p, name);
  return {p.x, p.y, 0, LinearPoint::explicit_tag};
}

LinearPoint LinearFamily::point(const RationalPoint2& p) {
  const Point2 r = rounded(p);
  if (Rational(r.x) == p.x && Rational(r.y) == p.y) return {r.x, r.y, 0, LinearPoint::explicit_tag};
  const auto index = static_cast<std::uint32_t>(rationals_.size());
  rationals_.push_back(p);
  size_ = std::max(size_, std::max(std::fabs(r.x), std::fabs(r.y)));
  error_ = std::max(0x1p-46 * size_, 0x1p-1000);
  return {r.x, r.y, index, LinearPoint::rational_tag};
}

LinearPoint LinearFamily::first_end(BranchId line) const {
  const Line& l = lines_[line.index()];
  return {l.ax, l.ay, line.value, is_vertical(line) ? LinearPoint::bottom_tag : LinearPoint::left_tag};
}

LinearPoint LinearFamily::last_end(BranchId line) const {
  const Line& l = lines_[line.index()];
  return {l.ax, l.ay, line.value, is_vertical(line) ? LinearPoint::top_tag : LinearPoint::right_tag};
}

RationalPoint2 LinearFamily::first_support_point(BranchId b) const {
  if (is_rational(b)) return rationals_[rational_of_line_[b.index()]];
  const Line& l = lines_[b.index()];
  return {Rational(l.ax), Rational(l.ay)};
}

RationalPoint2 LinearFamily::second_support_point(BranchId b) const {
  if (is_rational(b)) return rationals_[rational_of_line_[b.index()] + 1];
  const Line& l = lines_[b.index()];
  return {Rational(l.bx), Rational(l.by)};
}

bool LinearFamily::is_rational(const Point& p) const {
  if (p.is_explicit()) return false;
  if (p.second == LinearPoint::rational_tag) return true;
  if (p.is_end()) return is_rational(BranchId(p.first));
  return is_rational(BranchId(p.first)) || is_rational(BranchId(p.second));
}

bool LinearFamily::is_vertical(BranchId b) const {
  const Line& l = lines_[b.index()];
  if (!is_rational(b)) return l.ax == l.bx;
  return l.ax == l.bx && first_support_point(b).x == second_support_point(b).x;
}

Sign LinearFamily::compare_slopes(BranchId a, BranchId b) const {
  if (a == b) return Sign::zero;
  const Line& s = lines_[a.index()];
  const Line& t = lines_[b.index()];
  const double sx = s.bx - s.ax;
  const double sy = s.by - s.ay;
  const double tx = t.bx - t.ax;
  const double ty = t.by - t.ay;
  const double left = tx * sy;
  const double right = ty * sx;
  double bound = 0x1.08p-51 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000;
  if (is_rounded_) bound += error_ * (std::fabs(sx) + std::fabs(sy) + std::fabs(tx) + std::fabs(ty) + error_);
  if (std::fabs(left - right) > bound) return left < right ? Sign::negative : Sign::positive;
  const auto formula = [&](const auto& read, const auto&...) {
    const auto p = read.line(a);
    const auto q = read.line(b);
    using Number = decltype(detail::exact_crossing(p, q).w);
    return detail::cross<Number>(q.dx, q.dy, p.dx, p.dy).sign();
  };
  if (is_rational(a) || is_rational(b)) return formula(LinearReader<RationalCallNumbers>(*this));
  CallValues values;
  for (const Line& l : {s, t}) {
    values.add({l.ax, l.ay});
    values.add({l.bx, l.by});
  }
  return on_grid(*this, values, formula);
}

Sign LinearFamily::exact_side(const Point& p, BranchId b) const {
  if (p.is_crossing() && (p.first == b.value || p.second == b.value)) return Sign::zero;
  const auto formula = [&](const auto& read, const auto&...) {
    return detail::side_of_line(read.point(p), read.line(b));
  };
  if (is_rational(p) || is_rational(b)) return formula(LinearReader<RationalCallNumbers>(*this));
  const Line& l = lines_[b.index()];
  if (p.is_explicit()) return orientation(Point2{l.ax, l.ay}, Point2{l.bx, l.by}, Point2{p.x, p.y});
  CallValues values;
  for (const std::uint32_t index : {b.value, p.first, p.second}) {
    const Line& line = lines_[index];
    values.add({line.ax, line.ay});
    values.add({line.bx, line.by});
  }
  return on_grid(*this, values, formula);
}

Sign LinearFamily::exact_side_of_support_point(BranchId of, BranchId line) const {
  if (is_rational(of) || is_rational(line)) {
    const LinearReader<RationalCallNumbers> read(*this);
    const RationalPoint2 p = first_support_point(of);
    return detail::side_of_line<RationalCallNumbers>({p.x, p.y, Rational(1)}, read.line(line));
  }
  const Line& p = lines_[of.index()];
  const Line& l = lines_[line.index()];
  return orientation(Point2{l.ax, l.ay}, Point2{l.bx, l.by}, Point2{p.ax, p.ay});
}

Sign LinearFamily::compare_at_infinity(BranchId a, BranchId b, Side side) const {
  const Sign slopes = compare_slopes(a, b);
  if (slopes != Sign::zero) return reversed_if(side == Side::left, slopes);
  return a == b ? Sign::zero : exact_side_of_support_point(a, b);
}

bool LinearFamily::same_branch(BranchId a, BranchId b) const {
  return a == b || (compare_slopes(a, b) == Sign::zero && exact_side_of_support_point(a, b) == Sign::zero);
}

Sign LinearFamily::exact_compare(const Point& p, const Point& q, bool by_y) const {
  if (!p.is_explicit() && p.first == q.first && p.second == q.second) return Sign::zero;
  const auto formula = [&](const auto& read, const auto&...) {
    return detail::compare_coordinate(read.point(p), read.point(q), by_y);
  };
  if (is_rational(p) || is_rational(q)) return formula(LinearReader<RationalCallNumbers>(*this));
  CallValues values;
  for (const Point* point : {&p, &q}) {
    if (!point->is_crossing()) {
      values.add({point->x, point->y});
      continue;
    }
    for (const std::uint32_t index : {point->first, point->second}) {
      const Line& line = lines_[index];
      values.add({line.ax, line.ay});
      values.add({line.bx, line.by});
    }
  }
  return on_grid(*this, values, formula);
}

Sign LinearFamily::compare_x(const Point& p, const Point& q) const {
  if (std::fabs(p.x - q.x) > comparison_bound(p.x, q.x)) return sign_of(p.x - q.x);
  const bool exact = !is_rational(p) && !is_rational(q) && !p.is_crossing() && !q.is_crossing();
  return exact ? sign_of(p.x - q.x) : exact_compare(p, q, false);
}

Sign LinearFamily::compare_xy_slowly(const Point& p, const Point& q) const {
  const auto rank = [&](const Point& r) { return side(r) == Side::left ? 0 : side(r) == Side::right ? 2 : 1; };
  if (rank(p) != rank(q)) return rank(p) < rank(q) ? Sign::negative : Sign::positive;
  if (rank(p) != 1) return compare_at_infinity(BranchId(p.first), BranchId(q.first), side(p));
  const Sign by_x = compare_x(p, q);
  if (by_x != Sign::zero) return by_x;
  const auto level = [&](const Point& r) { return side(r) == Side::bottom ? -1 : side(r) == Side::top ? 1 : 0; };
  if (level(p) != level(q)) return level(p) < level(q) ? Sign::negative : Sign::positive;
  if (level(p) != 0) return Sign::zero;
  if (std::fabs(p.y - q.y) > comparison_bound(p.y, q.y)) return sign_of(p.y - q.y);
  return p.is_explicit() && q.is_explicit() ? sign_of(p.y - q.y) : exact_compare(p, q, true);
}

Sign LinearFamily::compare_y_at_x_slowly(const Point& p, BranchId b) const {
  switch (side(p)) {
    case Side::interior:
      return exact_side(p, b);
    case Side::left:
    case Side::right:
      return compare_at_infinity(BranchId(p.first), b, side(p));
    case Side::bottom:
      return is_vertical(b) ? Sign::zero : Sign::negative;
    case Side::top:
      return is_vertical(b) ? Sign::zero : Sign::positive;
  }
  return Sign::zero;
}

bool LinearFamily::first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end,
                                 Sign ends, Point& out) const {
  // Lines cross once: they do so to the right of where `lower` is below if the earlier end is on the other side.
  if (ends == Sign::zero) return false;
  const bool crosses = ends == Sign::negative ? compare_y_at_x(lower_end, upper) == Sign::positive
                                              : compare_y_at_x(upper_end, lower) == Sign::negative;
  if (crosses) out = crossing(lower, upper);
  return crosses;
}

void LinearFamily::meetings(BranchId a, BranchId b, std::vector<Meeting<Point>>& out) const {
  if (compare_slopes(a, b) != Sign::zero) out.push_back({crossing(a, b), true});
}

double LinearFamily::sweep_key(const Point& p) const {
  if (side(p) == Side::left) return -infinity;
  if (side(p) == Side::right) return infinity;
  return p.x;
}

LinearFamily::Shift LinearFamily::absorb(const LinearFamily& other) {
  const Shift shift{static_cast<std::uint32_t>(lines_.size()), static_cast<std::uint32_t>(rationals_.size())};
  if (lines_.size() + other.lines_.size() >= LinearPoint::explicit_tag) {
    throw InputError("more lines than an arrangement holds");
  }
  if (other.is_rounded_ && !is_rounded_) rational_of_line_.assign(lines_.size(), no_rational);
  is_rounded_ = is_rounded_ || other.is_rounded_;
  lines_.insert(lines_.end(), other.lines_.begin(), other.lines_.end());
  rationals_.insert(rationals_.end(), other.rationals_.begin(), other.rationals_.end());
  if (is_rounded_) {
    for (std::size_t i = 0; i < other.lines_.size(); ++i) {
      const std::uint32_t index = other.is_rounded_ ? other.rational_of_line_[i] : no_rational;
      rational_of_line_.push_back(index == no_rational ? index : index + shift.rationals);
    }
  }
  size_ = std::max(size_, other.size_);
  error_ = std::max(error_, other.error_);
  return shift;
}

LinearPoint LinearFamily::shifted(const Point& p, const Shift& shift) {
  LinearPoint result = p;
  if (p.is_crossing()) {
    result.first += shift.supports;
    result.second += shift.supports;
  } else if (p.second == LinearPoint::rational_tag) {
    result.first += shift.rationals;
  } else if (p.is_end()) {
    result.first += shift.supports;
  }
  return result;
}

}  // namespace quoin
