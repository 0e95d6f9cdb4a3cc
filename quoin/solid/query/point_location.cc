// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/point_location.h"

#include <algorithm>

#include "quoin/base/parallel.h"
#include "quoin/solid/query/face_place.h"

namespace quoin {

namespace {

constexpr unsigned line_axis = 2;

std::vector<FloatBox> face_boxes(const Brep& boundary, const Context& context) {
  std::vector<FloatBox> boxes(boundary.face_count());
  for_each_chunk(context, boxes.size(), 4096, [&](const Chunk& chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f)
      boxes[f] = box_of_face(boundary, static_cast<std::uint32_t>(f));
  });
  return boxes;
}

}  // namespace

FloatBox box_of_face(const Brep& boundary, std::uint32_t face) {
  FloatBox box = empty_box();
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    for (const PointId p : boundary.loop(l)) extend(box, box_of(boundary.points.rounded(p)));
  }
  return box;
}

SolidLocator::SolidLocator(const Brep& boundary, const Context& context)
    : boundary_(boundary), tree_(face_boxes(boundary, context), context) {}

SolidLocation SolidLocator::locate(const Point3& point) const {
  return locate(RationalPoint3{point.x, point.y, point.z});
}

SolidLocation SolidLocator::locate(const RationalPoint3& point) const {
  const PlacedPoint placed(boundary_.points, point);
  const SolidLocation location = on_boundary(placed);
  if (is_on_boundary(location.place)) return location;
  return {is_inside(placed) ? Place::in : Place::out, SolidLocation::no_face, {}, {}};
}

// A vertex before an edge before a face, and the first face of each.
SolidLocation SolidLocator::on_boundary(const PlacedPoint& point) const {
  std::vector<std::uint32_t> near;
  tree_.tiles_in_box(point.rounded(), point.rounded(), near);
  std::sort(near.begin(), near.end());
  SolidLocation best;
  for (const std::uint32_t face : near) {
    if (side_of_face(boundary_, face, point) != Sign::zero) continue;
    const FacePlace place = place_in_face(boundary_, face, point, projection_axis(boundary_, face));
    if (place.kind == FacePlace::Kind::on_vertex) return {Place::on_vertex, face, place.a, place.a};
    if (place.kind == FacePlace::Kind::on_edge && best.place != Place::on_edge) {
      best = {Place::on_edge, face, std::min(place.a, place.b), std::max(place.a, place.b)};
    }
    if (place.kind == FacePlace::Kind::inside && best.place == Place::out) best = {Place::on_face, face, {}, {}};
  }
  return best;
}

// The point is not on the boundary. A face that the moved line meets is not parallel to it, and the point not on its
// plane: the line meets the face next to where it meets the plane.
bool SolidLocator::is_inside(const PlacedPoint& point) const {
  constexpr unsigned u = (line_axis + 1) % 3;
  constexpr unsigned v = (line_axis + 2) % 3;
  const std::array<double, 2> at{point.rounded()[u], point.rounded()[v]};
  std::vector<std::uint32_t> near;
  tree_.tiles_on_line(line_axis, at, at, near);
  bool inside = boundary_.is_unbounded;
  for (const std::uint32_t face : near) {
    if (!place_in_face(boundary_, face, point, line_axis).is_inside_when_moved) continue;
    const auto& plane = boundary_.face_planes[face];
    const Sign up = boundary_.points.turn(plane[0], plane[1], plane[2], line_axis);
    if (up * side_of_face(boundary_, face, point) == Sign::negative) inside = !inside;
  }
  return inside;
}

std::vector<SolidLocation> locate_all(const SolidLocator& locator, std::span<const Point3> points,
                                      const Context& context) {
  std::vector<SolidLocation> result(points.size());
  for_each_chunk(context, points.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) result[i] = locator.locate(points[i]);
  });
  return result;
}

}  // namespace quoin
