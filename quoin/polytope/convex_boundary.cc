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

}  // namespace quoin
