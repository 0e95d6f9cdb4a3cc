// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/interference.h"

#include <algorithm>
#include <array>

#include "quoin/solid/query/face_place.h"
#include "quoin/solid/query/point_location.h"

namespace quoin {

namespace {

// Whether an edge of one boundary meets a face of another. Boundaries that meet without an edge of one meeting a face
// of the other do not exist.
class EdgesAgainstFaces {
 public:
  EdgesAgainstFaces(const Brep& edges, const SolidLocator& faces, const Context& context)
      : edges_(edges), locator_(faces), faces_(faces.boundary()), context_(context) {}

  bool meet() {
    for (std::size_t l = 0; l < edges_.loop_count(); ++l) {
      if (l % 256 == 0) context_.poll();
      const std::span<const PointId> loop = edges_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (meets(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1])) return true;
      }
    }
    return false;
  }

 private:
  bool meets(PointId p, PointId q) {
    if (q < p) return false;  // the face on the other side has it the other way
    const Point3& a = edges_.points.rounded(p);
    const Point3& b = edges_.points.rounded(q);
    near_.clear();
    locator_.tree().tiles_in_box({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                                 {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}, near_);
    if (near_.empty()) return false;
    const PlacedPoint from(faces_.points, edges_.points.exact(p));
    const PlacedPoint to(faces_.points, edges_.points.exact(q));
    return std::any_of(near_.begin(), near_.end(), [&](std::uint32_t face) { return meets_face(from, to, face); });
  }

  bool meets_face(const PlacedPoint& from, const PlacedPoint& to, std::uint32_t face) const {
    const Sign from_side = side_of_face(faces_, face, from);
    const Sign to_side = side_of_face(faces_, face, to);
    if (from_side * to_side == Sign::positive) return false;
    const unsigned axis = projection_axis(faces_, face);
    const auto contains = [&](const PlacedPoint& point) {
      return place_in_face(faces_, face, point, axis).kind != FacePlace::Kind::outside;
    };
    if (from_side == Sign::zero && contains(from)) return true;
    if (to_side == Sign::zero && contains(to)) return true;
    if (from_side == Sign::zero && to_side == Sign::zero) return crosses_an_edge(from, to, face, axis);
    if (from_side == Sign::zero || to_side == Sign::zero) return false;
    return contains(PlacedPoint(faces_.points, meet_with_plane(from.exact(), to.exact(), face)));
  }

  RationalPoint3 meet_with_plane(const RationalPoint3& p, const RationalPoint3& q, std::uint32_t face) const {
    const auto& plane = faces_.face_planes[face];
    const RationalPoint3 a = faces_.points.exact(plane[0]);
    const RationalPoint3 normal = cross(faces_.points.exact(plane[1]) - a, faces_.points.exact(plane[2]) - a);
    const Rational before = dot(normal, p - a);
    return p + (q - p) * (before / (before - dot(normal, q - a)));
  }

  // Both ends lie in the face's plane, outside the face.
  bool crosses_an_edge(const PlacedPoint& from, const PlacedPoint& to, std::uint32_t face, unsigned axis) const {
    for (std::uint32_t l = faces_.face_first_loop[face]; l < faces_.face_first_loop[face + 1]; ++l) {
      const std::span<const PointId> loop = faces_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointId a = loop[i];
        const PointId b = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (from.turn(a, b, axis) * to.turn(a, b, axis) == Sign::positive) continue;
        const Sign left = projected_area(from.exact(), to.exact(), faces_.points.exact(a), axis).sign();
        const Sign right = projected_area(from.exact(), to.exact(), faces_.points.exact(b), axis).sign();
        if (left * right == Sign::negative) return true;
        if (left == Sign::zero && is_between(from, a, to)) return true;
      }
    }
    return false;
  }

  static bool is_between(const PlacedPoint& from, PointId p, const PlacedPoint& to) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (from.compare(p, axis) * to.compare(p, axis) == Sign::positive) return false;
    }
    return true;
  }

  const Brep& edges_;
  const SolidLocator& locator_;
  const Brep& faces_;
  const Context& context_;
  std::vector<std::uint32_t> near_;
};

bool boundaries_meet(const Brep& a, const Brep& b, const Context& context) {
  const SolidLocator in_a(a, context);
  const SolidLocator in_b(b, context);
  return EdgesAgainstFaces(a, in_b, context).meet() || EdgesAgainstFaces(b, in_a, context).meet();
}

}  // namespace

InterferenceReport interference(const Solid& a, const Solid& b, const Context& context) {
  InterferenceReport report;
  const std::array<Solid, 2> both{a, b};
  report.common = intersect(both, context);
  if (!report.common.is_empty()) {
    report.kind = Interference::overlapping;
  } else if (boundaries_meet(a.boundary(), b.boundary(), context)) {
    report.kind = Interference::touching;
  }
  return report;
}

}  // namespace quoin
