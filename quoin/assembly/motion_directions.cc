// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quoin/assembly/motion_space.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

namespace {

RationalPoint3 rational_vector(const SphereDirection& d) {
  return {Rational(d.integer(0)), Rational(d.integer(1)), Rational(d.integer(2))};
}

SphereDirection direction_along(const RationalPoint3& v) {
  return std::array{v.x, v.y, v.z};
}

/// A sum of unit vectors as small integers; zero if they cancel.
SphereDirection rounded_sum(const Vector3& sum, double steps) {
  const double size = std::max({std::fabs(sum.x), std::fabs(sum.y), std::fabs(sum.z)});
  if (!(size > 0)) return Vector3{0, 0, 0};
  const double scale = steps / size;
  return Vector3{std::round(sum.x * scale), std::round(sum.y * scale), std::round(sum.z * scale)};
}

/// What bounds a face.
struct FaceBorder {
  std::vector<SphereDirection> inward;  ///< normals of its edges
  dcel::HalfedgeId first;               ///< none where it has no edge
  std::vector<SphereDirection> lone;    ///< isolated vertices
  Vector3 corners{0, 0, 0};             ///< sum of the corners, about
  Vector3 normals{0, 0, 0};             ///< sum of the normals, about

  bool is_lone(const SphereDirection& d) const {
    return std::ranges::any_of(lone, [&](const SphereDirection& other) { return are_equal(other, d.primitive()); });
  }
  /// Enough, not needed: on the left of all edges.
  bool surely_holds(const SphereDirection& d) const {
    return d.is_valid() && !is_lone(d) &&
           std::ranges::all_of(inward, [&](const SphereDirection& n) { return dot_sign(n, d) == Sign::positive; });
  }
};

void add_unit(Vector3& sum, const SphereDirection& d) {
  const double x = Rational(d.integer(0)).to_double();
  const double y = Rational(d.integer(1)).to_double();
  const double z = Rational(d.integer(2)).to_double();
  const double length = std::hypot(x, y, z);
  sum = {sum.x + x / length, sum.y + y / length, sum.z + z / length};
}

FaceBorder border_of(const GeodesicArrangement& arrangement, dcel::FaceId f) {
  const dcel::Dcel& cells = arrangement.cells();
  const GeodesicFamily& family = arrangement.family();
  FaceBorder border;
  for (dcel::BoundaryId b = cells[f].first_boundary; !b.is_none(); b = cells[b].next) {
    const dcel::HalfedgeId first = cells[b].halfedge;
    if (border.first.is_none()) border.first = first;
    dcel::HalfedgeId h = first;
    do {
      const SphereDirection normal(family.normal(arrangement.branch(h.edge())));
      border.inward.push_back(h.is_forward() ? normal : -normal);
      add_unit(border.normals, border.inward.back());
      const Vector3 at = family.position(arrangement.point(cells.origin(h)));
      border.corners = {border.corners.x + at.x, border.corners.y + at.y, border.corners.z + at.z};
      h = cells.next(h);
    } while (h != first);
  }
  for (dcel::VertexId v = cells[f].first_isolated; !v.is_none(); v = cells[v].next_isolated) {
    border.lone.emplace_back(family.direction(arrangement.point(v)));
  }
  return border;
}

/// Of the whole sphere without some vertices.
SphereDirection direction_beside(const FaceBorder& border) {
  for (std::int64_t k = 0;; ++k) {
    SphereDirection d(std::array<std::int64_t, 3>{k, k * k, 1});
    if (!border.is_lone(d)) return d;
  }
}

/// Numbers of steps to round to: the first that stays inside is taken.
constexpr std::array steps_tried{1.0, 2.0, 4.0, 16.0, 256.0, 65536.0, 0x1p40};

}  // namespace

SphereDirection MotionSpace::direction_in(MotionCell cell) const {
  switch (cell.kind) {
    case MotionCell::Kind::vertex:
      return SphereDirection(arrangement_.family().direction(arrangement_.point(dcel::VertexId(std::size_t{cell.id}))));
    case MotionCell::Kind::edge:
      return direction_in_edge(dcel::EdgeId(std::size_t{cell.id})).primitive();
    case MotionCell::Kind::face:
      break;
  }
  return direction_in_face(dcel::FaceId(std::size_t{cell.id})).primitive();
}

/// An arc shorter than half a circle holds every positive combination of its ends; a longer one what is a quarter on
/// from its start.
SphereDirection MotionSpace::direction_in_edge(dcel::EdgeId e) const {
  const GeodesicFamily& family = arrangement_.family();
  const SphereDirection from(family.direction(arrangement_.left_point(e)));
  const SphereDirection to(family.direction(arrangement_.right_point(e)));
  const SphereDirection normal(family.normal(arrangement_.branch(e)));
  if (dot_sign(normal, cross(from, to)) != Sign::positive) return cross(normal, from);
  // Components of like size, so that the direction is not next to one of the ends.
  const int shift = static_cast<int>(to.bits()) - static_cast<int>(from.bits());
  const Rational factor = shift >= 0 ? Rational(Integer(1) << static_cast<std::size_t>(shift))
                                     : Rational(Integer(1), Integer(1) << static_cast<std::size_t>(-shift));
  return direction_along(rational_vector(from) * factor + rational_vector(to));
}

/// A direction on the left of all edges of the boundary is inside: on the way from it to a first edge, nothing of the
/// face's boundary is crossed. Where none of a few in the middle is that, from inside an edge of the boundary a step to
/// its left that meets the circle of no other edge.
SphereDirection MotionSpace::direction_in_face(dcel::FaceId f) const {
  const FaceBorder border = border_of(arrangement_, f);
  if (border.first.is_none()) return direction_beside(border);
  for (const double steps : steps_tried) {
    for (const Vector3& sum : {border.corners, border.normals}) {
      SphereDirection candidate = rounded_sum(sum, steps);
      if (border.surely_holds(candidate)) return candidate;
    }
  }
  const RationalPoint3 start = rational_vector(direction_in_edge(border.first.edge()));
  const RationalPoint3 step = rational_vector(border.inward[0]);
  Rational reach(1);
  for (const SphereDirection& n : border.inward) {
    const Rational along = dot(rational_vector(n), step);
    if (along.sign() == Sign::zero) continue;
    const Rational at = -dot(rational_vector(n), start) / along;
    if (at.sign() == Sign::positive && at < reach) reach = at;
  }
  for (;;) {
    reach /= Rational(2);
    SphereDirection result = direction_along(start + step * reach);
    if (!border.is_lone(result)) return result;
  }
}

}  // namespace quoin
