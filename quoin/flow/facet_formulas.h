// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "quoin/flow/face_formulas.h"
#include "quoin/flow/flow_complex.h"

/// Formulas in the plane that bisects an edge, where its Voronoi facet is, in any numbers. Points are vectors y from
/// the edge's midpoint. A Voronoi edge, dual to a polygon, is the line z + t n with z the polygon's circumcentre and n
/// the normal of its first three corners.
namespace quoin::flow {

inline std::array<Point3, 3> circle_points(const FlowComplex& flow, std::uint32_t polygon) {
  const std::span<const std::uint32_t> corners = flow.faces().polygon(polygon);
  return {flow.point(corners[0]), flow.point(corners[1]), flow.point(corners[2])};
}

template <class N>
Vector<N> normal(const FlowComplex& flow, std::uint32_t polygon) {
  const std::array<Point3, 3> p = circle_points(flow, polygon);
  return cross(between<N>(p[0], p[1]), between<N>(p[0], p[2]));
}

/// The line of a polygon around the edge: all y with y . direction = power.
template <class N>
struct FacetLine {
  N power;
  Vector<N> direction;

  FacetLine(const Point3& p0, const Point3& p1, const Point3& apex) {
    const Vector<N> from0 = between<N>(p0, apex);
    const Vector<N> from1 = between<N>(p1, apex);
    power = dot(from0, from1);
    direction = from0 + from1;
  }
  FacetLine(const FlowComplex& flow, std::uint32_t edge, std::uint32_t apex)
      : FacetLine(flow.point(flow.faces().edge(edge)[0]), flow.point(flow.faces().edge(edge)[1]), flow.point(apex)) {}
};

/// The place t on the Voronoi edge of a polygon, as seen from the midpoint of a side of the polygon.
template <class N>
class LineFromMidpoint {
 public:
  LineFromMidpoint(const FlowComplex& flow, std::uint32_t edge, std::uint32_t polygon, std::uint32_t apex)
      : normal_(normal<N>(flow, polygon)) {
    const std::array<std::uint32_t, 2> ends = flow.faces().edge(edge);
    set_centre(flow.point(ends[0]), flow.point(ends[1]), flow.point(apex));
  }
  /// Of the triangle (p0, p1, apex), with its normal.
  LineFromMidpoint(const Point3& p0, const Point3& p1, const Point3& apex)
      : normal_(cross(between<N>(p0, p1), between<N>(p0, apex))) {
    set_centre(p0, p1, apex);
  }
  Vector<N> at(const N& t) const { return centre_ + normal_ * t; }

 private:
  void set_centre(const Point3& p0, const Point3& p1, const Point3& apex) {
    const FacetLine<N> line(p0, p1, apex);
    const Vector<N> across = cross(normal_, between<N>(p0, p1));
    centre_ = across * (line.power / dot(across, line.direction));
  }

  Vector<N> normal_;
  Vector<N> centre_;
};

/// Where the ray from the midpoint through y meets the Voronoi edge of another polygon of the edge. A fraction of
/// linear functions of y, hence of t on another Voronoi edge: monotone where it has no pole.
template <class N>
N landing(const FacetLine<N>& line, const Vector<N>& normal, const Vector<N>& y) {
  return line.power * dot(y, normal) / (dot(y, line.direction) * dot(normal, normal));
}

/// The place of a sphere's centre on the Voronoi edge of a triangle on it; the apex is a point of it off the triangle.
template <class N>
N place_of_cell(const std::array<Point3, 3>& triangle, const Point3& apex) {
  const Circle<N> circle(triangle);
  const Vector<N> to = between<N>(triangle[0], apex);
  return circle.power(to) / (N(2) * circle.square_normal * dot(circle.normal, to));
}
/// The same of a polygon.
template <class N>
N place_of_cell(const FlowComplex& flow, std::uint32_t polygon, std::uint32_t apex) {
  return place_of_cell<N>(circle_points(flow, polygon), flow.point(apex));
}

}  // namespace quoin::flow
