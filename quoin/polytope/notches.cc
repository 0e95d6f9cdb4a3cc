// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/notches.h"

#include <algorithm>
#include <span>
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

/// Whether a face leaves an edge to the outer side of another one's plane, by the direction in which it does.
bool goes_up(const Brep& boundary, const FaceSide& side, std::uint32_t other) {
  const Constructions& points = boundary.points;
  const RationalPoint3 along =
      points.exact(PointId(std::size_t{side.head})) - points.exact(PointId(std::size_t{side.tail}));
  return dot(normal_of(boundary, other), cross(normal_of(boundary, side.face), along)).sign() == Sign::positive;
}

/// Whether a face leaves an edge to the outer side of another one's plane. Mostly all its corners lie on one side; of
/// many, some are asked.
bool rises_above(const Brep& boundary, const FaceSide& side, std::uint32_t other) {
  const Constructions& points = boundary.points;
  const auto& [a, b, c] = boundary.face_planes[other];
  constexpr std::size_t most_asked = 16;
  std::size_t asked = 0;
  bool has_corner_above = false;
  bool has_corner_below = false;
  for (std::uint32_t l = boundary.face_first_loop[side.face]; l < boundary.face_first_loop[side.face + 1]; ++l) {
    for (const PointId corner : boundary.loop(l)) {
      if (corner.index() == side.tail || corner.index() == side.head) continue;
      if (++asked > most_asked || (has_corner_above && has_corner_below)) return goes_up(boundary, side, other);
      const Sign sign = points.orientation_any(a, b, c, corner);
      has_corner_above = has_corner_above || sign == Sign::positive;
      has_corner_below = has_corner_below || sign == Sign::negative;
    }
  }
  if (!has_corner_above || !has_corner_below) return has_corner_above;
  return goes_up(boundary, side, other);
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

/// Visits the sides of faces at each edge where the solid is not convex, until told to stop.
template <class Visit>
void for_each_notch(const Brep& boundary, const Context& context, const Visit& visit) {
  std::vector<FaceSide> sides = sides_of_faces(boundary);
  const auto ends = [](const FaceSide& s) { return std::minmax(s.tail, s.head); };
  std::size_t comparisons = 0;
  std::ranges::sort(sides, [&](const FaceSide& a, const FaceSide& b) {
    if (++comparisons % 65536 == 0) context.poll();
    return std::pair(ends(a), a.face) < std::pair(ends(b), b.face);
  });
  for (std::size_t first = 0; first < sides.size();) {
    context.poll();
    std::size_t end = first + 1;
    while (end < sides.size() && ends(sides[end]) == ends(sides[first])) ++end;
    // Where several faces meet, the solid is reflex between some of them.
    const bool is_notch =
        end > first + 2 || (end == first + 2 && rises_above(boundary, sides[first], sides[first + 1].face));
    if (is_notch && !visit(std::span<const FaceSide>(sides).subspan(first, end - first))) return;
    first = end;
  }
}

}  // namespace

std::vector<Notch> find_notches(const Brep& boundary, const Context& context) {
  std::vector<Notch> notches;
  for_each_notch(boundary, context, [&](std::span<const FaceSide> sides) {
    Notch notch{PointId(std::size_t{sides[0].tail}), PointId(std::size_t{sides[0].head}), {}, sides.size() == 2};
    for (const FaceSide& side : sides) {
      if (notch.faces.empty() || notch.faces.back() != side.face) notch.faces.push_back(side.face);
    }
    notches.push_back(std::move(notch));
    return true;
  });
  return notches;
}

bool has_notch(const Brep& boundary, const Context& context) {
  bool is_found = false;
  for_each_notch(boundary, context, [&](std::span<const FaceSide>) {
    is_found = true;
    return false;
  });
  return is_found;
}

}  // namespace quoin
