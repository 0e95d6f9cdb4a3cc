// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_rings.h"

#include <cmath>
#include <string>

#include "quoin/base/error.h"
#include "quoin/number/error_free.h"

namespace quoin::planar {

namespace {

Sign compare(const Rational& a, const Rational& b) {
  const auto order = a <=> b;
  return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

PlanarRing ring_of(const LinearArrangement& arrangement, const PolygonRing& ring) {
  std::vector<PlanarPoint> points;
  for (const dcel::HalfedgeId h : ring.halfedges) {
    const LinearPoint& point = arrangement.point(arrangement.cells().origin(h));
    points.push_back(point.is_explicit() ? PlanarPoint{{point.x, point.y}}
                                         : planar_point(arrangement.family().exact(point)));
  }
  PlanarRing result{{}, ring.is_hole};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlanarPoint& before = points[(i + points.size() - 1) % points.size()];
    const PlanarPoint& after = points[(i + 1) % points.size()];
    if (Direction::turn({before, points[i]}, {points[i], after}) != Sign::zero) result.points.push_back(points[i]);
  }
  return result;
}

}  // namespace

PlanarPoint planar_point(const RationalPoint2& point) {
  const Point2 rounded{point.x.to_double(), point.y.to_double()};
  const bool is_double = std::isfinite(rounded.x) && std::isfinite(rounded.y) && Rational(rounded.x) == point.x &&
                         Rational(rounded.y) == point.y;
  return is_double ? PlanarPoint{rounded} : PlanarPoint{rounded, point};
}

PlanarPoint sum(const PlanarPoint& a, const PlanarPoint& b) {
  if (a.is_double() && b.is_double()) {
    const TwoDoubles x = two_sum(a.rounded.x, b.rounded.x);
    const TwoDoubles y = two_sum(a.rounded.y, b.rounded.y);
    if (x.tail == 0 && y.tail == 0) return {{x.value, y.value}};  // tails of overflows are not numbers
  }
  const RationalPoint2 p = a.exact();
  const RationalPoint2 q = b.exact();
  return planar_point({p.x + q.x, p.y + q.y});
}

BranchId add_line(LinearFamily& family, const PlanarPoint& a, const PlanarPoint& b) {
  if (a.is_double() && b.is_double()) return family.add_line(a.rounded, b.rounded);
  return family.add_line(a.exact(), b.exact());
}

LinearFamily::Point add_point(LinearFamily& family, const PlanarPoint& point) {
  return point.is_double() ? LinearFamily::point(point.rounded) : family.point(*point.rational);
}

Direction::Direction(const PlanarPoint& from, const PlanarPoint& to) : from_(&from), to_(&to) {
  Sign y;
  if (from.is_double() && to.is_double()) {
    const TwoDoubles x_part = two_difference(to.rounded.x, from.rounded.x);
    const TwoDoubles y_part = two_difference(to.rounded.y, from.rounded.y);
    dx_ = x_part.value;
    dy_ = y_part.value;
    is_exact_ = x_part.tail == 0 && y_part.tail == 0;
    x_ = sign_of(dx_);
    y = sign_of(dy_);
  } else {
    const RationalPoint2 a = from.exact();
    const RationalPoint2 b = to.exact();
    dx_ = dy_ = std::nan("");
    x_ = planar::compare(b.x, a.x);
    y = planar::compare(b.y, a.y);
  }
  is_lower_ = y == Sign::negative || (y == Sign::zero && x_ == Sign::negative);
}

Sign Direction::compare(const Direction& a, const Direction& b) {
  if (a.is_lower_ != b.is_lower_) return a.is_lower_ ? Sign::positive : Sign::negative;
  return -turn(a, b);
}

/// Differences are off by u of their size, products by 3 u, their difference by 4 u of both.
Sign Direction::turn(const Direction& a, const Direction& b) {
  const double left = a.dx_ * b.dy_;
  const double right = a.dy_ * b.dx_;
  const double value = left - right;
  if (std::fabs(value) > 0x1p-50 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000) return sign_of(value);
  constexpr double small = 0x1p26;
  const auto is_small = [](double d) { return std::fabs(d) <= small && d == std::nearbyint(d); };
  if (a.is_exact_ && b.is_exact_ && is_small(a.dx_) && is_small(a.dy_) && is_small(b.dx_) && is_small(b.dy_)) {
    return sign_of(value);
  }
  return exact_turn(a, b);
}

Sign Direction::exact_turn(const Direction& a, const Direction& b) {
  const RationalPoint2 a0 = a.from_->exact();
  const RationalPoint2 a1 = a.to_->exact();
  const RationalPoint2 b0 = b.from_->exact();
  const RationalPoint2 b1 = b.to_->exact();
  return ((a1.x - a0.x) * (b1.y - b0.y) - (a1.y - a0.y) * (b1.x - b0.x)).sign();
}

std::vector<PlanarComponent> components_of(const LinearPolygonSet& set, const char* name) {
  if (set.is_unbounded()) throw InputError(std::string(name) + " is unbounded");
  const LinearPolygonSet regular = set.regularized();
  std::vector<PlanarComponent> result;
  for (const PolygonWithHoles& polygon : polygons_of(regular)) {
    PlanarComponent component;
    component.rings.push_back(ring_of(regular.arrangement(), polygon.outer));
    for (const PolygonRing& hole : polygon.holes) component.rings.push_back(ring_of(regular.arrangement(), hole));
    result.push_back(std::move(component));
  }
  return result;
}

Extent extent_of(const PlanarRing& ring) {
  RationalPoint2 low = ring.points[0].exact();
  RationalPoint2 high = low;
  for (const PlanarPoint& point : ring.points) {
    const RationalPoint2 p = point.exact();
    if (p.x < low.x) low.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.x > high.x) high.x = p.x;
    if (p.y > high.y) high.y = p.y;
  }
  return {high.x - low.x, high.y - low.y};
}

}  // namespace quoin::planar
