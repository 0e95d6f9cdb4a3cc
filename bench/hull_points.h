// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"

/// Points that hull_bench and its peer take the hull of: uniform in the cube [-1, 1]^3, in the unit ball, on the unit
/// sphere up to rounding, or of a lattice of the same number. The same on every platform.
namespace hull_points {

/// As a type that takes three coordinates in braces.
template <class Point = std::array<double, 3>>
std::vector<Point> make(const std::string& kind, std::size_t count) {
  std::vector<Point> points;
  points.reserve(count);
  if (kind == "lattice") {
    const auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(count)) + 0.5);
    for (std::size_t i = 0; i < side * side * side; ++i) {
      points.push_back(
          {static_cast<double>(i % side), static_cast<double>(i / side % side), static_cast<double>(i / side / side)});
    }
    return points;
  }
  if (kind != "cube" && kind != "ball" && kind != "sphere") throw std::invalid_argument("no such points: " + kind);
  Random random(7);
  while (points.size() < count) {
    Point p{random.signed_unit(), random.signed_unit(), random.signed_unit()};
    const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    if (kind != "cube" && (square > 1 || square < 1e-6)) continue;
    if (kind == "sphere") {
      const double length = std::sqrt(square);
      p = {p[0] / length, p[1] / length, p[2] / length};
    }
    points.push_back(p);
  }
  return points;
}

}  // namespace hull_points
