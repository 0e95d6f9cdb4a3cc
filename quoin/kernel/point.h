// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstddef>

namespace quoin {

/// A point of the plane; its coordinates are finite doubles and mean exactly what they say.
struct Point2 {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point2&, const Point2&) = default;
};

/// A vector of the plane, in the unit of the points.
struct Vector2 {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
};

/// A vector of space, in the unit of the points.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

/// A point of space; its coordinates are finite doubles and mean exactly what they say.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
};

/// Order of points by x, then y.
constexpr bool lexicographically_less(const Point2& a, const Point2& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/// Order of points by x, then y, then z.
constexpr bool lexicographically_less(const Point3& a, const Point3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

}  // namespace quoin
