// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/face_place.h"

#include "quoin/kernel/projection.h"
#include "quoin/solid/polygon_interior.h"

namespace quoin {

namespace {

// One edge of a polygon against a point, in the projection on coordinates u and v.
class EdgeAgainstPoint {
 public:
  EdgeAgainstPoint(const PlacedPoint& point, PointId a, PointId b, unsigned axis)
      : point_(point),
        a_(a),
        b_(b),
        axis_(axis),
        a_u_(point.compare(a, (axis + 1) % 3)),
        b_u_(point.compare(b, (axis + 1) % 3)) {}

  // Both ends on one side of the line through the point along v.
  bool is_apart() const { return a_u_ == b_u_ && a_u_ != Sign::zero; }

  bool starts_at_point() const { return a_u_ == Sign::zero && v_sign(a_) == Sign::zero; }

  bool contains_point() const {
    if (a_u_ == Sign::zero && b_u_ == Sign::zero) return v_sign(a_) * v_sign(b_) == Sign::negative;
    return a_u_ * b_u_ == Sign::negative && turn() == Sign::zero;
  }

  // Crosses the ray from the point moved by (e, e^2) towards larger v.
  bool crosses_ray() const {
    const bool a_after = a_u_ == Sign::positive;
    const bool b_after = b_u_ == Sign::positive;
    if (a_after == b_after) return false;
    return turn_when_moved() == (b_after ? Sign::negative : Sign::positive);
  }

 private:
  Sign v_sign(PointId p) const { return point_.compare(p, (axis_ + 2) % 3); }
  Sign turn() const { return point_.turn(a_, b_, axis_); }

  // The moved point has u larger by e: on a rising edge (in the direction of larger u) it falls below the line.
  Sign turn_when_moved() const {
    const Sign sign = turn();
    if (sign != Sign::zero) return sign;
    const Sign a_v = v_sign(a_);
    const Sign b_v = v_sign(b_);
    // The point lies on the edge's line and a, b differ in u. Of two ends on different sides, or one at the point, the
    // signs tell the slope; with both on one side or both level they are compared.
    const Sign rise = slope_of_rise(a_v, b_v);
    if (rise != Sign::zero) return -rise;
    return b_u_ == Sign::positive ? Sign::positive : Sign::negative;
  }

  // Sign of b.v - a.v. The u ranges touch the point's u, so the point is between a and b or one of them.
  static Sign slope_of_rise(Sign a_v, Sign b_v) {
    if (a_v == b_v) return Sign::zero;  // only zero and zero: the point lies between the ends
    return to_int(b_v) > to_int(a_v) ? Sign::positive : Sign::negative;
  }

  const PlacedPoint& point_;
  PointId a_;
  PointId b_;
  unsigned axis_;
  Sign a_u_;
  Sign b_u_;
};

}  // namespace

unsigned projection_axis(const Brep& boundary, std::uint32_t face) {
  const auto& plane = boundary.face_planes[face];
  return projection_axis(boundary.points, plane[0], plane[1], plane[2]);
}

FacePlace place_in_face(const Brep& boundary, std::uint32_t face, const PlacedPoint& point, unsigned axis) {
  FacePlace place{FacePlace::Kind::outside, {}, {}, false};
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    const std::span<const PointId> loop = boundary.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PointId a = loop[i];
      const PointId b = loop[i + 1 == loop.size() ? 0 : i + 1];
      const EdgeAgainstPoint edge(point, a, b, axis);
      if (edge.is_apart()) continue;
      if (edge.starts_at_point()) {
        place.kind = FacePlace::Kind::on_vertex;
        place.a = place.b = a;
      } else if (place.kind == FacePlace::Kind::outside && edge.contains_point()) {
        place.kind = FacePlace::Kind::on_edge;
        place.a = a;
        place.b = b;
      }
      if (edge.crosses_ray()) place.is_inside_when_moved = !place.is_inside_when_moved;
    }
  }
  if (place.kind == FacePlace::Kind::outside && place.is_inside_when_moved) place.kind = FacePlace::Kind::inside;
  return place;
}

Sign side_of_face(const Brep& boundary, std::uint32_t face, const PlacedPoint& point) {
  const auto& plane = boundary.face_planes[face];
  return point.side(plane[0], plane[1], plane[2]);
}

RationalPoint3 interior_point(const Brep& boundary, std::uint32_t face) {
  std::vector<std::span<const PointId>> loops;
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    loops.push_back(boundary.loop(l));
  }
  const auto& plane = boundary.face_planes[face];
  const unsigned axis = projection_axis(boundary, face);
  return interior_point(boundary.points, loops, axis, boundary.points.turn(plane[0], plane[1], plane[2], axis));
}

}  // namespace quoin
