// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/arrangement/linear/linear_reader.h"

namespace quoin {

/// Turns a crossing into an explicit point if it is a pair of doubles of few digits; then comparisons with equal points
/// need no exact arithmetic.
bool LinearFamily::promote(Point& p) const {
  if (is_rounded_) return false;
  const double grid = 0x1p-23 * size_;  // rounding to it goes through the sum with 2^52 of its unit
  const double shift = std::ldexp(1.5, 52 + std::ilogb(grid));
  const double x = (p.x + shift) - shift;
  const double y = (p.y + shift) - shift;
  if (!(std::fabs(x - p.x) <= error_) || !(std::fabs(y - p.y) <= error_)) return false;
  const Point candidate{x, y, 0, LinearPoint::explicit_tag};
  if (compare_y_at_x(candidate, BranchId(p.first)) != Sign::zero) return false;
  if (compare_y_at_x(candidate, BranchId(p.second)) != Sign::zero) return false;
  p = candidate;
  return true;
}

/// With w = c - a, D = d x e, N = w x e of the lines (a, a + d) and (c, c + e), x = a + (N / D) d. D and N are off by 4
/// u of their terms' sizes (two rounded differences and the product, then the sum); so is t = N / D by (4 u |N terms| +
/// 4 u |t| |D terms|) / (|D| - 4 u |D terms|) + u |t|, and x by that times |dx|, 2 u |t dx| and u |x|.
LinearPoint LinearFamily::crossing(BranchId a, BranchId b) const {
  const Line& s = lines_[a.index()];
  const Line& t = lines_[b.index()];
  const bool is_given = !is_rational(a) && !is_rational(b);
  constexpr double u4 = 0x1.04p-51;
  const double dx = s.bx - s.ax;
  const double dy = s.by - s.ay;
  const double ex = t.bx - t.ax;
  const double ey = t.by - t.ay;
  const double wx = t.ax - s.ax;
  const double wy = t.ay - s.ay;
  const double d1 = dx * ey;
  const double d2 = dy * ex;
  const double n1 = wx * ey;
  const double n2 = wy * ex;
  const double denominator = d1 - d2;
  const double parameter = (n1 - n2) / denominator;
  LinearPoint p{s.ax + parameter * dx, s.ay + parameter * dy, std::min(a.value, b.value), std::max(a.value, b.value)};
  const double h = is_given ? 0 : 0x1.08p-52 * size_;
  const double reach = h * (std::fabs(dx) + std::fabs(dy) + std::fabs(ex) + std::fabs(ey) + 2 * h);
  const double size = u4 * (std::fabs(d1) + std::fabs(d2)) + reach;
  const double offset = u4 * (std::fabs(n1) + std::fabs(n2)) + reach + h * (std::fabs(wx) + std::fabs(wy));
  const double room = std::fabs(denominator) - size;
  const double doubt = (offset + std::fabs(parameter) * size) / room + 0x1.8p-51 * std::fabs(parameter);
  const double widest = std::max(std::fabs(dx), std::fabs(dy));
  const double error = doubt * (widest + h) + h * (1 + std::fabs(parameter));
  if (!(room > 0x1p-960) || !(error <= 0.5 * error_)) return exact_crossing(a, b);
  if (!is_given) return p;
  if (s.ax == s.bx) p.x = s.ax;
  if (t.ax == t.bx) p.x = t.ax;
  if (s.ay == s.by) p.y = s.ay;
  if (t.ay == t.by) p.y = t.ay;
  promote(p);
  return p;
}

LinearPoint LinearFamily::exact_crossing(BranchId a, BranchId b) const {
  LinearPoint p{0, 0, std::min(a.value, b.value), std::max(a.value, b.value)};
  if (is_rational(a) || is_rational(b)) {
    const auto exact = LinearReader<detail::RationalCallNumbers>(*this).point(p);
    p.x = detail::clamped_double(exact.x / exact.w);
    p.y = detail::clamped_double(exact.y / exact.w);
    return p;
  }
  detail::CallValues values;
  for (const BranchId id : {a, b}) {
    const Line& line = lines_[id.index()];
    values.add({line.ax, line.ay});
    values.add({line.bx, line.by});
  }
  detail::on_grid(*this, values, [&](const auto& read, const detail::CallGrid& grid) {
    const auto exact = read.point(p);
    p.x = values.values[0] + detail::rounded_quotient(exact.x, exact.w, grid.lo);
    p.y = values.values[1] + detail::rounded_quotient(exact.y, exact.w, grid.lo);
    return true;
  });
  constexpr double largest = std::numeric_limits<double>::max();
  p.x = std::clamp(p.x, -largest, largest);
  p.y = std::clamp(p.y, -largest, largest);
  promote(p);
  return p;
}

RationalPoint2 LinearFamily::exact(const Point& p) const {
  const auto point = LinearReader<detail::RationalCallNumbers>(*this).point(p);
  return {point.x / point.w, point.y / point.w};
}

}  // namespace quoin
