// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/affine_basis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

Point2 without(const Point3& p, unsigned axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

}  // namespace

unsigned normal_axis(const Point3& a, const Point3& b, const Point3& c) {
  unsigned axis = 0;
  while (axis < 3 && orientation(without(a, axis), without(b, axis), without(c, axis)) == Sign::zero) ++axis;
  return axis;
}

AffineBasis affine_basis(std::span<const Point3> points, const Context& context) {
  AffineBasis basis;
  basis.vertices.push_back(0);
  if (points.size() == 1) return basis;
  basis.vertices.push_back(1);
  std::uint32_t next = 2;
  for (; next < points.size(); ++next) {
    if (next % 1024 == 0) context.poll();
    basis.normal_axis = normal_axis(points[0], points[1], points[next]);
    if (basis.normal_axis < 3) break;
  }
  if (next == points.size()) return basis;
  basis.vertices.push_back(next);
  for (std::uint32_t last = next + 1; last < points.size(); ++last) {
    if (last % 1024 == 0) context.poll();
    if (orientation(points[0], points[1], points[next], points[last]) == Sign::zero) continue;
    basis.vertices.push_back(last);
    break;
  }
  return basis;
}

Point3 point_off_plane(std::span<const Point3> points, const AffineBasis& basis) {
  double size = 0;
  for (const Point3& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, std::fabs(p[axis] - points[0][axis]));
  }
  // The plane meets the line through a point of it along this axis nowhere else.
  Point3 apex = points[basis.vertices[0]];
  double& coordinate = apex[basis.normal_axis];
  const double moved = coordinate > 0 ? coordinate - size : coordinate + size;
  coordinate = std::isfinite(moved) && moved != coordinate ? moved : std::nextafter(coordinate, coordinate > 0 ? 0 : 1);
  return apex;
}

}  // namespace quoin
