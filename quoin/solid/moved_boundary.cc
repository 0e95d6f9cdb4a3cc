// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/moved_boundary.h"

#include <cmath>
#include <utility>

namespace quoin {

namespace {

bool is_double(const RationalPoint3& p, const Point3& rounded) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(rounded[axis]) || Rational(rounded[axis]) != p[axis]) return false;
  }
  return true;
}

}  // namespace

Brep moved_boundary(const Brep& boundary, const RationalPoint3& by) {
  std::vector<RationalPoint3> exact;
  std::vector<Point3> rounded;
  bool are_doubles = true;
  for (std::size_t v = 0; v < boundary.points.point_count(); ++v) {
    exact.push_back(boundary.points.exact(PointId(v)) + by);
    const RationalPoint3& p = exact.back();
    rounded.push_back({p.x.to_double(), p.y.to_double(), p.z.to_double()});
    are_doubles = are_doubles && is_double(p, rounded.back());
  }
  Brep result;
  result.points = are_doubles ? Constructions(std::move(rounded)) : Constructions(std::move(exact));
  result.face_planes = boundary.face_planes;
  result.face_first_loop = boundary.face_first_loop;
  result.loop_begin = boundary.loop_begin;
  result.loop_vertices = boundary.loop_vertices;
  result.face_first_origin = boundary.face_first_origin;
  result.origins = boundary.origins;
  result.face_shells = boundary.face_shells;
  result.shells = boundary.shells;
  result.component_count = boundary.component_count;
  result.is_unbounded = boundary.is_unbounded;
  result.face_colors = boundary.face_colors;
  result.leaf_names = boundary.leaf_names;
  return result;
}

}  // namespace quoin
