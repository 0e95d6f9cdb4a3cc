// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "quoin/kernel/point.h"

/// Formulas about spheres through vertices of Delone faces, in any numbers: doubles, intervals, rationals.
namespace quoin::flow {

template <class N>
struct Vector {
  N x{};
  N y{};
  N z{};
};

template <class N>
Vector<N> operator+(const Vector<N>& a, const Vector<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
Vector<N> operator*(const Vector<N>& a, const N& factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// b - a.
template <class N>
Vector<N> between(const Point3& a, const Point3& b) {
  return {N(b.x) - N(a.x), N(b.y) - N(a.y), N(b.z) - N(a.z)};
}

/// (q - p0) . (q - p1): the power of q to the sphere that has p0 p1 as a diameter.
template <class N>
N power_to_edge(const Point3& p0, const Point3& p1, const Point3& q) {
  return dot(between<N>(p0, q), between<N>(p1, q));
}

/// 2 q - p0 - p1: twice the vector from the midpoint.
template <class N>
Vector<N> from_midpoint(const Point3& p0, const Point3& p1, const Point3& q) {
  return between<N>(p0, q) + between<N>(p1, q);
}

/// The circle through three points that are not collinear: the plane's normal, and from the first point the vector to
/// the centre, as centre / (2 square_normal).
template <class N>
struct Circle {
  Vector<N> normal;
  N square_normal;
  Vector<N> centre;

  explicit Circle(const std::array<Point3, 3>& p) {
    const Vector<N> a = between<N>(p[0], p[1]);
    const Vector<N> b = between<N>(p[0], p[2]);
    normal = cross(a, b);
    square_normal = dot(normal, normal);
    centre = cross(b * dot(a, a) - a * dot(b, b), normal);
  }
  /// The power of a point to the sphere that has the circle as a great circle, times square_normal; the point is given
  /// by its vector from the first one.
  N power(const Vector<N>& q) const { return dot(q, q) * square_normal - dot(q, centre); }
};

}  // namespace quoin::flow
