// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/convex_boundary.h"

#include <algorithm>
#include <utility>

#include "quoin/polytope/as_doubles.h"

namespace quoin {

namespace {

void add_facets(Brep& boundary, std::span<const std::uint32_t> corners, std::span<const std::size_t> facet_begin,
                const std::string& name) {
  const auto point = [](std::uint32_t v) { return PointId(std::size_t{v}); };
  for (std::size_t f = 0; f + 1 < facet_begin.size(); ++f) {
    const auto facet = corners.subspan(facet_begin[f], facet_begin[f + 1] - facet_begin[f]);
    boundary.face_planes.push_back({point(facet[0]), point(facet[1]), point(facet[2])});
    for (const std::uint32_t v : facet) boundary.loop_vertices.push_back(point(v));
    boundary.loop_begin.push_back(static_cast<std::uint32_t>(boundary.loop_vertices.size()));
    boundary.face_first_loop.push_back(static_cast<std::uint32_t>(f + 1));
    boundary.origins.push_back({0, static_cast<std::uint32_t>(f)});
    boundary.face_first_origin.push_back(static_cast<std::uint32_t>(f + 1));
    boundary.face_shells.push_back(0);
  }
  boundary.shells.push_back({false});
  boundary.component_count = 1;
  boundary.leaf_names.push_back(name);
}

/// The vertices of a hull without the other points.
template <class Point>
struct VertexList {
  VertexList(const ConvexHull& hull, std::span<const Point> points) {
    std::vector<std::uint32_t> place(points.size(), 0);
    vertices.reserve(hull.vertices.size());
    for (const std::uint32_t v : hull.vertices) {
      place[v] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(points[v]);
    }
    corners.reserve(hull.corners.size());
    for (const std::uint32_t v : hull.corners) corners.push_back(place[v]);
  }
  std::vector<Point> vertices;
  std::vector<std::uint32_t> corners;
};

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

}  // namespace

Brep convex_boundary(const std::vector<RationalPoint3>& vertices, std::span<const std::uint32_t> corners,
                     std::span<const std::size_t> facet_begin, const std::string& name) {
  Brep boundary;
  std::optional<std::vector<Point3>> doubles = as_doubles(vertices);
  boundary.points = doubles ? Constructions(std::move(*doubles)) : Constructions(vertices);
  add_facets(boundary, corners, facet_begin, name);
  return boundary;
}

Brep convex_boundary(const ConvexHull& hull, std::span<const Point3> points, const std::string& name) {
  const VertexList<Point3> list(hull, points);
  Brep boundary;
  boundary.points = Constructions(list.vertices);
  add_facets(boundary, list.corners, hull.facet_begin, name);
  return boundary;
}

Brep convex_boundary(const ConvexHull& hull, std::span<const RationalPoint3> points, const std::string& name) {
  const VertexList<RationalPoint3> list(hull, points);
  return convex_boundary(list.vertices, list.corners, hull.facet_begin, name);
}

std::optional<std::array<PointId, 2>> find_reflex_edge(const Brep& boundary) {
  std::vector<FaceSide> sides;
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    for (std::uint32_t l = boundary.face_first_loop[f]; l < boundary.face_first_loop[f + 1]; ++l) {
      const auto loop = boundary.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        sides.push_back({static_cast<std::uint32_t>(loop[i].index()),
                         static_cast<std::uint32_t>(loop[(i + 1) % loop.size()].index()), f});
      }
    }
  }
  const auto ends = [](const FaceSide& s) { return std::minmax(s.tail, s.head); };
  std::ranges::sort(sides, [&](const FaceSide& a, const FaceSide& b) {
    return std::pair(ends(a), a.face) < std::pair(ends(b), b.face);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (ends(sides[i]) != ends(sides[i + 1])) continue;
    // Where several faces meet, the solid is reflex between some of them.
    const bool are_more = i + 2 < sides.size() && ends(sides[i + 2]) == ends(sides[i]);
    if (are_more || rises_above(boundary, sides[i], sides[i + 1].face)) {
      return std::array{PointId(std::size_t{sides[i].tail}), PointId(std::size_t{sides[i].head})};
    }
  }
  return std::nullopt;
}

}  // namespace quoin
