// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/ball.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/solid/shapes.h"

namespace quoin {

namespace {

void check_arguments(double radius, double tolerance) {
  if (!(radius >= 0x1p-300 && radius <= 0x1p300))
    throw InputError("the radius of a ball is not between 2^-300 and 2^300");
  if (!(tolerance > 0) || !std::isfinite(tolerance)) throw InputError("the tolerance of a ball is not above zero");
  if (!(tolerance >= radius * 0x1p-20)) throw InputError("the tolerance of a ball is below a millionth of its radius");
}

/// The least distance of a facet from the origin, as far as doubles tell.
double inner_radius(const ConvexHull& hull, const std::vector<Point3>& points) {
  double least = HUGE_VAL;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    const Point3& a = points[facet[0]];
    const Vector3 u{points[facet[1]].x - a.x, points[facet[1]].y - a.y, points[facet[1]].z - a.z};
    const Vector3 v{points[facet[2]].x - a.x, points[facet[2]].y - a.y, points[facet[2]].z - a.z};
    const Vector3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    least = std::min(least, (n.x * a.x + n.y * a.y + n.z * a.z) / std::hypot(n.x, n.y, n.z));
  }
  return least;
}

/// Whether the hull holds the ball of one radius and lies in that of another.
bool is_between(const ConvexHull& hull, const std::vector<Point3>& points, const Rational& inner,
                const Rational& outer) {
  for (const std::uint32_t v : hull.vertices) {
    const RationalPoint3 p = exact_point(points[v]);
    if (dot(p, p) > outer * outer) return false;
  }
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    const RationalPoint3 a = exact_point(points[facet[0]]);
    const RationalPoint3 n = cross(exact_point(points[facet[1]]) - a, exact_point(points[facet[2]]) - a);
    const Rational offset = dot(n, a);
    if (offset.sign() != Sign::positive || offset * offset < inner * inner * dot(n, n)) return false;
  }
  return true;
}

}  // namespace

Solid ball_polytope(double radius, double tolerance, BallSide side, const Context& context) {
  check_arguments(radius, tolerance);
  const bool is_within = side == BallSide::within;
  const Rational inner = is_within ? Rational(radius) - Rational(tolerance) : Rational(radius);
  const Rational outer = is_within ? Rational(radius) : Rational(radius) + Rational(tolerance);
  const double ratio = std::min(1.0, tolerance / radius);
  for (auto frequency = static_cast<std::size_t>(std::max(1.0, std::floor(std::sqrt(0.2 / ratio))));; ++frequency) {
    context.poll();
    std::vector<Point3> points = shapes::geodesic_sphere(frequency, 1).vertices;
    const double scale = is_within ? radius * (1 - 0x1p-45)
                                   : radius * (1 + 0x1p-45) / inner_radius(convex_hull(points, context), points);
    for (Point3& p : points) p = {p.x * scale, p.y * scale, p.z * scale};
    const ConvexHull hull = convex_hull(points, context);
    if (!is_between(hull, points, inner.sign() == Sign::positive ? inner : Rational(0), outer)) continue;
    return Solid::from_boundary(convex_boundary(hull, points, "ball"), "ball", context);
  }
}

}  // namespace quoin
