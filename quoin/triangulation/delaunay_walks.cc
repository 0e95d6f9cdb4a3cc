// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_walks.h"

#include <array>
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"

namespace quoin {

void require_finite(const Point3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw InputError("a point to be found in a triangulation is not finite");
  }
}

/// Computed squares err by at most 3 u each, their sums by 2 u more: 5 u (1 + 8 u) of either, less than 6e-16, and the
/// difference by u; 2^-1000 is for underflow. Where anything overflows nothing is decided. Exact squares of differences
/// below 2^(B + 1), of integers of B bits, sum up to less than 2^(2B + 4), as Quadratic holds.
int compare_distances(const Point3& p, const Point3& a, const Point3& b) {
  const auto square = [&p](const Point3& q) {
    const double x = p.x - q.x;
    const double y = p.y - q.y;
    const double z = p.z - q.z;
    return x * x + y * y + z * z;
  };
  const double to_a = square(a);
  const double to_b = square(b);
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

}  // namespace quoin
