// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular_signs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "quoin/triangulation/grid_integers.h"

namespace quoin {

namespace {

struct WeightedRow {
  double x;
  double y;
  double z;
  double weight;
  double lift;

  WeightedRow(const Point3& p, double p_weight, const Point3& q, double q_weight)
      : x(p.x - q.x), y(p.y - q.y), z(p.z - q.z), weight(p_weight - q_weight), lift(x * x + y * y + z * z - weight) {}
};

double minor(const WeightedRow& a, const WeightedRow& b, const WeightedRow& c) {
  return c.z * (a.x * b.y - a.y * b.x) + a.z * (b.x * c.y - b.y * c.x) + b.z * (c.x * a.y - c.y * a.x);
}

/// (x, y, z, |.|^2 - weight) of a difference, times 2^-lo and 2^(-2 lo).
using IntegerRow = std::array<Integer, 4>;

Integer minor(const IntegerRow& a, const IntegerRow& b, const IntegerRow& c) {
  return c[2] * (a[0] * b[1] - a[1] * b[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]) + b[2] * (c[0] * a[1] - c[1] * a[0]);
}

WeightExtent extent_of(std::span<const double> weights) {
  WeightExtent extent;
  for (const double w : weights) extent.add(w);
  return extent;
}

}  // namespace

void WeightExtent::add(double weight) {
  largest = std::max(largest, std::fabs(weight));
  lowest_bit = std::min(lowest_bit, detail::lowest_bit(weight));
}

RegularSigns::RegularSigns(std::span<const Point3> points, std::span<const double> weights, bool is_flat)
    : RegularSigns(points, weights, PointExtent(points), extent_of(weights),
                   is_flat ? static_cast<std::uint32_t>(points.size() - 1) : no_vertex) {}

RegularSigns::RegularSigns(std::span<const Point3> points, std::span<const double> weights, const PointExtent& extent,
                           const WeightExtent& weight_extent, std::uint32_t apex)
    : plain_(points, extent, apex), points_(points.data()), weights_(weights.data()) {
  const double g = extent.grid;
  // Magnitudes of all terms sum up to at most 4 (3 M^2 + W) 6 XYZ.
  if (g > 0 && weight_extent.lowest_bit >= 2 * std::ilogb(g) && weight_extent.largest <= g * g * 0x1p53) {
    grid_ = g * g * g * g * g * (0x1p52 / 24);
  }
}

/// With lifts of size L = 3 M^2 + W, W the largest difference of weights: squares 3 each, sums 2 and 3, the difference
/// of weights 1 and the last difference 1: at most 6 u L (14 u M^2 + W + L, and 14 <= 3 * 14 / 3). Minors 46 u XYZ of
/// size 6. Terms 46 + 36 + 6 = 88, four of them 352, sums of size 12, 12 and 24: 400 u XYZ L (1 + 30 u) < 4.45e-14.
/// Underflow as of filter::in_sphere, where M <= 2^140 and W <= 2^280.
int RegularSigns::power_sign(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                             std::uint32_t q) const {
  const auto row = [&](std::uint32_t v) { return WeightedRow(points_[v], weights_[v], points_[q], weights_[q]); };
  const WeightedRow ra = row(a);
  const WeightedRow rb = row(b);
  const WeightedRow rc = row(c);
  const WeightedRow rd = row(d);
  const double value = (ra.lift * minor(rb, rc, rd) - rb.lift * minor(ra, rc, rd)) +
                       (rc.lift * minor(ra, rb, rd) - rd.lift * minor(ra, rb, rc));
  const auto largest = [](double i, double j, double k, double l) {
    return std::max(std::max(std::fabs(i), std::fabs(j)), std::max(std::fabs(k), std::fabs(l)));
  };
  const double x = largest(ra.x, rb.x, rc.x, rd.x);
  const double y = largest(ra.y, rb.y, rc.y, rd.y);
  const double z = largest(ra.z, rb.z, rc.z, rd.z);
  const double w = largest(ra.weight, rb.weight, rc.weight, rd.weight);
  const double m = std::max(std::max(x, y), z);
  if (m <= 0x1p140 && w <= 0x1p280) {
    const double size = x * y * z * (3 * (m * m) + w);
    if (std::fabs(value) > 4.6e-14 * size + 0x1p-640) return value > 0 ? 1 : -1;
    if (size < grid_) return (value > 0) - (value < 0);
  }
  return exact_power_sign({a, b, c, d, q});
}

int RegularSigns::exact_power_sign(const std::array<std::uint32_t, 5>& v) const {
  std::array<Point3, 5> points;
  std::array<double, 5> weights{};
  for (std::size_t i = 0; i < 5; ++i) {
    points[i] = points_[v[i]];
    weights[i] = weights_[v[i]];
  }
  const int lo = detail::grid_of_weighted(points, weights);
  std::array<IntegerRow, 5> rows;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto& [x, y, z] = points[i];
    rows[i] = {detail::on_grid(x, lo), detail::on_grid(y, lo), detail::on_grid(z, lo),
               detail::on_grid(weights[i], 2 * lo)};
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) rows[i][k] -= rows[4][k];
    const auto& [x, y, z, weight] = rows[i];
    rows[i][3] = x * x + y * y + z * z - weight;
  }
  const IntegerRow& a = rows[0];
  const IntegerRow& b = rows[1];
  const IntegerRow& c = rows[2];
  const IntegerRow& d = rows[3];
  return to_int((a[3] * minor(b, c, d) - b[3] * minor(a, c, d) + c[3] * minor(a, b, d) - d[3] * minor(a, b, c)).sign());
}

}  // namespace quoin
