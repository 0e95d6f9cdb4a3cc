// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <utility>

#include "quoin/arrangement/circular/circular_exact.h"
#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/number/error_free.h"

// Crossings of supports, in doubles with a bound of their error. The formulas are those of circular_kernel.h. Written
// e(x) for the error of x, M for the magnitude (largest coordinate or radius) and u for 2^-53; second-order terms are
// in the slack of each constant. A crossing is certified if its error is below error() = 2^-46 M = 128 u M.
namespace quoin {
namespace {

constexpr double u = 0x1p-53;

}  // namespace

/// Differences d = c2 - c1 have a relative error of u, or 2u with tails, d.d of 5u, q = r1^2 - r2^2, from squares with
/// their tails, of 3u, so that
///   e(k) <= 6u d.d + 4u |q| + u |k| < 8u (d.d + |q|),
///   e(D) <= 2 |k| e(k) + e(k)^2 + 9u 4 d.d r1^2 + 2u (4 d.d r1^2 + k^2) < 4 |k| e(k) + 48u d.d r1^2.
/// Beyond the tails: rational differences err by 3u^2 M more, d.d by 9u^2 M d, q by 4u^2 (r1^2 + r2^2);
/// with L = u (r1^2 + r2^2 + M d) that adds 16u L to e(k) and 64u r1^2 L to e(D).
/// The middle c1 + k d / (2 d.d) and the half D^(1/2) d' / (2 d.d) have lengths that are legs of a triangle with the
/// hypotenuse r1. Their errors: e(k) / (2 d), e(D) / (2 d (D^(1/2) + (D - e(D))^(1/2))) < 0.3 e(D) / (d D^(1/2)) for
/// e(D) < D / 2, roundings below 30u M, and of a rational centre 32 u^2 M r1 / d.
CircularFamily::Certainty CircularFamily::cross_circles(const CircularSupport& a, const CircularSupport& b,
                                                        RoundedCrossing& out) const {
  const bool rational = a.is_rational() || b.is_rational();
  const double dx = (b.x - a.x) + (b.x_tail - a.x_tail);
  const double dy = (b.y - a.y) + (b.y_tail - a.y_tail);
  const double d2 = dx * dx + dy * dy;
  const double r2 = a.squared_radius;
  const double q = (r2 - b.squared_radius) + (a.squared_radius_tail - b.squared_radius_tail);
  const double k = d2 + q;
  const double product = 4 * d2 * r2;
  const double discriminant = product - k * k;
  double error_k = 8 * u * (d2 + std::fabs(q));
  double error_d = 4 * std::fabs(k) * error_k + 12 * u * product;
  const double tails =
      16 * u * u * (r2 + b.squared_radius + (rational ? magnitude_ * (std::sqrt(d2) + u * magnitude_) : 0));
  error_d += 4 * (std::fabs(k) + tails + r2) * tails;
  error_k += tails;
  if (discriminant < -error_d) return Certainty::none;
  if (!(discriminant > 2 * error_d)) return Certainty::unknown;
  const double root = std::sqrt(discriminant);
  const double d = std::sqrt(d2);
  double error = 0.5 * error_k + 0.3 * error_d / root + 40 * u * magnitude_ * d;
  if (rational) {
    error += 32 * u * u * magnitude_ * a.radius;
    if (std::fabs(dy) < 8 * u * u * magnitude_) return Certainty::unknown;  // its sign
  }
  if (!(error < 126 * u * magnitude_ * d)) return Certainty::unknown;
  const double scale = 0.5 / d2;
  const double along = k * scale;
  const double across = dy > 0 || (dy == 0 && dx < 0) ? -root * scale : root * scale;
  out = {a.x + along * dx, a.y + along * dy, -across * dy, across * dx};
  return Certainty::certified;
}

/// n = e x w with e within u and w = c - p within 2u of themselves: e(n) <= 5u (|e.x w.y| + |e.y w.x|) + u |n|, and if
/// one of them is rational 4u^2 M (|e.x| + |e.y|) more. e.e has 4u, r^2 has u: e(D) < 8u r^2 e.e + 3 |n| e(n) + 2
/// e(n)^2. Middle and half err by e(n) / |e|, 0.6 e(D) / (D^(1/2) |e|) and roundings below 30u M.
CircularFamily::Certainty CircularFamily::cross_circle_line(const CircularSupport& circle, const CircularSupport& line,
                                                            RoundedCrossing& out) const {
  const double dx = line.dx;
  const double dy = line.dy;
  const double left = dx * ((circle.y - line.y) + (circle.y_tail - line.y_tail));
  const double right = dy * ((circle.x - line.x) + (circle.x_tail - line.x_tail));
  const double n = left - right;
  const double d2 = dx * dx + dy * dy;
  const double product = circle.squared_radius * d2;
  const double discriminant = product - n * n;
  double error_n = 7 * u * (std::fabs(left) + std::fabs(right));
  if (circle.is_rational() || line.is_rational()) error_n += 8 * u * u * magnitude_ * (std::fabs(dx) + std::fabs(dy));
  const double error_d = 12 * u * product + (3 * std::fabs(n) + 2 * error_n) * error_n;
  if (discriminant < -error_d) return Certainty::none;
  if (!(discriminant > 2 * error_d)) return Certainty::unknown;
  const double root = std::sqrt(discriminant);
  const double length = std::sqrt(d2);
  if (!(error_n + 0.6 * error_d / root < 86 * u * magnitude_ * length)) return Certainty::unknown;
  const double along = n / d2;
  const double across = root / d2;
  out = {circle.x + along * dy, circle.y - along * dx, across * dx, across * dy};
  return Certainty::certified;
}

/// Of (p, e) and (q, f): at p + t e, t = ((q - p) x f) / (e x f). Numerator N and denominator D err like n above;
/// e(t) <= (e(N) + |t| e(D)) / (|D| - e(D)) + u |t|.
CircularFamily::Certainty CircularFamily::cross_lines(const CircularSupport& a, const CircularSupport& b,
                                                      RoundedCrossing& out) const {
  const double left = a.dx * b.dy;
  const double right = a.dy * b.dx;
  const double d = left - right;
  const double error_d = 6 * u * (std::fabs(left) + std::fabs(right));
  if (!(std::fabs(d) > 4 * error_d)) return Certainty::unknown;
  const double up = ((b.x - a.x) + (b.x_tail - a.x_tail)) * b.dy;
  const double down = ((b.y - a.y) + (b.y_tail - a.y_tail)) * b.dx;
  double error_n = 7 * u * (std::fabs(up) + std::fabs(down));
  if (a.is_rational() || b.is_rational()) error_n += 8 * u * u * magnitude_ * (std::fabs(b.dx) + std::fabs(b.dy));
  const double t = (up - down) / d;
  const double size = std::fabs(a.dx) + std::fabs(a.dy);
  const double error_t = 1.4 * (error_n + std::fabs(t) * error_d) / std::fabs(d) + 4 * u * std::fabs(t);
  const double x = a.x + t * a.dx;
  const double y = a.y + t * a.dy;
  if (!(size * error_t + 2 * u * (std::fabs(x) + std::fabs(y)) < 120 * u * magnitude_)) return Certainty::unknown;
  out = {x, y, 0, 0};
  return Certainty::certified;
}

CircularPoint CircularFamily::crossing_point(std::uint32_t a, std::uint32_t b, int root,
                                             const RoundedCrossing& numbers) const {
  Point p;
  p.kind = CircularPointKind::crossing;
  p.first = a;
  p.second = b;
  p.root = static_cast<std::int8_t>(root);
  p.x = numbers.middle_x + root * numbers.half_x;
  p.y = numbers.middle_y + root * numbers.half_y;
  p.exact_x = false;
  p.exact_y = false;
  for (const std::uint32_t id : {a, b}) {
    const CircularSupport& s = pools_.supports[id];
    if (s.form != CircularForm::segment || std::isnan(p.x)) continue;
    if (s.vertical) {
      p.x = s.x;
      p.exact_x = true;
    } else if (s.dy == 0) {
      p.y = s.y;
      p.exact_y = true;
    }
  }
  if (!pools_.supports[a].is_line()) p.half_first = static_cast<std::int8_t>(find_half(p, a));
  if (!pools_.supports[b].is_line()) p.half_second = static_cast<std::int8_t>(find_half(p, b));
  return p;
}

/// a < b.
CircularFamily::Certainty CircularFamily::cross(std::uint32_t a, std::uint32_t b, RoundedCrossing& out) const {
  const CircularSupport& one = pools_.supports[a];
  const CircularSupport& two = pools_.supports[b];
  if (!one.is_line() && !two.is_line()) return cross_circles(one, two, out);
  if (one.is_line() && two.is_line()) return cross_lines(one, two, out);
  return one.is_line() ? cross_circle_line(two, one, out) : cross_circle_line(one, two, out);
}

/// How many crossings there are, for supports a < b of which the filter does not know.
int CircularFamily::cross_exactly(std::uint32_t a, std::uint32_t b, RoundedCrossing& out) const {
  const circular_exact::Crossing exact = circular_exact::crossing(pools_, a, b);
  if (exact.discriminant == Sign::negative) return 0;
  out = {exact.middle_x, exact.middle_y, exact.half_x, exact.half_y};
  if (!exact.in_range || !(std::fabs(exact.middle_x) <= 5 * magnitude_) ||
      !(std::fabs(exact.middle_y) <= 5 * magnitude_)) {
    out.middle_x = out.middle_y = std::numeric_limits<double>::quiet_NaN();
  }
  return exact.discriminant == Sign::positive ? 2 : 1;
}

int CircularFamily::crossings(CircularSupportId first, CircularSupportId second, Point out[2]) const {
  auto a = static_cast<std::uint32_t>(first.index());
  auto b = static_cast<std::uint32_t>(second.index());
  if (b < a) std::swap(a, b);
  RoundedCrossing numbers;
  const Certainty certainty = cross(a, b, numbers);
  if (certainty == Certainty::none) return 0;
  int count = is_line(first) && is_line(second) ? 1 : 2;
  if (certainty == Certainty::unknown) count = cross_exactly(a, b, numbers);
  if (count == 1) out[0] = crossing_point(a, b, 0, numbers);
  if (count == 2) {
    out[0] = crossing_point(a, b, -1, numbers);
    out[1] = crossing_point(a, b, +1, numbers);
  }
  return count;
}

CircularPoint CircularFamily::extreme(CircularSupportId circle, bool right) const {
  const CircularSupport& s = pools_.supports[circle.index()];
  const TwoDoubles x = two_sum(s.x, right ? s.radius : -s.radius);
  Point p;
  p.x = x.value;
  p.y = s.y;
  p.first = static_cast<std::uint32_t>(circle.index());
  p.exact_y = !s.is_rational();
  p.exact_x = s.form == CircularForm::radius && x.tail == 0;
  if (!p.exact_x) {
    p.kind = CircularPointKind::extreme;
    p.root = right ? 1 : -1;
  }
  return p;
}

/// Of a crossing of the support of the branch.
bool CircularFamily::is_on(const Point& p, BranchId branch) const {
  if (is_line(branch)) return true;
  const Sign half = compare_y_to_centre(p, static_cast<std::uint32_t>(support(branch).index()));
  return half == Sign::zero || (half == Sign::positive) == is_upper(branch);
}

int CircularFamily::common_points(BranchId a, BranchId b, Point out[2]) const {
  const CircularSupportId one = support(a);
  const CircularSupportId two = support(b);
  const bool circles = !is_line(a) && !is_line(b);
  int count = one == two ? 0 : crossings(one, two, out);
  if (count == 0 && circles && is_upper(a) != is_upper(b) &&
      same_support(static_cast<std::uint32_t>(one.index()), static_cast<std::uint32_t>(two.index()))) {
    out[0] = extreme(one, false);
    out[1] = extreme(one, true);
    return 2;
  }
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    if (is_on(out[i], a) && is_on(out[i], b)) out[kept++] = out[i];
  }
  return kept;
}

/// A crossing that is evidently on other halves than these branches, or not between the abscissae.
bool CircularFamily::misses(const RoundedCrossing& numbers, int root, BranchId lower, BranchId upper, double from,
                            double to) const {
  const double x = numbers.middle_x + root * numbers.half_x;
  if (x < from - 2 * error_ || x > to + 2 * error_) return true;
  const double y = numbers.middle_y + root * numbers.half_y;
  for (const BranchId branch : {lower, upper}) {
    const CircularSupport& s = support_of(branch);
    if (s.is_line()) continue;
    const double height = is_upper(branch) ? y - s.y : s.y - y;
    if (height < -1.1 * error_) return true;
  }
  return false;
}

/// Everything that doubles can exclude is excluded before a point is made: most calls find nothing.
bool CircularFamily::first_meeting(BranchId lower, const Point& lower_end, BranchId upper, const Point& upper_end,
                                   const Point& after, Point& out) const {
  auto a = static_cast<std::uint32_t>(support(lower).index());
  auto b = static_cast<std::uint32_t>(support(upper).index());
  if (b < a) std::swap(a, b);
  const bool from_crossing = after.kind == CircularPointKind::crossing && after.first == a && after.second == b;
  if (from_crossing && after.root >= 0) return false;
  RoundedCrossing numbers;
  const Certainty certainty = a == b ? Certainty::unknown : cross(a, b, numbers);
  if (certainty == Certainty::none) return false;
  if (certainty == Certainty::certified) {
    const int last = is_line(lower) && is_line(upper) ? 0 : 1;
    const double end = std::fmin(lower_end.x, upper_end.x);
    for (int root = from_crossing ? 1 : -last; root <= last; root += 2) {
      if (misses(numbers, root, lower, upper, after.x, end)) continue;
      const Point p = crossing_point(a, b, root, numbers);
      if (!is_on(p, lower) || !is_on(p, upper) || compare_xy(p, after) != Sign::positive) continue;
      if (compare_xy(p, lower_end) != Sign::negative || compare_xy(p, upper_end) != Sign::negative) return false;
      out = p;
      return true;
    }
    return false;
  }
  Point common[2];
  const int count = common_points(lower, upper, common);
  for (int i = 0; i < count; ++i) {
    if (compare_xy(common[i], after) != Sign::positive) continue;
    if (compare_xy(common[i], lower_end) != Sign::negative) return false;
    if (compare_xy(common[i], upper_end) != Sign::negative) return false;
    out = common[i];
    return true;
  }
  return false;
}

void CircularFamily::meetings(BranchId a, BranchId b, std::vector<Meeting<Point>>& out) const {
  Point common[2];
  const int count = common_points(a, b, common);
  const bool lines = is_line(a) && is_line(b);
  for (int i = 0; i < count; ++i) {
    const bool touches = common[i].kind != CircularPointKind::crossing || common[i].root == 0;
    out.push_back({common[i], lines || !touches});
  }
}

}  // namespace quoin
