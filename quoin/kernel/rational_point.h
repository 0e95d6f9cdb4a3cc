// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/point.h"
#include "quoin/number/rational.h"

namespace quoin {

/// A point or vector of the plane with exact rational coordinates.
struct RationalPoint2 {
  Rational x;
  Rational y;
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
};

/// A point or vector of space with exact rational coordinates.
struct RationalPoint3 {
  Rational x;
  Rational y;
  Rational z;
  const Rational& operator[](unsigned axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
};

inline RationalPoint3 exact_point(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

inline RationalPoint3 operator+(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline RationalPoint3 operator-(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline RationalPoint3 operator*(const RationalPoint3& a, const Rational& factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}

inline Rational dot(const RationalPoint3& a, const RationalPoint3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline RationalPoint3 cross(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Twice the signed area of the triangle a, b, c projected along the axis.
inline Rational projected_area(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                               unsigned axis) {
  const unsigned u = (axis + 1) % 3;
  const unsigned v = (axis + 2) % 3;
  return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

}  // namespace quoin
