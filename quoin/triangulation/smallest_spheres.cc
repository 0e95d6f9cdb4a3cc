// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/smallest_spheres.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "quoin/kernel/call_grid.h"
#include "quoin/triangulation/sphere_filters.h"

namespace quoin {

namespace {

using sphere_filters::dot;
using sphere_filters::Estimate;
using sphere_filters::Row;
using sphere_filters::row;
using sphere_filters::u;

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
    result = sphere_filters::power_of(e, weight_of_origin);
  } else {
    const Row b = row_to(simplex[0], simplex[2]);
    const Row c = row_to(simplex[1], simplex[2]);
    if (!b.is_in_range || !c.is_in_range) return close_power(simplex);
    // Without weights any two sides will do: the shortest.
    if (is_weighted() || (a.size <= c.size && b.size <= c.size)) {
      result = sphere_filters::power_of(sphere_filters::estimate(a, b, c, is_weighted(), grid_), weight_of_origin);
    } else if (a.size <= b.size) {
      result = sphere_filters::power_of(sphere_filters::estimate(a, c, b, false, grid_), 0);
    } else {
      result = sphere_filters::power_of(sphere_filters::estimate(b, c, a, false, grid_), 0);
    }
  }
  return result ? *result : close_power(simplex);
}

SmallestSpheres::Cell SmallestSpheres::cell(std::array<std::uint32_t, 4> v) const {
  const unsigned origin = central({&points_[v[0]], &points_[v[1]], &points_[v[2]], &points_[v[3]]});
  std::array<unsigned, 4> slot{0, 0, 0, origin};
  std::array<Row, 3> rows;
  bool is_in_range = true;
  for (unsigned i = 0, k = 0; i < 4; ++i) {
    if (i == origin) continue;
    slot[k] = i;
    rows[k] = row(points_[v[origin]], points_[v[i]], is_weighted() ? weight(v[origin]) - weight(v[i]) : 0);
    is_in_range = is_in_range && rows[k].is_in_range;
    ++k;
  }
  std::optional<Interval> power;
  std::array<std::optional<Sign>, 4> sides;
  if (is_in_range) {
    const sphere_filters::CellFilter filter(rows);
    power = filter.power(weight(v[origin]), grid_);
    sides = filter.sides(grid_);
  }
  Cell result;
  result.power = power ? *power : close_power(v);
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned i = slot[k];
    const std::array<std::uint32_t, 3> facet{v[i == 0 ? 1 : 0], v[i <= 1 ? 2 : 1], v[i <= 2 ? 3 : 2]};
    result.side[i] = sides[k] ? *sides[k] : exact_side(facet, v[i]);
  }
  return result;
}

Sign SmallestSpheres::side(Simplex facet, std::uint32_t q) const {
  if (facet.size() == 3) return cell({facet[0], facet[1], facet[2], q}).side[3];
  std::optional<Sign> sign;
  if (facet.size() == 2 && !is_weighted()) {
    // The angle at q.
    const Row a = row(points_[q], points_[facet[0]], 0);
    const Row b = row(points_[q], points_[facet[1]], 0);
    const double sum = std::fabs(a.x * b.x) + std::fabs(a.y * b.y) + std::fabs(a.z * b.z);
    const bool is_exact = sum < grid_ * grid_ * 0x1p52;
    if (sum >= 0x1p-900 && sum <= 0x1p1000) sign = sphere_filters::sign_of(dot(a, b), is_exact ? 0 : 6 * u * sum);
  } else {
    sign = filtered_weighted_side(facet, q);
  }
  return sign ? *sign : exact_side(facet, q);
}

std::optional<Sign> SmallestSpheres::filtered_weighted_side(Simplex facet, std::uint32_t q) const {
  const std::uint32_t p = facet[0];
  const Row to_q = row(points_[p], points_[q], weight(p) - weight(q));
  if (!to_q.is_in_range) return std::nullopt;
  const double square = grid_ * grid_;
  if (facet.size() == 1) {
    return sphere_filters::sign_of(to_q.lift, to_q.span < square * 0x1p52 ? 0 : 8 * u * to_q.span);
  }
  const Row a = row(points_[p], points_[facet[1]], weight(p) - weight(facet[1]));
  if (!a.is_in_range) return std::nullopt;
  const double largest = std::max(to_q.span * a.size, a.span * to_q.size) * a.size;
  return sphere_filters::sign_of(to_q.lift * a.square - a.lift * dot(a, to_q),
                                 6 * largest < square * square * 0x1p52 ? 0 : 90 * u * largest);
}

}  // namespace quoin
