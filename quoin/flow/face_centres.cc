// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/flow/face_formulas.h"
#include "quoin/flow/flow_complex.h"
#include "quoin/triangulation/voronoi.h"

namespace quoin {

std::array<Point3, 3> FlowComplex::circle(std::uint32_t polygon) const {
  const std::span<const std::uint32_t> corners = faces_.polygon(polygon);
  return {points_[corners[0]], points_[corners[1]], points_[corners[2]]};
}

RationalPoint3 FlowComplex::centre(DeloneFace face) const {
  const std::span<const std::uint32_t> vertices = faces_.vertices(face);
  RationalPoint3 first = exact_point(points_[vertices[0]]);
  if (face.dimension == 0) return first;
  if (face.dimension == 1) return (first + exact_point(points_[vertices[1]])) * (Rational(1) / Rational(2));
  if (face.dimension == 2) {
    const flow::Circle<Rational> c(circle(face.index));
    const RationalPoint3 doubled{c.centre.x, c.centre.y, c.centre.z};
    return first + doubled * (Rational(1) / (c.square_normal * Rational(2)));
  }
  const std::uint32_t f = faces_.polygons_of_cell(face.index)[0];
  const std::span<const std::uint32_t> polygon = faces_.polygon(f);
  const std::uint32_t apex = *std::find_if(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
    return std::find(polygon.begin(), polygon.end(), v) == polygon.end();
  });
  const std::array<Point3, 3> base = circle(f);
  return circumcentre(base[0], base[1], base[2], points_[apex]);
}

Rational FlowComplex::square_radius(DeloneFace face) const {
  const RationalPoint3 radius = centre(face) - exact_point(points_[faces_.vertices(face)[0]]);
  return dot(radius, radius);
}

}  // namespace quoin
