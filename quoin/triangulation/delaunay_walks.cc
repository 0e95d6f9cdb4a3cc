// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_walks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"
#include "quoin/triangulation/grid_integers.h"

namespace quoin {

namespace {

double square(const Point3& p, const Point3& q) {
  const double x = p.x - q.x;
  const double y = p.y - q.y;
  const double z = p.z - q.z;
  return x * x + y * y + z * z;
}

/// Of all coordinates, which are multiples of 2^lo, and weights, of 2^(2 lo).
int compare_powers_exactly(const Point3& p, const Point3& a, double weight_a, const Point3& b, double weight_b) {
  const int lo = detail::grid_of_weighted(std::array{p, a, b}, std::array{weight_a, weight_b});
  const auto power = [&](const Point3& q, double weight) {
    Integer sum = -detail::on_grid(weight, 2 * lo);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Integer difference = detail::on_grid(p[axis], lo) - detail::on_grid(q[axis], lo);
      sum += difference * difference;
    }
    return sum;
  };
  return to_int((power(a, weight_a) - power(b, weight_b)).sign());
}

}  // namespace

void require_finite(const Point3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw InputError("a point to be found in a triangulation is not finite");
  }
}

/// Computed squares err by at most 3 u each, their sums by 2 u more: 5 u (1 + 8 u) of either, less than 6e-16, and the
/// difference by u; 2^-1000 is for underflow. Where anything overflows nothing is decided. Exact squares of differences
/// below 2^(B + 1), of integers of B bits, sum up to less than 2^(2B + 4), as Quadratic holds.
int compare_distances(const Point3& p, const Point3& a, const Point3& b) {
  const double to_a = square(p, a);
  const double to_b = square(p, b);
  if (std::fabs(to_a - to_b) > 8e-16 * (to_a + to_b) + 0x1p-1000 && to_a + to_b <= 0x1p1000)
    return to_a > to_b ? 1 : -1;
  Tier ignored;
  const std::array<double, 9> values{p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z};
  return to_int(detail::decide_on_grid(values, ignored, [&]<class N>(const detail::CallReader<N>& difference) {
    using Quadratic = typename N::Quadratic;
    const auto square_distance = [&](const Point3& q) {
      const auto x = difference(p.x, q.x);
      const auto y = difference(p.y, q.y);
      const auto z = difference(p.z, q.z);
      return detail::product<Quadratic>(x, x) + detail::product<Quadratic>(y, y) + detail::product<Quadratic>(z, z);
    };
    return (square_distance(a) - square_distance(b)).sign();
  }));
}

/// Squares as of compare_distances, 5 u of their sum S; their difference and that of the weights, of size W, are
/// rounded by u each, and so is the last difference: 7 u S + 2 u W, less than 7.8e-16 (S + W).
int compare_powers(const Point3& p, const Point3& a, double weight_a, const Point3& b, double weight_b) {
  if (weight_a == weight_b) return compare_distances(p, a, b);
  const double to_a = square(p, a);
  const double to_b = square(p, b);
  const double weights = weight_a - weight_b;
  const double value = (to_a - to_b) - weights;
  const double size = to_a + to_b + std::fabs(weights);
  if (std::fabs(value) > 9e-16 * size + 0x1p-1000 && size <= 0x1p1000) return value > 0 ? 1 : -1;
  return compare_powers_exactly(p, a, weight_a, b, weight_b);
}

}  // namespace quoin
