// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/number/error_free.h"
#include "quoin/number/interval.h"

/// Doubles with bounds of their errors, with u = 2^-53. A row is q - p with the largest magnitude s of a coordinate,
/// and L = 3 s^2 + |w_p - w_q| bounds its lift l. Coordinates of rows have the relative error u, products of two of
/// them 3u; then absolute errors
///   l: squares 9u s^2, sums 5u s^2, weights 2u |w_p - w_q|, s^2 3u: below 7u L;
///   minors of rows u, v: 8u su sv (below 2 su sv); det(u, v, w): 46u su sv sw (below 6 su sv sw);
///   l_u v x w: 24u L_u sv sw; N, the sum of three such: 82u Q with Q the largest of the three L s s (below 6 Q);
///   N (v x w): 732u Q sv sw (below 36 Q sv sw); 2 det^2 less three such: 3200u Q P, P the largest product of two
///   sizes; l_u v - l_v u: 20u K, K the larger of L_u sv and L_v su (below 2 K); l_q |u|^2 - l_u (u q): 82u max(L_q
///   su^2, L_u su sq) (below 6 times that).
/// Where sizes are from 2^-100 to 2^100 and differences of weights below 2^200 nothing overflows, and what underflow
/// loses, 2^-1074 times other factors, is far below u times the bound. Constants are a few percent larger.
namespace quoin::sphere_filters {

inline constexpr double u = 0x1p-53;
inline constexpr double root_of_three = 1.7320509;
inline constexpr double widest = 0x1p-36;  ///< relative error that makes do

struct Row {
  double x;
  double y;
  double z;
  double square;
  double lift;
  double size;
  double span;
  bool is_in_range;
};

inline Row row(const Point3& p, const Point3& q, double weight_difference) {
  Row r{q.x - p.x, q.y - p.y, q.z - p.z, 0, 0, 0, 0, false};
  r.square = r.x * r.x + r.y * r.y + r.z * r.z;
  r.lift = r.square + weight_difference;
  r.size = std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)});
  r.span = 3 * (r.size * r.size) + std::fabs(weight_difference);
  r.is_in_range = r.size >= 0x1p-100 && r.size <= 0x1p100 && std::fabs(weight_difference) <= 0x1p200;
  return r;
}

struct Vector {
  double x;
  double y;
  double z;
};
inline Vector cross(const Row& a, const Row& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double dot(const Row& a, const Row& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// 4 |x|^2 as it is computed, for the centre x.
struct Estimate {
  double numerator;
  double numerator_error;  ///< absolute
  double denominator;
  double denominator_error;  ///< relative, of its square root
  bool is_exact;             ///< both are what they should be
};

/// Nothing where the error is too large.
inline std::optional<Interval> power_of(const Estimate& e, double weight) {
  if (!e.is_exact && !(e.denominator_error < 0x1p-10)) return std::nullopt;
  const double divisor = 4 * e.denominator;
  const double quotient = e.numerator / divisor;
  double error = 0;
  if (e.is_exact) {
    const TwoDoubles product = two_product(quotient, divisor);
    const bool is_exact =
        is_product_exact_range(quotient, divisor) && product.value == e.numerator && product.tail == 0;
    if (!is_exact) error = 1.1 * u * quotient;
  } else {
    error = 1.01 * (e.numerator_error / divisor) + (2.1 * e.denominator_error + 12 * u) * quotient;
  }
  if (!(error <= widest * (quotient + std::fabs(weight)))) return std::nullopt;
  if (error > 0) error = error * (1 + 0x1p-20) + 2 * u * quotient;
  const Interval square(quotient - error, quotient + error);
  return weight == 0 ? square : square - Interval(weight);
}

inline Estimate estimate(const Row& a, const Row& b, const Row& difference, bool is_weighted, double grid) {
  const Vector normal = cross(a, b);
  Estimate e{};
  e.denominator = dot(normal, normal);
  e.denominator_error = root_of_three * 8.2 * u * a.size * b.size / std::sqrt(e.denominator);
  const double limit = grid * grid * grid * grid * 0x1p52;
  e.is_exact = 12 * (a.size * b.size) * (a.size * b.size) < limit;
  if (!is_weighted) {
    e.numerator = a.square * b.square * difference.square;
    e.numerator_error = 20 * u * e.numerator;
    e.is_exact = e.is_exact && e.numerator < limit * (grid * grid);
    return e;
  }
  const Vector across{a.lift * b.x - b.lift * a.x, a.lift * b.y - b.lift * a.y, a.lift * b.z - b.lift * a.z};
  const double largest = std::max(a.span * b.size, b.span * a.size);
  const double error = root_of_three * 21 * u * largest;
  e.numerator = dot(across, across);
  e.numerator_error = error * (2 * std::sqrt(e.numerator) + error) + 6 * u * e.numerator;
  e.is_exact = e.is_exact && 12 * largest * largest < limit * (grid * grid);
  return e;
}

/// The sign of a number with an absolute error; known if that is zero.
inline std::optional<Sign> sign_of(double value, double error) {
  if (value > error) return Sign::positive;
  if (value < -error) return Sign::negative;
  return error == 0 ? std::optional(Sign::zero) : std::nullopt;
}

/// A tetrahedron by the rows from one of its points, the origin.
class CellFilter {
 public:
  explicit CellFilter(const std::array<Row, 3>& rows)
      : rows_(rows), minor_{cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])} {
    const auto along = [&](double Vector::*axis) {
      return rows[0].lift * (minor_[0].*axis) + rows[1].lift * (minor_[1].*axis) + rows[2].lift * (minor_[2].*axis);
    };
    centre_ = {along(&Vector::x), along(&Vector::y), along(&Vector::z)};
    volume_ = rows[0].x * minor_[0].x + rows[0].y * minor_[0].y + rows[0].z * minor_[0].z;
    pair_ = {rows[1].size * rows[2].size, rows[2].size * rows[0].size, rows[0].size * rows[1].size};
    largest_pair_ = std::max({pair_[0], pair_[1], pair_[2]});
    largest_ = std::max({rows[0].span * pair_[0], rows[1].span * pair_[1], rows[2].span * pair_[2]});
  }

  /// `weight` is that of the origin.
  std::optional<Interval> power(double weight, double grid) const {
    const double square = grid * grid;
    const double error = root_of_three * 84 * u * largest_;
    Estimate e{dot(centre_, centre_), 0, volume_ * volume_, 0, false};
    e.numerator_error = error * (2 * std::sqrt(e.numerator) + error) + 6 * u * e.numerator;
    e.denominator_error = 48 * u * pair_[0] * rows_[0].size / std::fabs(volume_);
    e.is_exact = 108 * largest_ * largest_ < square * square * square * square * 0x1p52;
    return power_of(e, weight);
  }

  /// Sides of the ends of the rows, and of the origin, in the spheres of the facets opposite: signs of the coordinates
  /// of the centre in the basis of the rows, and of one less their sum.
  std::array<std::optional<Sign>, 4> sides(double grid) const {
    const double square = grid * grid;
    const bool is_exact = 140 * largest_ * largest_pair_ < square * square * square * 0x1p52;
    std::array<std::optional<Sign>, 4> result;
    double rest = 2 * volume_ * volume_;
    for (unsigned k = 0; k < 3; ++k) {
      const double coordinate = dot(centre_, minor_[k]);
      rest -= coordinate;
      result[k] = sign_of(coordinate, is_exact ? 0 : 800 * u * largest_ * pair_[k]);
    }
    result[3] = sign_of(rest, is_exact ? 0 : 3300 * u * largest_ * largest_pair_);
    return result;
  }

 private:
  std::array<Row, 3> rows_;
  std::array<Vector, 3> minor_;
  Vector centre_{};
  double volume_;
  std::array<double, 3> pair_{};  ///< products of the sizes of the other two rows
  double largest_pair_;
  double largest_;
};

}  // namespace quoin::sphere_filters
