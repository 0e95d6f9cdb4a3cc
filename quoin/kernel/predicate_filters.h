// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "quoin/kernel/constructions_filters.h"
#include "quoin/kernel/pair.h"
#include "quoin/kernel/point.h"

/// Floating-point filters of the predicates on explicit points. Each returns the certain sign, +1 or -1, or 0 for "not
/// decided".
///
/// As in constructions_filters.h, u = 2^-53; X, Y, Z are the largest magnitudes of the computed differences in each
/// coordinate and M the largest of these. Errors are counted in units of u times the sizes of the factors, with
/// (1 + u)^k - 1 <= k u (1 + k u); constants leave room for the second-order terms and for the roundings of the bound
/// itself. The absolute `slack` pays for underflow: it exceeds 2^-1074 times everything that later multiplies a product
/// that underflowed, because M is at most `largest`; by that, too, nothing overflows
/// (orientation_of_size does without). Source of the method: Shewchuk
/// 1997, section 4; of the maxima form: Melquiond and Pion 2007.
namespace quoin::filter {

/// As certain_sign, for callers that go on elsewhere if nothing is decided: one comparison, and the sign by its bit.
inline int likely_sign(double value, double bound) {
  if (std::fabs(value) > bound) [[likely]]
    return static_cast<int>(std::bit_cast<std::int64_t>(value) >> 63) | 1;
  return 0;
}

/// Sign of det(b - a, c - a): one product, two differences and a sum on each term's way; see `cross`, whose bound
/// covers every range.
inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  return cross(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
}

/// det(b - a, c - a, d - a) and the maxima.
///
/// Minors of the columns x, y: products 3 each, their difference 2: 8 u XY. Terms: 8 + 2 + 2 = 12 each, sums of size 4
/// and 6: 46 u XYZ (1 + 20 u) <= 5.11e-15 XYZ. Six products of two underflow by at most 2^-1075 each and are multiplied
/// by at most Z, three products of three by 2^-1075: in all below 2^-1071 (Z + 1).
struct Orientation {
  double value;
  double x;
  double y;
  double z;

  // The pairs are (x, y) of a row; minors are named by their rows.
  Orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    const Pair from{a.x, a.y};
    const Pair pb = Pair{b.x, b.y} - from;
    const Pair pc = Pair{c.x, c.y} - from;
    const Pair pd = Pair{d.x, d.y} - from;
    const double bz = b.z - a.z;
    const double cz = c.z - a.z;
    const double dz = d.z - a.z;
    const Pair bc = pb * swapped(pc);
    const Pair cd = pc * swapped(pd);
    const Pair db = pd * swapped(pb);
    value = dz * (bc[0] - bc[1]) + bz * (cd[0] - cd[1]) + cz * (db[0] - db[1]);
    const Pair xy = larger(larger(magnitudes(pb), magnitudes(pc)), magnitudes(pd));
    x = xy[0];
    y = xy[1];
    z = max_abs(bz, cz, dz);
  }
};

/// Sign of det(b - a, c - a, d - a); decides only values above 2^-45, but needs no test of the range.
///
/// The slack exceeds the underflow for any Z. Where 8 XYZ, computed in this order, is finite, so are the products of
/// two (at most XY), the minors (2 XY) and the sums (6 XYZ); else the bound is infinite or no number.
inline int orientation_of_size(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Orientation det(a, b, c, d);
  return likely_sign(det.value, 8 * det.x * det.y * det.z * (5.2e-15 / 8) + 0x1p-45);
}

/// The same for smaller values; decides only where M <= 2^340: then the underflow is below 2^-730.
inline int orientation_by_maxima(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double largest = 0x1p340;
  constexpr double slack = 0x1p-730;
  const Orientation det(a, b, c, d);
  if (!(max_abs(det.x, det.y, det.z) <= largest)) return 0;
  return likely_sign(det.value, 5.2e-15 * det.x * det.y * det.z + slack);
}

/// The determinant of the rows (x, y, x^2 + y^2) of a - d, b - d, c - d, and the maxima.
struct InCircle {
  double value;
  double x;
  double y;

  InCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double ax = a.x - d.x;
    const double ay = a.y - d.y;
    const double bx = b.x - d.x;
    const double by = b.y - d.y;
    const double cx = c.x - d.x;
    const double cy = c.y - d.y;
    value = (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
            (cx * cx + cy * cy) * (ax * by - ay * bx);
    x = max_abs(ax, bx, cx);
    y = max_abs(ay, by, cy);
  }
};

/// Sign of InCircle::value; decides only where M <= 2^200.
///
/// Minors of two rows: products 3 each, their difference 2: 8 u XY. Lifts: squares 3 each, sum 2: 8 u M^2, size 2 M^2.
/// Terms: 2 * 8 + 2 * 8 + their product 4 = 36, three of them 108; sums of size 8 and 12: 128 u XY M^2 (1 + 20 u) =
/// 1.4211e-14 XY M^2. Underflow: products of two lose 2^-1075 and are multiplied by lifts or minors below 2^402, at
/// most 12 of them; below 2^-660.
inline int in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  constexpr double largest = 0x1p200;
  constexpr double slack = 0x1p-660;
  const InCircle det(a, b, c, d);
  const double m = std::max(det.x, det.y);
  if (!(m <= largest)) return 0;
  return certain_sign(det.value, 1.5e-14 * det.x * det.y * (m * m) + slack);
}

/// Minus the determinant of the rows (x, y, z, x^2 + y^2 + z^2) of a - e, b - e, c - e, d - e, and the maxima.
struct InSphere {
  double value;
  double x;
  double y;
  double z;

  // Two rows at a time: ac is the pair of values of rows a and c, and so on; minors are named by their rows.
  InSphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    const Pair x_ac = Pair{a.x, c.x} - e.x;
    const Pair y_ac = Pair{a.y, c.y} - e.y;
    const Pair z_ac = Pair{a.z, c.z} - e.z;
    const Pair x_bd = Pair{b.x, d.x} - e.x;
    const Pair y_bd = Pair{b.y, d.y} - e.y;
    const Pair z_bd = Pair{b.z, d.z} - e.z;
    const Pair lift_ac = x_ac * x_ac + y_ac * y_ac + z_ac * z_ac;
    const Pair lift_bd = x_bd * x_bd + y_bd * y_bd + z_bd * z_bd;
    const Pair ab_cd = x_ac * y_bd - x_bd * y_ac;
    const Pair bc_da = x_bd * swapped(y_ac) - swapped(x_ac) * y_bd;
    const double ac = x_ac[0] * y_ac[1] - x_ac[1] * y_ac[0];
    const double bd = x_bd[0] * y_bd[1] - x_bd[1] * y_bd[0];
    const Pair abc_cda = z_ac * bc_da + Pair{-z_bd[0], z_bd[1]} * ac + swapped(z_ac) * ab_cd;
    const Pair bcd_dab = z_bd * swapped(ab_cd) + Pair{-z_ac[1], z_ac[0]} * bd + swapped(z_bd) * bc_da;
    const Pair terms = lift_ac * bcd_dab - lift_bd * swapped(abc_cda);
    value = terms[0] + terms[1];
    x = largest_magnitude(x_ac, x_bd);
    y = largest_magnitude(y_ac, y_bd);
    z = largest_magnitude(z_ac, z_bd);
  }
};

/// Sign of InSphere::value; decides only where M <= 2^140.
///
/// Minors of three rows: 46 u XYZ, size 6 (three terms z minor, 8 + 2 + 2 each, sums of size 4 and 6). Lifts: squares 3
/// each, sums 2 and 3: 14 u M^2, size 3. Terms: 3 * 46 + 6 * 14 + their product 18 = 240, four of them 960; sums of
/// size 36, 36 and 72: 1104 u XYZ M^2 (1 + 30 u) = 1.2257e-13 XYZ M^2. Underflow: 2^-1075 in each of 12 products of two
/// in minors, times z lift below 2^422, and less elsewhere; below 2^-640. Products stay below 2^720.
[[gnu::always_inline]] inline int in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                            const Point3& e) {
  constexpr double largest = 0x1p140;
  constexpr double slack = 0x1p-640;
  const InSphere det(a, b, c, d, e);
  const double m = std::max(std::max(det.x, det.y), det.z);
  if (!(m <= largest)) [[unlikely]]
    return 0;
  return likely_sign(det.value, 1.3e-13 * det.x * det.y * det.z * (m * m) + slack);
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
