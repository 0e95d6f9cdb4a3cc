// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "quoin/triangulation/test_clouds.h"

/// Families of points for tests of the flow.
namespace quoin::testing {

/// A point of a surface about the origin, of size about 1, by two numbers between -1 and 1.
using ScannedSurface = Point3 (*)(double, double);

inline Point3 scanned_sphere(double u, double v) {
  const double r = std::sqrt(1 - v * v);
  const double a = std::acos(-1.0) * u;
  return {r * std::cos(a), r * std::sin(a), v};
}
inline Point3 scanned_torus(double u, double v) {
  const double a = std::acos(-1.0) * u;
  const double b = std::acos(-1.0) * v;
  const double r = 0.8 + 0.4 * std::cos(b);
  return {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)};
}
inline Point3 scanned_bumps(double u, double v) {
  const Point3 p = scanned_sphere(u, v);
  const double r = 1 + 0.25 * std::sin(5 * p.x) * std::cos(4 * p.y) * std::sin(3 * p.z + 1);
  return {r * p.x, r * p.y, r * p.z};
}

/// Points near a surface, with noise of half a step, rounded to a grid: as files of scans hold them. The surface has a
/// dozen or more places of the grid for each point, whatever their number: there are many cospherical points and right
/// angles, and more manifolds that have none. No point is there twice.
inline std::vector<Point3> rounded_scan(Random& random, std::size_t count, ScannedSurface surface) {
  const double size = std::sqrt(static_cast<double>(count)) + 3;
  std::vector<Point3> points;
  while (points.size() < count) {
    const double u = unit(random);
    const Point3 p = surface(u, unit(random));
    Point3 rounded;
    for (std::size_t axis = 0; axis < 3; ++axis) rounded[axis] = std::round(size * p[axis] + 0.5 * unit(random));
    if (std::find(points.begin(), points.end(), rounded) == points.end()) points.push_back(rounded);
  }
  return points;
}

inline std::vector<Cloud> rounded_scans(Random& random, std::size_t count) {
  return {{"a rounded sphere", rounded_scan(random, count, scanned_sphere)},
          {"a rounded torus", rounded_scan(random, count, scanned_torus)},
          {"a rounded sphere with bumps", rounded_scan(random, count, scanned_bumps)}};
}

/// Those of triangulations, and rounded scans.
inline std::vector<Cloud> flow_clouds(Random& random, std::size_t count) {
  std::vector<Cloud> all = clouds(random, count);
  for (Cloud& scan : rounded_scans(random, count)) all.push_back(std::move(scan));
  return all;
}

}  // namespace quoin::testing
