// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "hull_points.h"

/// Points that delaunay_bench and its peer triangulate, the same on every platform: those of hull_points; `scan`, a
/// torus with noise, unevenly dense; `torus`; any of them `-grid`, rounded to integers within 1000; `jittered`, a
/// lattice moved by a thousandth.
namespace delaunay_points {

using Point = std::array<double, 3>;

/// A torus without functions that round differently elsewhere: by rational circles, on which density is uneven.
inline std::vector<Point> scan(std::size_t count) {
  Random random(11);
  std::vector<Point> points;
  points.reserve(count);
  const auto circle = [](double t) {  // t in [-1, 1]: half a turn; the other half by its sign
    const double s = 1 + t * t;
    return std::array<double, 2>{(1 - t * t) / s, 2 * t / s};
  };
  while (points.size() < count) {
    auto [c, s] = circle(random.signed_unit());
    auto [d, e] = circle(random.signed_unit());
    if ((random.bits() & 1) != 0) c = -c;
    if ((random.bits() & 1) != 0) d = -d;
    const double radius = 0.7 + 0.3 * d + 0.0005 * random.signed_unit();
    points.push_back({radius * c, radius * s, 0.3 * e + 0.0005 * random.signed_unit()});
  }
  return points;
}

/// On a torus of radii 3 and 1 up to rounding, uniform by both angles.
inline std::vector<Point> torus(std::size_t count) {
  Random random(3);
  const auto direction = [&] {
    for (;;) {
      const double x = static_cast<double>(random.between(-(1 << 30), 1 << 30)) / (1 << 30);
      const double y = static_cast<double>(random.between(-(1 << 30), 1 << 30)) / (1 << 30);
      const double square = x * x + y * y;
      if (square < 1 && square > 0.01) return std::array<double, 2>{x / std::sqrt(square), y / std::sqrt(square)};
    }
  };
  std::vector<Point> points;
  points.reserve(count);
  while (points.size() < count) {
    const auto around = direction();
    const auto tube = direction();
    const double r = 3 + tube[0];
    points.push_back({r * around[0], r * around[1], tube[1]});
  }
  return points;
}

inline std::vector<Point> make(std::string kind, std::size_t count) {
  const std::string suffix = "-grid";
  const bool is_grid = kind.size() > suffix.size() && kind.ends_with(suffix);
  if (is_grid) kind.resize(kind.size() - suffix.size());
  std::vector<Point> points = kind == "scan"    ? scan(count)
                              : kind == "torus" ? torus(count)
                                                : hull_points::make(kind == "jittered" ? "lattice" : kind, count);
  Random random(13);
  for (Point& p : points) {
    for (double& x : p) {
      if (is_grid) x = std::nearbyint(x * 1000);
      if (kind == "jittered") x += 0.001 * random.signed_unit();
    }
  }
  return points;
}

}  // namespace delaunay_points
