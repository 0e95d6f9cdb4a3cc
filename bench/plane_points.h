// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "random.h"

/// Points of the plane that delaunay2_bench and its peer triangulate: uniform in the square [-1, 1]^2, the same rounded
/// to a grid of twice as many cells a side as points would need (many coincide, many are cocircular), a square lattice,
/// the lattice moved by a thousandth of its spacing, near a circle. The same on every platform.
namespace plane_points {

template <class Point>
std::vector<Point> make(const std::string& kind, std::size_t count) {
  Random random(7);
  std::vector<Point> points;
  points.reserve(count);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)) + 0.5);
  if (kind == "lattice" || kind == "jittered") {
    const double move = kind == "lattice" ? 0 : 1e-3;
    for (std::size_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side) + move * random.signed_unit();
      points.push_back(Point{x, static_cast<double>(i / side) + move * random.signed_unit()});
    }
    // In no order, as the others.
    for (std::size_t i = points.size(); i > 1; --i) {
      std::swap(points[i - 1], points[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1))]);
    }
    return points;
  }
  if (kind != "uniform" && kind != "grid" && kind != "circle") throw std::invalid_argument("no such points: " + kind);
  while (points.size() < count) {
    double x = random.signed_unit();
    double y = random.signed_unit();
    if (kind == "grid") {
      x = std::floor(x * static_cast<double>(side));
      y = std::floor(y * static_cast<double>(side));
    } else if (kind == "circle") {
      const double size = std::sqrt(x * x + y * y);
      if (size > 1 || size < 1e-3) continue;
      x /= size;
      y /= size;
    }
    points.push_back(Point{x, y});
  }
  return points;
}

}  // namespace plane_points
