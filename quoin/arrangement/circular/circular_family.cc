// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_family.h"

#include <cmath>

#include "quoin/arrangement/circular/circular_exact.h"

namespace quoin {
namespace {

constexpr double u = 0x1p-53;
/// What products may lose below the range of doubles where a query brings tiny coordinates; no product of others is
/// that small.
constexpr double underflow = 0x1p-1000;

bool is_exact(const CircularPoint& p) {
  return p.kind == CircularPointKind::doubles;
}

/// The same crossing or extreme by definition.
bool same_definition(const CircularPoint& p, const CircularPoint& q) {
  return p.kind == q.kind && p.kind >= CircularPointKind::crossing && p.first == q.first && p.second == q.second &&
         p.kind != CircularPointKind::doubles;
}

}  // namespace

void CircularFamily::raise_magnitude(double value) {
  magnitude_ = std::max(magnitude_, std::fabs(value));
  error_ = 0x1p-46 * magnitude_;
}

// Order of points. Both doubles are within error_ of the truth, so a difference above 2 error_ (1 + 2u) is one; the
// certified errors stay a 2^-7 below error_, which pays for the roundings. NaN decides nothing.

Sign CircularFamily::compare_x(const Point& p, const Point& q) const {
  const double difference = p.x - q.x;
  if (difference > 2 * error_) return Sign::positive;
  if (difference < -2 * error_) return Sign::negative;
  if (p.exact_x && q.exact_x) return sign_of(difference);
  if (p.root == q.root && same_definition(p, q)) return Sign::zero;
  return circular_exact::compare_x(pools_, p, q);
}

Sign CircularFamily::compare_y(const Point& p, const Point& q) const {
  const double difference = p.y - q.y;
  if (difference > 2 * error_) return Sign::positive;
  if (difference < -2 * error_) return Sign::negative;
  if (p.exact_y && q.exact_y) return sign_of(difference);
  return circular_exact::compare_y(pools_, p, q);
}

Sign CircularFamily::compare_close(const Point& p, const Point& q) const {
  if (same_definition(p, q)) return sign_of(p.root - q.root);
  const Sign x = compare_x(p, q);
  return x != Sign::zero ? x : compare_y(p, q);
}

// A point against a support.

Sign CircularFamily::find_half(const Point& p, std::uint32_t circle) const {
  bool known = false;
  const Sign half = filtered_half(p, pools_.supports[circle], known);
  return known ? half : circular_exact::compare_y_to_centre(pools_, p, circle);
}

Sign CircularFamily::compare_y_to_centre(const Point& p, std::uint32_t circle) const {
  if (p.first == circle) return static_cast<Sign>(p.half_first);
  if (p.second == circle) return static_cast<Sign>(p.half_second);
  return find_half(p, circle);
}

/// Circle: x^2 + y^2 - r^2 for the differences x, y to the centre. If p and the centre are exact, the differences have
/// a relative error of u, their squares 3u, the sum 4u; r^2 has u: below 6u (x^2 + y^2 + r^2). Else both differences
/// err by e < 1.1 error_ besides (u magnitude_ of a rational centre included), which adds 2 e (|x| + |y|) + 2 e^2 by
/// the true |x|, |y|, at most e above the computed ones: below 2.2 error_ (|x| + |y|) + 8 error_^2. Line: dx y - dy x,
/// factors within u and u (or e) of themselves: products within 4u, the difference one more.
Sign CircularFamily::side_of(const Point& p, std::uint32_t support) const {
  if (p.first == support || p.second == support) return Sign::zero;
  const CircularSupport& s = pools_.supports[support];
  const double x = p.x - s.x;
  const double y = p.y - s.y;
  const double e = is_exact(p) && !s.is_rational() ? 0 : error_;
  double value = 0;
  double bound = 0;
  if (s.is_line()) {
    const double left = s.dx * y;
    const double right = s.dy * x;
    value = left - right;
    bound = 8 * u * (std::fabs(left) + std::fabs(right)) + 1.2 * e * (std::fabs(s.dx) + std::fabs(s.dy)) + underflow;
  } else {
    const double squares = x * x + y * y;
    value = squares - s.squared_radius;
    bound = 8 * u * (squares + s.squared_radius) + e * (2.3 * (std::fabs(x) + std::fabs(y)) + 8 * e);
  }
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return circular_exact::side(pools_, p, support);
}

Sign CircularFamily::compare_y_at_x(const Point& p, BranchId branch) const {
  const auto id = static_cast<std::uint32_t>(support(branch).index());
  const CircularSupport& s = pools_.supports[id];
  if (s.vertical) return Sign::zero;
  if (s.is_line()) return side_of(p, id);
  const Sign half = is_upper(branch) ? Sign::positive : Sign::negative;
  const bool incident = p.first == id || p.second == id;
  bool known = false;
  Sign p_half = incident ? compare_y_to_centre(p, id) : filtered_half(p, s, known);
  if (p_half == -half) return p_half;
  if (incident) return Sign::zero;
  const Sign side = side_of(p, id);
  if (side == Sign::negative) return -half;  // inside
  if (!known) p_half = find_half(p, id);
  if (p_half == -half) return p_half;
  return side * half;
}

// Order of branches at a common point.

/// Products of factors that are exact up to u, or up to 1.1 error_ (p), or up to 2u magnitude_ and u (differences of
/// rational centres).
Sign CircularFamily::turn(const Point& p, std::uint32_t a, std::uint32_t b) const {
  if (a == b) return Sign::zero;
  const CircularSupport& one = pools_.supports[a];
  const CircularSupport& two = pools_.supports[b];
  if (one.is_line() && !two.is_line()) return -turn(p, b, a);
  const bool line = two.is_line();
  const double dx = line ? two.dx : two.x - one.x;
  const double dy = line ? two.dy : two.y - one.y;
  const double size = std::fabs(dx) + std::fabs(dy);
  double left = 0;
  double right = 0;
  double bound = 0;
  if (one.is_line()) {
    left = dx * one.dy;
    right = dy * one.dx;
  } else {
    const bool loose = one.is_rational() || (!line && two.is_rational());
    const bool own = p.kind == CircularPointKind::crossing && p.root != 0 &&
                     ((p.first == a && p.second == b) || (p.first == b && p.second == a));
    // Tangents differ, and the root tells the side of the line of the centres, or the end of the chord.
    if (own && line) return static_cast<Sign>(p.root);
    if (own && (!loose || std::fabs(dy) > error_)) {
      const bool turned = dy > 0 || (dy == 0 && dx < 0);  // between them the direction changes its sign as well
      return static_cast<Sign>(turned ? p.root : -p.root);
    }
    if (!line && !loose && size == 0) return Sign::zero;
    const double x = p.x - one.x;
    const double y = p.y - one.y;
    left = line ? dx * x : x * dy;
    right = line ? -dy * y : y * dx;
    if (loose || !is_exact(p)) bound = 1.2 * error_ * size;
    if (loose) bound += 4 * u * magnitude_ * (std::fabs(x) + std::fabs(y) + 2 * error_);
  }
  bound += 8 * u * (std::fabs(left) + std::fabs(right)) + underflow;
  const double value = left - right;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return circular_exact::turn(pools_, p, a, b);
}

/// Where the branch goes straight up (+1) or down (-1) at p, seen from left to right.
int CircularFamily::vertical_direction(BranchId branch, const Point& p) const {
  const CircularSupport& s = support_of(branch);
  if (s.is_line()) return s.vertical ? 1 : 0;
  const CircularSupportId id = support(branch);
  if (compare_y_to_centre(p, static_cast<std::uint32_t>(id.index())) != Sign::zero) return 0;
  const bool left = compare_xy(p, extreme(id, false)) == Sign::zero;
  return left == is_upper(branch) ? 1 : -1;
}

/// Of tangents that run from left to right, from straight down to straight up.
Sign CircularFamily::compare_slopes(BranchId a, BranchId b, const Point& p) const {
  const bool flip_a = !is_line(a) && is_upper(a);
  const bool flip_b = !is_line(b) && is_upper(b);
  const Sign sign =
      turn(p, static_cast<std::uint32_t>(support(a).index()), static_cast<std::uint32_t>(support(b).index()));
  if (sign != Sign::zero) return flip_a == flip_b ? sign : -sign;
  return sign_of(vertical_direction(a, p) - vertical_direction(b, p));
}

Sign CircularFamily::compare_squared_radii(std::uint32_t a, std::uint32_t b) const {
  const CircularSupport& one = pools_.supports[a];
  const CircularSupport& two = pools_.supports[b];
  if (one.form == CircularForm::radius && two.form == CircularForm::radius) return sign_of(one.radius - two.radius);
  return (pools_.exact_circle(a).squared_radius - pools_.exact_circle(b).squared_radius).sign();
}

/// Branches with the same tangent: the one that bends more to the left of its direction lies above, on both sides.
Sign CircularFamily::compare_curvatures(BranchId a, BranchId b) const {
  const int bend_a = is_line(a) ? 0 : is_upper(a) ? -1 : 1;
  const int bend_b = is_line(b) ? 0 : is_upper(b) ? -1 : 1;
  if (bend_a != bend_b || bend_a == 0) return sign_of(bend_a - bend_b);
  const Sign larger = compare_squared_radii(static_cast<std::uint32_t>(support(a).index()),
                                            static_cast<std::uint32_t>(support(b).index()));
  return bend_a < 0 ? larger : -larger;
}

Sign CircularFamily::compare_right(BranchId a, BranchId b, const Point& p) const {
  if (a == b) return Sign::zero;
  const Sign slopes = compare_slopes(a, b, p);
  return slopes != Sign::zero ? slopes : compare_curvatures(a, b);
}

Sign CircularFamily::compare_left(BranchId a, BranchId b, const Point& p) const {
  if (a == b) return Sign::zero;
  const Sign slopes = compare_slopes(a, b, p);
  return slopes != Sign::zero ? -slopes : compare_curvatures(a, b);
}

bool CircularFamily::same_support(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return true;
  const CircularSupport& one = pools_.supports[a];
  const CircularSupport& two = pools_.supports[b];
  if (one.is_line() != two.is_line()) return false;
  if (one.is_line()) {
    const double left = one.dx * two.dy;
    const double right = one.dy * two.dx;
    if (std::fabs(left - right) > 8 * u * (std::fabs(left) + std::fabs(right))) return false;
  } else {
    const double slack = one.is_rational() || two.is_rational() ? error_ : 0;
    if (std::fabs(one.x - two.x) > slack || std::fabs(one.y - two.y) > slack) return false;
    if (std::fabs(one.radius - two.radius) > 8 * u * one.radius) return false;
  }
  return circular_exact::same_support(pools_, a, b);
}

bool CircularFamily::same_branch(BranchId a, BranchId b) const {
  if (a == b) return true;
  if (!is_line(a) && is_upper(a) != is_upper(b)) return false;
  return same_support(static_cast<std::uint32_t>(support(a).index()), static_cast<std::uint32_t>(support(b).index()));
}

// Rounding, and moving between families.

Point2 CircularFamily::position(const Point& p) const {
  if (!std::isnan(p.x)) return {p.x, p.y};
  const Point exact = circular_exact::approximate(pools_, p);
  return {exact.x, exact.y};
}

CircularFamily::Shift CircularFamily::absorb(const CircularFamily& other) {
  const Shift shift{static_cast<std::uint32_t>(pools_.supports.size()),
                    static_cast<std::uint32_t>(pools_.points.size())};
  const auto circles = static_cast<std::uint32_t>(pools_.circles.size());
  const auto lines = static_cast<std::uint32_t>(pools_.lines.size());
  const std::size_t count = other.pools_.supports.size();  // the other one may be this one
  for (std::size_t i = 0; i < count; ++i) {
    CircularSupport support = other.pools_.supports[i];
    support.rational += support.is_line() ? lines : circles;
    pools_.supports.push_back(support);
  }
  const auto append = [](auto& to, const auto& from) {
    const std::size_t size = from.size();
    to.reserve(to.size() + size);
    for (std::size_t i = 0; i < size; ++i) to.push_back(from[i]);
  };
  append(pools_.circles, other.pools_.circles);
  append(pools_.lines, other.pools_.lines);
  append(pools_.points, other.pools_.points);
  raise_magnitude(other.magnitude_);
  return shift;
}

CircularPoint CircularFamily::shifted(const Point& p, const Shift& shift) {
  Point result = p;
  if (p.first != Point::none) result.first += shift.supports;
  if (p.second != Point::none) result.second += shift.supports;
  if (p.rational != Point::none) result.rational += shift.points;
  return result;
}

}  // namespace quoin
