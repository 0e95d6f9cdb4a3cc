// SPDX-License-Identifier: Apache-2.0
//
// Bounds, with u = 2^-53. A row is q - p with the largest magnitude s of a coordinate, and L = 3 s^2 + |w_p - w_q|
// bounds its lift l. Coordinates of rows have the relative error u, products of two of them 3u; then absolute errors
//   l: squares 9u s^2, sums 5u s^2, weights 2u |w_p - w_q|, s^2 3u: below 7u L;
//   minors of rows u, v: 8u su sv (below 2 su sv); det(u, v, w): 46u su sv sw (below 6 su sv sw);
//   l_u v x w: 24u L_u sv sw; N, the sum of three such: 82u Q with Q the largest of the three L s s (below 6 Q);
//   N (v x w): 732u Q sv sw (below 36 Q sv sw); 2 det^2 less three such: 3200u Q P, P the largest product of two sizes;
//   l_u v - l_v u: 20u K, K the larger of L_u sv and L_v su (below 2 K);
//   l_q |u|^2 - l_u (u q): 82u max(L_q su^2, L_u su sq) (below 6 times that).
// Where sizes are from 2^-100 to 2^100 and differences of weights below 2^200 nothing overflows, and what underflow
// loses, 2^-1074 times other factors, is far below u times the bound. Constants are a few percent larger.
#include "quoin/triangulation/smallest_spheres.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "quoin/kernel/call_grid.h"
#include "quoin/number/error_free.h"

namespace quoin {

namespace {

constexpr double u = 0x1p-53;
constexpr double root_of_three = 1.7320509;
constexpr double widest = 0x1p-36;  ///< relative error that makes do

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
Vector cross(const Row& a, const Row& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double dot(const Row& a, const Row& b) {
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
std::optional<Interval> power_of(const Estimate& e, double weight) {
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

Estimate estimate(const Row& a, const Row& b, const Row& difference, bool is_weighted, double grid) {
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

/// The vertex from which the rows are shortest, by the sum of squares.
unsigned central(const std::array<const Point3*, 4>& p) {
  std::array<double, 4> sums{};
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = 0; j < i; ++j) {
      const double x = p[i]->x - p[j]->x;
      const double y = p[i]->y - p[j]->y;
      const double z = p[i]->z - p[j]->z;
      const double square = x * x + y * y + z * z;
      sums[i] += square;
      sums[j] += square;
    }
  }
  return static_cast<unsigned>(std::min_element(sums.begin(), sums.end()) - sums.begin());
}

/// The common grid, of which fourth powers and eighth powers are doubles.
double common_grid(const std::vector<Point3>& points, const std::vector<double>& weights) {
  int lowest = 2000;
  const auto lower = [&lowest](double v, int degree) {
    if (v == 0) return;
    const detail::Parts parts = detail::parts_of(v);
    const int bit = parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
    lowest = std::min(lowest, degree == 1 ? bit : bit >> 1);
  };
  for (const Point3& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) lower(p[axis], 1);
  }
  for (const double w : weights) lower(w, 2);
  return lowest >= -100 && lowest <= 100 ? std::ldexp(1.0, lowest) : 0;
}

double integer_scale(const std::vector<Point3>& points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  if (!(largest < 0x1p300 && largest > 0x1p-300)) return 0;
  int exponent = 0;
  std::frexp(largest, &exponent);  // below 2^exponent
  return std::ldexp(1.0, 61 - exponent);
}

Sign sign_beyond(double value, double error, Sign otherwise) {
  return value > error ? Sign::positive : value < -error ? Sign::negative : otherwise;
}

}  // namespace

SmallestSpheres::SmallestSpheres(std::vector<Point3> points, std::vector<double> weights)
    : points_(std::move(points)),
      weights_(std::move(weights)),
      grid_(common_grid(points_, weights_)),
      scale_(integer_scale(points_)) {}

Interval SmallestSpheres::power(Simplex simplex) const {
  if (simplex.size() == 1) return {-weight(simplex[0])};
  if (simplex.size() == 4) return cell({simplex[0], simplex[1], simplex[2], simplex[3]}).power;
  const double weight_of_origin = weight(simplex[0]);
  const auto row_to = [&](std::uint32_t from, std::uint32_t to) {
    return row(points_[from], points_[to], is_weighted() ? weight(from) - weight(to) : 0);
  };
  const Row a = row_to(simplex[0], simplex[1]);
  if (!a.is_in_range) return close_power(simplex);
  std::optional<Interval> result;
  if (simplex.size() == 2) {
    Estimate e{a.lift * a.lift, 0, a.square, 3 * u, false};
    if (!is_weighted()) {
      e = {a.square, 6 * u * a.square, 1, 0, a.square < grid_ * grid_ * 0x1p52};
    } else {
      const double error = 7.1 * u * a.span;
      e.numerator_error = error * (2 * std::fabs(a.lift) + error) + u * e.numerator;
      e.is_exact = a.span * a.span < grid_ * grid_ * grid_ * grid_ * 0x1p52;
    }
    result = power_of(e, weight_of_origin);
  } else {
    const Row b = row_to(simplex[0], simplex[2]);
    const Row c = row_to(simplex[1], simplex[2]);
    if (!b.is_in_range || !c.is_in_range) return close_power(simplex);
    // Without weights any two sides will do: the shortest.
    if (is_weighted() || (a.size <= c.size && b.size <= c.size)) {
      result = power_of(estimate(a, b, c, is_weighted(), grid_), weight_of_origin);
    } else if (a.size <= b.size) {
      result = power_of(estimate(a, c, b, false, grid_), 0);
    } else {
      result = power_of(estimate(b, c, a, false, grid_), 0);
    }
  }
  return result ? *result : close_power(simplex);
}

SmallestSpheres::Cell SmallestSpheres::cell(std::array<std::uint32_t, 4> v) const {
  const unsigned origin = central({&points_[v[0]], &points_[v[1]], &points_[v[2]], &points_[v[3]]});
  std::array<unsigned, 3> slot{};
  std::array<Row, 3> r;
  bool is_in_range = true;
  for (unsigned i = 0, k = 0; i < 4; ++i) {
    if (i == origin) continue;
    slot[k] = i;
    r[k] = row(points_[v[origin]], points_[v[i]], is_weighted() ? weight(v[origin]) - weight(v[i]) : 0);
    is_in_range = is_in_range && r[k++].is_in_range;
  }
  Cell result;
  result.side.fill(Sign::zero);
  std::optional<Interval> power;
  std::array<bool, 4> is_decided{};
  if (is_in_range) {
    const std::array<Vector, 3> minor{cross(r[1], r[2]), cross(r[2], r[0]), cross(r[0], r[1])};
    const auto along = [&](double Vector::*axis) {
      return r[0].lift * (minor[0].*axis) + r[1].lift * (minor[1].*axis) + r[2].lift * (minor[2].*axis);
    };
    const Vector centre{along(&Vector::x), along(&Vector::y), along(&Vector::z)};
    const double volume = r[0].x * minor[0].x + r[0].y * minor[0].y + r[0].z * minor[0].z;
    const std::array<double, 3> pair{r[1].size * r[2].size, r[2].size * r[0].size, r[0].size * r[1].size};
    const double largest = std::max({r[0].span * pair[0], r[1].span * pair[1], r[2].span * pair[2]});
    const double largest_pair = std::max({pair[0], pair[1], pair[2]});
    const double grid2 = grid_ * grid_;

    Estimate e{dot(centre, centre), 0, volume * volume, 0, false};
    const double error = root_of_three * 84 * u * largest;
    e.numerator_error = error * (2 * std::sqrt(e.numerator) + error) + 6 * u * e.numerator;
    e.denominator_error = 48 * u * pair[0] * r[0].size / std::fabs(volume);
    e.is_exact = 108 * largest * largest < grid2 * grid2 * grid2 * grid2 * 0x1p52;
    power = power_of(e, weight(v[origin]));

    // The coordinates of the centre in the basis of the rows are those that are negative across from a facet that is
    // seen.
    const bool is_exact = 140 * largest * largest_pair < grid2 * grid2 * grid2 * 0x1p52;
    double rest = 2 * volume * volume;
    for (unsigned k = 0; k < 3; ++k) {
      const double coordinate = dot(centre, minor[k]);
      rest -= coordinate;
      result.side[slot[k]] = sign_beyond(coordinate, is_exact ? 0 : 800 * u * largest * pair[k], Sign::zero);
      is_decided[slot[k]] = is_exact || result.side[slot[k]] != Sign::zero;
    }
    result.side[origin] = sign_beyond(rest, is_exact ? 0 : 3300 * u * largest * largest_pair, Sign::zero);
    is_decided[origin] = is_exact || result.side[origin] != Sign::zero;
  }
  result.power = power ? *power : close_power(v);
  for (unsigned i = 0; i < 4; ++i) {
    if (is_decided[i]) continue;
    const std::array<std::uint32_t, 3> facet{v[i == 0 ? 1 : 0], v[i <= 1 ? 2 : 1], v[i <= 2 ? 3 : 2]};
    result.side[i] = exact_side(facet, v[i]);
  }
  return result;
}

Sign SmallestSpheres::side(Simplex facet, std::uint32_t q) const {
  if (facet.size() == 3) return cell({facet[0], facet[1], facet[2], q}).side[3];
  const std::uint32_t p = facet[0];
  if (facet.size() == 2 && !is_weighted()) {
    // The angle at q.
    const Row a = row(points_[q], points_[p], 0);
    const Row b = row(points_[q], points_[facet[1]], 0);
    const double sum = std::fabs(a.x * b.x) + std::fabs(a.y * b.y) + std::fabs(a.z * b.z);
    const double value = dot(a, b);
    if (sum >= 0x1p-900 && sum <= 0x1p1000) {
      const Sign sign = sign_beyond(value, 6 * u * sum, Sign::zero);
      if (sign != Sign::zero || sum < grid_ * grid_ * 0x1p52) return sign_beyond(value, 0, Sign::zero);
    }
    return exact_side(facet, q);
  }
  const Row to_q = row(points_[p], points_[q], weight(p) - weight(q));
  double value = to_q.lift;
  double size = to_q.span;
  double error = 8 * u * size;
  double limit = grid_ * grid_ * 0x1p52;
  bool is_in_range = to_q.is_in_range;
  if (facet.size() == 2) {
    const Row a = row(points_[p], points_[facet[1]], weight(p) - weight(facet[1]));
    is_in_range = is_in_range && a.is_in_range;
    value = to_q.lift * a.square - a.lift * dot(a, to_q);
    size = 6 * std::max(to_q.span * a.size, a.span * to_q.size) * a.size;
    error = 15 * u * size;
    limit *= grid_ * grid_;
  }
  if (is_in_range) {
    if (size < limit) return sign_beyond(value, 0, Sign::zero);
    const Sign sign = sign_beyond(value, error, Sign::zero);
    if (sign != Sign::zero) return sign;
  }
  return exact_side(facet, q);
}

}  // namespace quoin
