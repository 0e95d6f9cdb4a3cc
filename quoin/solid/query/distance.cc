// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/distance.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/solid/query/boundary_distance.h"
#include "quoin/solid/query/point_location.h"

namespace quoin {

namespace {

/// Of boundaries that do not meet: whether any shell of one is inside the other.
bool has_shell_inside(const Brep& shells, const Brep& solid, const Context& context) {
  const SolidLocator locator(solid, context);
  std::vector<bool> is_seen(shells.shells.size(), false);
  for (std::uint32_t f = 0; f < shells.face_count(); ++f) {
    if (is_seen[shells.face_shells[f]]) continue;
    is_seen[shells.face_shells[f]] = true;
    context.poll();
    const PointId corner = shells.loop(shells.face_first_loop[f])[0];
    if (locator.locate(shells.points.exact(corner)).place == Place::in) return true;
  }
  return false;
}

}  // namespace

SolidDistance solid_distance(const Solid& a, const Solid& b, const Context& context) {
  if (a.is_empty() || b.is_empty()) throw InputError("an empty solid has no distance from another");
  SolidDistance result;
  const Brep& in_a = a.boundary();
  const Brep& in_b = b.boundary();
  if (in_a.face_count() == 0 || in_b.face_count() == 0) {  // all of space
    result.relation = Interference::overlapping;
    return result;
  }
  BoundaryDistance nearest = boundary_distance(in_a, in_b, context);
  if (nearest.squared_distance.sign() == Sign::zero) {
    const std::array<Solid, 2> both{a, b};
    result.relation = intersect(both, context).is_empty() ? Interference::touching : Interference::overlapping;
  } else if (has_shell_inside(in_a, in_b, context) || has_shell_inside(in_b, in_a, context)) {
    result.relation = Interference::overlapping;
  }
  if (result.relation == Interference::overlapping) return result;
  result.squared_distance = std::move(nearest.squared_distance);
  result.witness = std::move(nearest.witness);
  return result;
}

}  // namespace quoin
