// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "quoin/kernel/constructions_filters.h"
#include "quoin/kernel/point.h"

/// Floating-point filters of the predicates on explicit points. Each returns the certain sign, +1 or -1, or 0 for "not
/// decided".
///
/// As in constructions_filters.h, u = 2^-53; X, Y, Z are the largest magnitudes of the computed differences in each
/// coordinate and M the largest of these. Errors are counted in units of u times the sizes of the factors, with
/// (1 + u)^k - 1 <= k u (1 + k u); constants leave room for the second-order terms and for the roundings of the bound
/// itself. The absolute `slack` pays for underflow: it exceeds 2^-1074 times everything that later multiplies a product
/// that underflowed, because M is at most `largest`; by that, too, nothing overflows. Source of the method: Shewchuk
/// 1997, section 4; of the maxima form: Melquiond and Pion 2007.
namespace quoin::filter {

/// Sign of det(b - a, c - a): one product, two differences and a sum on each term's way; see `cross`, whose bound
/// covers every range.
inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  return cross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

/// Sign of det(b - a, c - a, d - a) for points of any magnitude; decides only where M <= 2^340.
///
/// |error| <= 46 u XYZ (1 + 20 u) (see Determinant) <= 5.11e-15 XYZ. Six products of two underflow by at most 2^-1075
/// each and are multiplied by at most 2^340; three products of three and the products of the bound likewise: in all
/// below 2^-1071 (2^340 + 1) < 2^-730. Products stay below 2^1020, sums below 6 times that.
inline int orientation_by_maxima(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double largest = 0x1p340;
  constexpr double slack = 0x1p-730;
  const Determinant det(difference(b, a), difference(c, a), difference(d, a));
  if (!(max_abs(det.x, det.y, det.z) <= largest)) return 0;
  return certain_sign(det.value, 5.2e-15 * det.x * det.y * det.z + slack);
}

/// Sign of the determinant of the rows (x, y, x^2 + y^2) of a - d, b - d, c - d; decides only where M <= 2^200.
///
/// Minors of two rows: products 3 each, their difference 2: 8 u XY. Lifts: squares 3 each, sum 2: 8 u M^2, size 2 M^2.
/// Terms: 2 * 8 + 2 * 8 + their product 4 = 36, three of them 108; sums of size 8 and 12: 128 u XY M^2 (1 + 20 u) =
/// 1.4211e-14 XY M^2. Underflow: products of two lose 2^-1075 and are multiplied by lifts or minors below 2^402, at
/// most 12 of them; below 2^-660.
inline int in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  constexpr double largest = 0x1p200;
  constexpr double slack = 0x1p-660;
  const double ax = a.x - d.x;
  const double ay = a.y - d.y;
  const double bx = b.x - d.x;
  const double by = b.y - d.y;
  const double cx = c.x - d.x;
  const double cy = c.y - d.y;
  const double x = max_abs(ax, bx, cx);
  const double y = max_abs(ay, by, cy);
  const double m = std::max(x, y);
  const double value = (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
                       (cx * cx + cy * cy) * (ax * by - ay * bx);
  if (!(m <= largest)) return 0;
  return certain_sign(value, 1.5e-14 * x * y * (m * m) + slack);
}

/// Rows p - q, for in_sphere.
struct LiftedRow {
  double x;
  double y;
  double z;
  double lift;

  LiftedRow(const Point3& p, const Point3& q) : x(p.x - q.x), y(p.y - q.y), z(p.z - q.z), lift(x * x + y * y + z * z) {}
};

/// Minus the determinant of the rows (x, y, z, x^2 + y^2 + z^2) of a - e, b - e, c - e, d - e.
inline double in_sphere_value(const LiftedRow& a, const LiftedRow& b, const LiftedRow& c, const LiftedRow& d) {
  const double ab = a.x * b.y - b.x * a.y;
  const double bc = b.x * c.y - c.x * b.y;
  const double cd = c.x * d.y - d.x * c.y;
  const double da = d.x * a.y - a.x * d.y;
  const double ac = a.x * c.y - c.x * a.y;
  const double bd = b.x * d.y - d.x * b.y;
  const double abc = a.z * bc - b.z * ac + c.z * ab;
  const double bcd = b.z * cd - c.z * bd + d.z * bc;
  const double cda = c.z * da + d.z * ac + a.z * cd;
  const double dab = d.z * ab + a.z * bd + b.z * da;
  return (a.lift * bcd - b.lift * cda) + (c.lift * dab - d.lift * abc);
}

/// Sign of in_sphere_value; decides only where M <= 2^140.
///
/// Minors of three rows: 46 u XYZ, size 6 (three terms z minor, 8 + 2 + 2 each, sums of size 4 and 6). Lifts: squares 3
/// each, sums 2 and 3: 14 u M^2, size 3. Terms: 3 * 46 + 6 * 14 + their product 18 = 240, four of them 960; sums of
/// size 36, 36 and 72: 1104 u XYZ M^2 (1 + 30 u) = 1.2257e-13 XYZ M^2. Underflow: 2^-1075 in each of 12 products of two
/// in minors, times z lift below 2^422, and less elsewhere; below 2^-640. Products stay below 2^720.
inline int in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  constexpr double largest = 0x1p140;
  constexpr double slack = 0x1p-640;
  const LiftedRow ra(a, e);
  const LiftedRow rb(b, e);
  const LiftedRow rc(c, e);
  const LiftedRow rd(d, e);
  const double x = std::max(max_abs(ra.x, rb.x, rc.x), std::fabs(rd.x));
  const double y = std::max(max_abs(ra.y, rb.y, rc.y), std::fabs(rd.y));
  const double z = std::max(max_abs(ra.z, rb.z, rc.z), std::fabs(rd.z));
  const double m = max_abs(x, y, z);
  const double value = in_sphere_value(ra, rb, rc, rd);
  if (!(m <= largest)) return 0;
  return certain_sign(value, 1.3e-13 * x * y * z * (m * m) + slack);
}

/// Sign of a sum of terms, each of which has met at most two roundings, given with the sum of their magnitudes (three
/// or four terms, summed from left to right).
///
/// With at most 3 sums: products of inexact differences meet 3 and 2, of doubles 1 and 3: at most 5 u (1 + 8 u) of the
/// magnitudes, 5.5512e-16, and the magnitudes are off by 3 u themselves. Underflow: 2^-1075 each, multiplied by nothing
/// later. Where anything overflows, the magnitudes are infinite or no number, and nothing is decided.
inline int sum_of_products(double value, double magnitudes) {
  return certain_sign(value, 5.6e-16 * magnitudes + underflow_slack);
}

}  // namespace quoin::filter
