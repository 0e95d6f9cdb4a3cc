// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/distance.h"

#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/solid/moved_boundary.h"

namespace quoin {

namespace {

/// Of boundaries that do not meet: whether any shell of one, moved, is inside the solid.
bool has_shell_inside(const Brep& shells, const RationalPoint3& by, const SolidLocator& solid, const Context& context) {
  std::vector<bool> is_seen(shells.shells.size(), false);
  for (std::uint32_t f = 0; f < shells.face_count(); ++f) {
    if (is_seen[shells.face_shells[f]]) continue;
    is_seen[shells.face_shells[f]] = true;
    context.poll();
    const PointId corner = shells.loop(shells.face_first_loop[f])[0];
    if (solid.locate(shells.points.exact(corner) + by).place == Place::in) return true;
  }
  return false;
}

Solid moved(const Solid& solid, const RationalPoint3& by, const Context& context) {
  if (by == RationalPoint3{0, 0, 0}) return solid;
  LeafResult leaf = make_leaf(moved_boundary(solid.boundary(), by), "moved", {}, context);
  if (!leaf.leaf) throw InternalError("a boundary that was moved is none");
  return solid.boundary().is_unbounded ? Solid::of_complement(std::move(leaf.leaf))
                                       : Solid::of_leaf(std::move(leaf.leaf));
}

}  // namespace

SolidProximity::SolidProximity(const Solid& a, const Solid& b, const Context& context) : a_(a), b_(b) {
  if (a.is_empty() || b.is_empty()) throw InputError("an empty solid has no distance from another");
  if (a.boundary().face_count() == 0 || b.boundary().face_count() == 0) return;
  boundaries_ = std::make_unique<const BoundaryProximity>(a_.boundary(), b_.boundary(), context);
  in_a_ = std::make_unique<const SolidLocator>(a_.boundary(), context);
  in_b_ = std::make_unique<const SolidLocator>(b_.boundary(), context);
}

bool SolidProximity::do_interiors_meet(const RationalPoint3& translation, const Context& context) const {
  const std::array<Solid, 2> both{moved(a_, translation, context), b_};
  return !intersect(both, context).is_empty();
}

SolidDistance SolidProximity::distance(const RationalPoint3& translation, const Context& context) const {
  SolidDistance result;
  result.relation = Interference::overlapping;
  if (!boundaries_) return result;
  BoundaryDistance nearest = boundaries_->distance(translation, context);
  if (nearest.squared_distance.sign() == Sign::zero) {
    if (nearest.is_crossing || do_interiors_meet(translation, context)) return result;
    result.relation = Interference::touching;
  } else {
    const RationalPoint3 back = translation * Rational(-1);
    if (has_shell_inside(a_.boundary(), translation, *in_b_, context) ||
        has_shell_inside(b_.boundary(), back, *in_a_, context)) {
      return result;
    }
    result.relation = Interference::apart;
  }
  result.squared_distance = std::move(nearest.squared_distance);
  result.witness = std::move(nearest.witness);
  return result;
}

SolidDistance solid_distance(const Solid& a, const Solid& b, const Context& context) {
  return SolidProximity(a, b, context).distance({0, 0, 0}, context);
}

}  // namespace quoin
