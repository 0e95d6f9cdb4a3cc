// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/notches.h"

#include <algorithm>
#include <utility>

namespace quoin {

namespace {

/// An edge as one face runs along it, with the face on its left.
struct FaceSide {
  std::uint32_t tail;
  std::uint32_t head;
  std::uint32_t face;
};

RationalPoint3 normal_of(const Brep& boundary, std::uint32_t face) {
  const auto& [a, b, c] = boundary.face_planes[face];
  const RationalPoint3 origin = boundary.points.exact(a);
  return cross(boundary.points.exact(b) - origin, boundary.points.exact(c) - origin);
}

/// Whether a face leaves an edge to the outer side of another one's plane. Mostly no corner of it lies there at all.
bool rises_above(const Brep& boundary, const FaceSide& side, std::uint32_t other) {
  const Constructions& points = boundary.points;
  const auto& [a, b, c] = boundary.face_planes[other];
  bool has_corner_above = false;
  for (std::uint32_t l = boundary.face_first_loop[side.face]; l < boundary.face_first_loop[side.face + 1]; ++l) {
    for (const PointId corner : boundary.loop(l)) {
      has_corner_above = has_corner_above || points.orientation_any(a, b, c, corner) == Sign::positive;
    }
  }
  if (!has_corner_above) return false;
  const RationalPoint3 along =
      points.exact(PointId(std::size_t{side.head})) - points.exact(PointId(std::size_t{side.tail}));
  return dot(normal_of(boundary, other), cross(normal_of(boundary, side.face), along)).sign() == Sign::positive;
}

std::vector<FaceSide> sides_of_faces(const Brep& boundary) {
  std::vector<FaceSide> sides;
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    for (std::uint32_t l = boundary.face_first_loop[f]; l < boundary.face_first_loop[f + 1]; ++l) {
      const auto loop = boundary.loop(l);
      if (loop.size() < 2) continue;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        sides.push_back({static_cast<std::uint32_t>(loop[i].index()),
                         static_cast<std::uint32_t>(loop[(i + 1) % loop.size()].index()), f});
      }
    }
  }
  return sides;
}

}  // namespace

std::vector<Notch> find_notches(const Brep& boundary, const Context& context) {
  std::vector<FaceSide> sides = sides_of_faces(boundary);
  const auto ends = [](const FaceSide& s) { return std::minmax(s.tail, s.head); };
  std::ranges::sort(sides, [&](const FaceSide& a, const FaceSide& b) {
    return std::pair(ends(a), a.face) < std::pair(ends(b), b.face);
  });
  std::vector<Notch> notches;
  for (std::size_t first = 0; first < sides.size();) {
    context.poll();
    std::size_t end = first + 1;
    while (end < sides.size() && ends(sides[end]) == ends(sides[first])) ++end;
    // Where several faces meet, the solid is reflex between some of them.
    if (end > first + 2 || (end == first + 2 && rises_above(boundary, sides[first], sides[first + 1].face))) {
      Notch notch{
          PointId(std::size_t{sides[first].tail}), PointId(std::size_t{sides[first].head}), {}, end == first + 2};
      for (std::size_t i = first; i < end; ++i) {
        if (notch.faces.empty() || notch.faces.back() != sides[i].face) notch.faces.push_back(sides[i].face);
      }
      notches.push_back(std::move(notch));
    }
    first = end;
  }
  return notches;
}

}  // namespace quoin
