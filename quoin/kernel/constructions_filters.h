// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "quoin/kernel/point.h"

/// Floating-point filters of Constructions. Each returns the certain sign, +1 or -1, or 0 for "not decided".
///
/// Throughout u = 2^-53: an operation on doubles is off by a factor within 1 +- u unless it overflows, and by 2^-1075
/// more where it underflows. "Rounded" values are the doubles nearest to exact ones, off in the same way. Overflow
/// gives infinities or NaN, which no comparison with the then infinite bound decides.
namespace quoin::filter {

/// A plane n . x = e, scaled by a power of two so that the largest |n_i| lies in [1/2, 1], each number rounded.
struct Plane {
  double nx = 0;
  double ny = 0;
  double nz = 0;
  double e = 0;

  double normal(unsigned axis) const { return axis == 0 ? nx : axis == 1 ? ny : nz; }
};

/// A direction scaled by a power of two so that the largest component lies in [1/2, 1], each component rounded.
struct Line {
  double x = 0;
  double y = 0;
  double z = 0;

  double operator[](unsigned axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// Far more than all underflows of one filter, far less than anything that matters.
constexpr double underflow_slack = 0x1p-1000;

inline int certain_sign(double value, double bound) {
  return static_cast<int>(value > bound) - static_cast<int>(value < -bound);
}

inline double max_abs(double a, double b, double c) {
  return std::max(std::max(std::fabs(a), std::fabs(b)), std::fabs(c));
}

inline double max_abs(const Point3& p) {
  return max_abs(p.x, p.y, p.z);
}

/// Determinant of the rows and a bound of its error if each entry has met one rounding.
///
/// Let X, Y, Z be the largest magnitudes in the columns. The determinant is a sum of six terms, each a product of
/// three entries. A term meets these roundings: 3 entries, a product, the inner difference, a product, and 2 outer
/// sums (first two cofactors, 4 terms: 8 roundings) or 1 (third cofactor, 2 terms: 7). Hence
///   |error| <= (4 * 8 + 2 * 7) u XYZ (1 + 20 u) = 46 u XYZ (1 + 20 u) <= 5.1071e-15 XYZ;
/// the rest of the constant pays for the roundings of the bound and for X, Y, Z being computed.
struct Determinant {
  double value;
  double x;
  double y;
  double z;

  Determinant(const Point3& a, const Point3& b, const Point3& c)
      : value(c.x * (a.y * b.z - a.z * b.y) + c.y * (a.z * b.x - a.x * b.z) + c.z * (a.x * b.y - a.y * b.x)),
        x(max_abs(a.x, b.x, c.x)),
        y(max_abs(a.y, b.y, c.y)),
        z(max_abs(a.z, b.z, c.z)) {}
  int sign() const { return certain_sign(value, 5.2e-15 * x * y * z); }
};

inline Point3 difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Sign of det(b - a, c - a, d - a) of doubles that mean what they say, nonzero differences within [2^-330, 2^331]:
/// then no product of three underflows or overflows.
inline int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return Determinant(difference(b, a), difference(c, a), difference(d, a)).sign();
}

/// The same for any doubles; decides only where X, Y and Z lie in [2^-330, 2^340]. Then 6 XYZ is finite. A product of
/// two differences that underflows loses 2^-1075, times the third at most Z: the slack of the bound, above 2^-54 XYZ,
/// exceeds 2^-714 Z; the underflow of a whole term, 2^-1075, is below 2^-54 2^-990.
inline int orientation_any_range(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Determinant det(difference(b, a), difference(c, a), difference(d, a));
  const double least = std::min(std::min(det.x, det.y), det.z);
  const double most = std::max(std::max(det.x, det.y), det.z);
  return least >= 0x1p-330 && most <= 0x1p340 ? det.sign() : 0;
}

/// Sign of a d - b c, each factor of which has met one rounding: the terms are off by 3 u of themselves, the difference
/// by u more, so |error| <= 4 u (|ad| + |bc|) (1 + 5 u), and 4 u = 4.4409e-16.
inline int cross(double a, double b, double c, double d) {
  const double left = a * d;
  const double right = b * c;
  return certain_sign(left - right, 4.45e-16 * (std::fabs(left) + std::fabs(right)) + underflow_slack);
}

/// Turn a, b, c in the plane of coordinates (i, j), for doubles that mean what they say.
inline int turn(const Point3& a, const Point3& b, const Point3& c, unsigned i, unsigned j) {
  return cross(b[i] - a[i], b[j] - a[j], c[i] - a[i], c[j] - a[j]);
}

/// The same with c rounded, off by u |c_i| or 2^-1075 where that is more, so by less than u (|c_i| + 2^-1000).
inline int turn_rounded_last(const Point3& a, const Point3& b, const Point3& c, unsigned i, unsigned j) {
  const double bi = b[i] - a[i];
  const double bj = b[j] - a[j];
  const double left = bi * (c[j] - a[j]);
  const double right = bj * (c[i] - a[i]);
  const double from_c = std::fabs(bi) * (std::fabs(c[j]) + 0x1p-1000) + std::fabs(bj) * (std::fabs(c[i]) + 0x1p-1000);
  const double sizes = std::fabs(left) + std::fabs(right) + from_c;
  return certain_sign(left - right, 4.45e-16 * sizes + underflow_slack);
}

/// Side of a rounded point on a rounded plane. `extent` is a power of two that no explicit coordinate exceeds in
/// magnitude, or infinity where the filter must not decide; `Constructions` grants extent >= 2^-1000.
///
/// With P = max(extent, |p_i|), in units of 2^-54 P: each p_i is off by 2, each n_i by 1, e (below 3 P) by 4: data 6 +
/// 3 + 4. Roundings: products, below 1, 2 each; sums, below 2, 3 and 6, 4 + 6 + 12. In all 41 < 64, that is 2^-48 P.
/// Underflows are below 2^-1072 <= 2^-1000 2^-72. The factor 2^22 makes the bound infinite for P > 2^1001, where sums
/// might overflow.
inline int side(const Point3& p, const Plane& plane, double extent) {
  const double bound = std::max(max_abs(p), extent) * 0x1p22 * 0x1p-70;
  return certain_sign(plane.nx * p.x + plane.ny * p.y + plane.nz * p.z - plane.e, bound);
}

/// Sign of n . m. Each product of numbers up to 1 is off by 3 u, the sums, below 2 and 3 (rounding errors u and 2 u):
/// 12 u.
inline int dot(const Plane& p, const Plane& q) {
  return certain_sign(p.nx * q.nx + p.ny * q.ny + p.nz * q.nz, 0x1p-49);
}

/// Sign of d . (n x m): the determinant of rows whose entries have met one rounding and are at most 1 (see
/// Determinant).
inline int triple(const Line& d, const Plane& p, const Plane& q) {
  const double value =
      d.x * (p.ny * q.nz - p.nz * q.ny) + d.y * (p.nz * q.nx - p.nx * q.nz) + d.z * (p.nx * q.ny - p.ny * q.nx);
  return certain_sign(value, 5.2e-15);
}

}  // namespace quoin::filter
