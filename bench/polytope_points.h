// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "point_file.h"
#include "quoin/solid/shapes.h"

/// Vertices of the polytopes whose sums are measured in the table of Fogel's thesis; coordinates are rounded.
namespace polytope_points {

using Points = std::vector<point_file::Point>;
using Matrix = std::array<std::array<double, 3>, 3>;

inline point_file::Point product(const Matrix& m, const point_file::Point& p) {
  point_file::Point result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2];
  return result;
}

/// By `degrees` about the x axis, then about the z axis.
inline Points turned(const Points& points, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  const Matrix about_x{{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  const Matrix about_z{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  Points result;
  for (const auto& p : points) result.push_back(product(about_z, product(about_x, p)));
  return result;
}

inline Points vertices_of(const quoin::Mesh& mesh) {
  Points points;
  for (const quoin::Point3& p : mesh.vertices) points.push_back({p.x, p.y, p.z});
  return points;
}

/// Sixteen corners about an apex.
inline Points dioctagonal_pyramid() {
  Points points{{0, -1, 0}};
  for (int i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi / 8 * i;
    points.push_back({std::cos(angle), 0, std::sin(angle)});
  }
  return points;
}

/// Sixteen latitudes, thirty-two longitudes, twice as high as wide.
inline Points ellipsoid() {
  Points points{{0, 0, 2}, {0, 0, -2}};
  for (int i = 1; i < 16; ++i) {
    const double latitude = std::numbers::pi / 16 * i;
    for (int j = 0; j < 32; ++j) {
      const double longitude = std::numbers::pi / 16 * j;
      points.push_back(
          {std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), 2 * std::cos(latitude)});
    }
  }
  return points;
}

/// All signs and even permutations of five triples: 120 vertices.
inline Points truncated_icosidodecahedron() {
  const double f = std::numbers::phi;
  const std::array<std::array<double, 3>, 5> triples{
      {{1 / f, 1 / f, 3 + f}, {2 / f, f, 1 + 2 * f}, {1 / f, f * f, 3 * f - 1}, {2 * f - 1, 2, 2 + f}, {f, 3, 2 * f}}};
  Points points;
  for (const auto& t : triples) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      const auto signed_at = [&](std::size_t i) { return (signs >> i & 1U) != 0 ? -t[i] : t[i]; };
      for (std::size_t turn = 0; turn < 3; ++turn) {
        points.push_back({signed_at(turn), signed_at((turn + 1) % 3), signed_at((turn + 2) % 3)});
      }
    }
  }
  return points;
}

/// Where the sixty rotations of an icosahedron take a point.
inline Points snub_dodecahedron() {
  const double f = std::numbers::phi;
  // Two fifths about (0, 1, phi) and a half about z: they generate the group.
  const Matrix fifth{{{(f - 1) / 2, -f / 2, 0.5}, {f / 2, 0.5, (f - 1) / 2}, {-0.5, (f - 1) / 2, f / 2}}};
  const Matrix half{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  Points points{{0.374821658114562, 0.330921024729844, 2.097053835252088}};
  for (std::size_t i = 0; i < points.size() && points.size() <= 60; ++i) {
    for (const Matrix& m : {fifth, half}) {
      const auto q = product(m, points[i]);
      bool is_new = true;
      for (const auto& p : points) {
        is_new = is_new && std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 1e-6;
      }
      if (is_new) points.push_back(q);
    }
  }
  if (points.size() != 60) throw std::logic_error("the rotations of the icosahedron are not sixty");
  return points;
}

/// A geodesic sphere of this frequency for a name that is a number.
inline Points named(const std::string& name) {
  static const std::map<std::string, std::function<Points()>> shapes{
      {"icosahedron", [] { return vertices_of(quoin::shapes::icosahedron()); }},
      {"pyramid", dioctagonal_pyramid},
      {"ellipsoid", ellipsoid},
      {"truncated", truncated_icosidodecahedron},
      {"snub", snub_dodecahedron}};
  const auto known = shapes.find(name);
  return known != shapes.end() ? known->second() : vertices_of(quoin::shapes::geodesic_sphere(std::stoul(name)));
}

}  // namespace polytope_points
