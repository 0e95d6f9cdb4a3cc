// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/box_bounds.h"

#include <algorithm>
#include <array>
#include <vector>

#include "quoin/polytope/minkowski_sum.h"

namespace quoin {

namespace {

Point3 corner(const Box3& box, unsigned number) {
  Point3 p;
  for (unsigned axis = 0; axis < 3; ++axis) p[axis] = ((number >> axis) & 1U) != 0 ? box.high()[axis] : box.low()[axis];
  return p;
}

std::vector<Point3> corners_of(const Box3& box, double sign) {
  std::vector<Point3> points;
  for (unsigned k = 0; k < 8; ++k) {
    const Point3 p = corner(box, k);
    points.push_back({sign * p.x, sign * p.y, sign * p.z});
  }
  return points;
}

}  // namespace

std::optional<ConvexRegion> project_boxes(const Box3& moving, const Box3& other, const Context& context) {
  const Polytope p = Polytope::hull_of(corners_of(other, 1), context);
  const Polytope q = Polytope::hull_of(corners_of(moving, -1), context);
  Projection projection = project(minkowski_sum(p, q, context), p, q);
  if (projection.place == OriginPlace::inside) return std::nullopt;
  return std::move(projection.region);
}

bool are_surely_covered(const Box3& moving, const Box3& other, std::span<const ConvexRegion> regions) {
  if (moving.overlaps(other)) return false;
  // The corners of the sum are differences of opposite corners.
  std::array<Vector3, 8> corners;
  for (unsigned k = 0; k < 8; ++k) {
    const Point3 to = corner(other, k);
    const Point3 from = corner(moving, 7 - k);
    corners[k] = {to.x - from.x, to.y - from.y, to.z - from.z};
  }
  return std::ranges::any_of(regions, [&](const ConvexRegion& region) {
    return std::ranges::all_of(corners, [&](const Vector3& c) {
      return std::ranges::all_of(region.normals, [&](const RegionDirection& n) { return n.is_surely_positive(c); });
    });
  });
}

}  // namespace quoin
