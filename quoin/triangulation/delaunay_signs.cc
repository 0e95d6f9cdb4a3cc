// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_signs.h"

#include <algorithm>
#include <limits>

#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/scaled_sphere.h"

namespace quoin {

namespace {

// Bounds of the filters of the whole: those of predicate_filters.h with the extents for the maxima, and a part in 2^40
// more, because extents are rounded. The slacks are those derived there for M <= 2^140.
constexpr double largest_extent = 0x1p140;
constexpr double more = 1 + 0x1p-40;
constexpr double sphere_slack = 0x1p-640;
constexpr double orientation_slack = 0x1p-730;
constexpr double sphere_error = 1.3e-13;
constexpr double orientation_error = 5.2e-15;

}  // namespace

void GrowingExtent::add(const Point3& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double v = p[axis];
    low_[axis] = std::min(low_[axis], v);
    high_[axis] = std::max(high_[axis], v);
    lowest_bit_ = std::min(lowest_bit_, detail::lowest_bit(v));
  }
}

PointExtent GrowingExtent::extent() const {
  PointExtent extent;
  extent.x = high_[0] - low_[0];
  extent.y = high_[1] - low_[1];
  extent.z = high_[2] - low_[2];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent.largest = std::max({extent.largest, std::fabs(low_[axis]), std::fabs(high_[axis])});
  }
  // Fifth powers of it must be doubles that do not lose bits.
  if (lowest_bit_ >= -200 && lowest_bit_ <= 200) extent.grid = std::ldexp(1.0, lowest_bit_);
  return extent;
}

PointExtent::PointExtent(std::span<const Point3> points) {
  GrowingExtent growing;
  for (const Point3& p : points) growing.add(p);
  *this = growing.extent();
}

DelaunaySigns::DelaunaySigns(std::span<const Point3> points, bool is_flat)
    : DelaunaySigns(points, PointExtent(points), is_flat ? static_cast<std::uint32_t>(points.size() - 1) : no_vertex) {}

DelaunaySigns::DelaunaySigns(std::span<const Point3> points, const PointExtent& extent, std::uint32_t apex)
    : points_(points.data()),
      apex_(apex),
      orientation_bound_(std::numeric_limits<double>::infinity()),
      sphere_bound_(std::numeric_limits<double>::infinity()) {
  const double m = std::max({extent.x, extent.y, extent.z});
  // Of grids: the determinants' terms are multiples of the power of the grid, and below 2^53 times it where 6 XYZ and
  // 72 XYZ M^2 (the sum of the magnitudes of all terms) are; 2^52, as the products round. Where a maximum is below the
  // grid it is zero, and so is every term.
  const double g = extent.grid;
  orientation_grid_ = g * g * g * (0x1p52 / 6);
  sphere_grid_ = g * g * g * g * g * (0x1p52 / 72);
  if (extent.largest < 0x1p300 && extent.largest > 0x1p-300) {
    int exponent = 0;
    std::frexp(extent.largest, &exponent);  // below 2^exponent
    integer_scale_ = std::ldexp(1.0, 61 - exponent);
    integer_unit_ = std::ldexp(1.0, exponent - 61);
  }
  choose_keys(extent);
  if (!(m <= largest_extent)) return;
  const double volume = extent.x * extent.y * extent.z;
  is_orientation_exact_ = volume < orientation_grid_;
  is_sphere_exact_ = volume * (m * m) < sphere_grid_;
  orientation_bound_ = is_orientation_exact_ ? 0 : orientation_error * more * volume + orientation_slack;
  sphere_bound_ = is_sphere_exact_ ? 0 : sphere_error * more * volume * (m * m) + sphere_slack;
}

int DelaunaySigns::close_orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                                     double value) const {
  if (is_orientation_exact_) return (value > 0) - (value < 0);
  if (apex_ != no_vertex && a != apex_ && b != apex_ && c != apex_ && d != apex_) return 0;
  const filter::Orientation det(points_[a], points_[b], points_[c], points_[d]);
  if (det.x * det.y * det.z < orientation_grid_) return (value > 0) - (value < 0);
  return to_int(quoin::orientation(points_[a], points_[b], points_[c], points_[d]));
}

int DelaunaySigns::close_sphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q,
                                double value) const {
  if (is_sphere_exact_) return (value > 0) - (value < 0);
  const filter::InSphere det(points_[a], points_[b], points_[c], points_[d], points_[q]);
  const double m = std::max({det.x, det.y, det.z});
  if (m <= largest_extent) {
    const double size = det.x * det.y * det.z * (m * m);
    if (std::fabs(value) > sphere_error * size + sphere_slack) return value > 0 ? 1 : -1;
    if (size < sphere_grid_) return (value > 0) - (value < 0);
  }
  int sign = 0;
  if (detail::in_sphere_of_integers({&points_[a], &points_[b], &points_[c], &points_[d], &points_[q]}, integer_scale_,
                                    integer_unit_, sign)) {
    return sign;
  }
  Tier ignored;
  return to_int(detail::exact_in_sphere(points_[a], points_[b], points_[c], points_[d], points_[q], ignored));
}

bool DelaunaySigns::close_conflict(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t q,
                                   double value) const {
  // Where doubles are exact the filter's bound is zero, and so is what it does not decide.
  const int sign = is_sphere_exact_ ? 0 : close_sphere(a, b, c, d, q, value);
  if (sign != 0) return sign > 0;
  const std::array<std::uint32_t, 5> v{a, b, c, d, q};
  const auto sign_of_four = [this](auto... vertices) { return orientation(vertices...); };
  if (has_keys_) {
    std::array<double, 5> keys;
    for (std::size_t i = 0; i < 5; ++i) keys[i] = points_[v[i]].x * key_x_ + points_[v[i]].y * key_y_ + points_[v[i]].z;
    // Mostly the point that is lifted most decides, before the others are put in order.
    const double most = std::max(std::max(keys[0], keys[1]), std::max(keys[2], keys[3]));
    if (keys[4] > most) return false;
    const auto or_q = [&](std::size_t i) { return keys[i] == most ? q : v[i]; };
    const int weight = orientation(or_q(0), or_q(1), or_q(2), or_q(3));
    if (weight != 0) return weight > 0;
    return is_perturbed_inside(
        v, [&](unsigned i, unsigned j) { return keys[i] < keys[j]; }, sign_of_four);
  }
  const auto is_less = [&](unsigned i, unsigned j) { return lexicographically_less(points_[v[i]], points_[v[j]]); };
  return is_perturbed_inside(v, is_less, sign_of_four);
}

/// A step in y exceeds all of z, a step in x all of both. Factors are integers, all terms multiples of the grid.
void DelaunaySigns::choose_keys(const PointExtent& extent) {
  const double g = extent.grid;
  if (g == 0 || !(extent.largest < g * 0x1p50)) return;
  key_y_ = extent.z / g + 1;
  key_x_ = (extent.y * key_y_ + extent.z) / g + 1;
  has_keys_ = extent.largest * (key_x_ + key_y_ + 1) < g * 0x1p52;
}

int DelaunaySigns::in_sphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                             std::uint32_t q) const {
  const filter::InSphere det(points_[a], points_[b], points_[c], points_[d], points_[q]);
  if (std::fabs(det.value) > sphere_bound_) return det.value > 0 ? 1 : -1;
  return close_sphere(a, b, c, d, q, det.value);
}

}  // namespace quoin
