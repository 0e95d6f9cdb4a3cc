// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "quoin/kernel/constructions_filters.h"
#include "quoin/kernel/predicate_filters.h"

/// Floating-point filters of predicates on points of which only the rounded coordinates are known. Each returns the
/// certain sign, +1 or -1, or 0 for "not decided".
///
/// Two errors add up. The *evaluation* error, between the formula of the rounded points and its computed value, is that
/// of the filters on explicit points (predicate_filters.h). The *data* error is the change of the formula when rounded
/// points take the place of exact ones. With u = 2^-53 and C the largest rounded coordinate along an axis, each
/// coordinate is off by at most u C, or 2^-1075 where that is more, and a difference by `change` = 2 u (C + 2^-960).
/// `size` = computed difference + change bounds the differences of the exact points and of the rounded ones.
/// A monomial of differences then changes by at most the product of the sizes minus the product of sizes less changes,
/// hence by less than the sum, over its factors, of the factor's change times the sizes of the others. That counts
/// every order of the changes: nothing is neglected where differences are smaller than the errors of their points.
///
/// Constants are larger than derived by 0.8 % or more, which pays for the roundings of the bounds (below 20 u).
namespace quoin::filter {

/// Differences along one axis.
struct Spread {
  double coordinate;  ///< largest magnitude of a coordinate
  double change;
  double size;

  Spread(double largest_coordinate, double largest_difference)
      : coordinate(largest_coordinate),
        change(0x1p-52 * (largest_coordinate + 0x1p-960)),
        size(largest_difference + change) {}
};

inline double largest_of(std::initializer_list<double> values) {
  double largest = 0;
  for (const double x : values) largest = std::max(largest, std::fabs(x));
  return largest;
}

inline Point3 largest_coordinates(std::initializer_list<Point3> points) {
  Point3 largest{0, 0, 0};
  for (const Point3& p : points) {
    for (unsigned axis = 0; axis < 3; ++axis) largest[axis] = std::max(largest[axis], std::fabs(p[axis]));
  }
  return largest;
}

/// Sum over the axes of a change times the sizes along the others.
inline double changed_area(const Spread& x, const Spread& y) {
  return x.change * y.size + y.change * x.size;
}
inline double changed_volume(const Spread& x, const Spread& y, const Spread& z) {
  return changed_area(x, y) * z.size + x.size * y.size * z.change;
}

/// Turn a, b, c in the plane of coordinates (i, j).
///
/// Evaluation: two terms of 3 roundings, a sum of size 2: 8 u XY = 8.89e-16 XY. Data: two monomials x y: twice the
/// changed area. Underflow: 2^-1075 in each product, of the bound too. Where anything overflows, the bound is infinite
/// or no number.
inline int turn_rounded(const Point3& a, const Point3& b, const Point3& c, unsigned i, unsigned j) {
  const double bi = b[i] - a[i];
  const double bj = b[j] - a[j];
  const double ci = c[i] - a[i];
  const double cj = c[j] - a[j];
  const Spread x(largest_of({a[i], b[i], c[i]}), largest_of({bi, ci}));
  const Spread y(largest_of({a[j], b[j], c[j]}), largest_of({bj, cj}));
  return certain_sign(bi * cj - bj * ci, 9e-16 * x.size * y.size + 2.02 * changed_area(x, y) + underflow_slack);
}

/// Sign of det(b - a, c - a, d - a); decides only where coordinates are at most 2^330.
///
/// Evaluation: 46 u XYZ (see Orientation). Data: six monomials x y z. Underflow: of the value below 2^-1071 (2^331 +
/// 1), of the bound 2^-1075 in each product of two, times 7 * 2^331; in all below 2^-730.
inline int orientation_rounded(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double largest = 0x1p330;
  constexpr double slack = 0x1p-730;
  const Point3 most = largest_coordinates({a, b, c, d});
  if (!(max_abs(most) <= largest)) return 0;
  const Orientation det(a, b, c, d);
  const Spread x(most.x, det.x);
  const Spread y(most.y, det.y);
  const Spread z(most.z, det.z);
  return certain_sign(det.value, 5.2e-15 * x.size * y.size * z.size + 6.05 * changed_volume(x, y, z) + slack);
}

/// Sign of InCircle::value in the plane of coordinates (i, j); decides only where coordinates are at
/// most 2^199.
///
/// Evaluation: 128 u XY M^2 (see in_circle). Data: six monomials x^3 y and six x y^3. With M the larger size, those
/// change by 6 (3 x' M^2 Y + y' M^2 X + x' M^2 Y + 3 y' M^2 X), where x' and y' are the changes: 24 M^2 times the
/// changed area. Underflow: that of `in_circle`, and of the bound below 2^-1075 25 * 2^402; in all below 2^-660.
inline int in_circle_rounded(const Point3& a, const Point3& b, const Point3& c, const Point3& d, unsigned i,
                             unsigned j) {
  constexpr double largest = 0x1p199;
  constexpr double slack = 0x1p-660;
  const double most_i = largest_of({a[i], b[i], c[i], d[i]});
  const double most_j = largest_of({a[j], b[j], c[j], d[j]});
  if (!(std::max(most_i, most_j) <= largest)) return 0;
  const InCircle det({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}, {d[i], d[j]});
  const Spread x(most_i, det.x);
  const Spread y(most_j, det.y);
  const double m = std::max(x.size, y.size);
  const double per_square = 1.5e-14 * x.size * y.size + 24.2 * changed_area(x, y);
  return certain_sign(det.value, per_square * (m * m) + slack);
}

/// Sign of InSphere::value; decides only where coordinates are at most 2^139.
///
/// Evaluation: 1104 u XYZ M^2 (see in_sphere). Data: 24 monomials each of x^2 xyz, y^2 xyz and z^2 xyz. A change x'
/// meets 3 x' M^2 YZ in the first and x' M^2 YZ in the others, so 24 * 5 = 120 M^2 times the changed volume. Underflow:
/// that of `in_sphere`, and of the bound below 2^-1075 122 * 2^422; in all below 2^-640.
inline int in_sphere_rounded(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  constexpr double largest = 0x1p139;
  constexpr double slack = 0x1p-640;
  const Point3 most = largest_coordinates({a, b, c, d, e});
  if (!(max_abs(most) <= largest)) return 0;
  const InSphere det(a, b, c, d, e);
  const Spread x(most.x, det.x);
  const Spread y(most.y, det.y);
  const Spread z(most.z, det.z);
  const double m = std::max(std::max(x.size, y.size), z.size);
  const double per_square = 1.3e-13 * x.size * y.size * z.size + 121 * changed_volume(x, y, z);
  return certain_sign(det.value, per_square * (m * m) + slack);
}

/// Sign of direction . (p - q), the direction rounded too.
///
/// A term d_i (p_i - q_i) meets the roundings of d_i, the difference and the product and those of two sums: 5 u of the
/// terms, 5.552e-16. The coordinates are off by u (|p_i| + |q_i|) |d_i|, 1.1103e-16 of that. A component of the
/// direction below 2^-1022 is off by 2^-1075, which 2^-1000 beside it more than pays for; other underflows are below
/// 2^-1072. Where anything overflows, the bound is infinite or no number.
inline int compare_along_rounded(const Line& d, const Point3& p, const Point3& q) {
  double value = 0;
  double terms = 0;
  double points = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const double term = d[i] * (p[i] - q[i]);
    value += term;
    terms += std::fabs(term);
    points += (std::fabs(d[i]) + 0x1p-1000) * (std::fabs(p[i]) + std::fabs(q[i]));
  }
  return certain_sign(value, 5.6e-16 * terms + 1.12e-16 * points + underflow_slack);
}

}  // namespace quoin::filter
