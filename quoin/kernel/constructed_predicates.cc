// SPDX-License-Identifier: Apache-2.0
//
// Predicates of Constructions on any points: filters whose bounds are derived in constructed_filters.h, then integers.
#include <array>

#include "quoin/kernel/constructed_filters.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

using Homogeneous = std::array<Integer, 4>;

/// The vector p - q times a positive scale, the product of the weights.
template <std::size_t D>
struct Difference {
  std::array<Integer, D> vector;
  Integer scale;

  Difference(const Homogeneous& p, const Homogeneous& q, const std::array<unsigned, D>& axes) : scale(p[3] * q[3]) {
    for (std::size_t k = 0; k < D; ++k) vector[k] = p[axes[k]] * q[3] - q[axes[k]] * p[3];
  }

  Integer square() const {
    Integer sum;
    for (const Integer& x : vector) sum += x * x;
    return sum;
  }
};

constexpr std::array<unsigned, 3> all_axes{0, 1, 2};

std::array<unsigned, 2> axes_across(unsigned axis) {
  return {(axis + 1) % 3, (axis + 2) % 3};
}

Integer determinant(const Difference<2>& a, const Difference<2>& b) {
  return detail::cross<Integer>(a.vector[0], a.vector[1], b.vector[0], b.vector[1]);
}

Integer determinant(const Difference<3>& a, const Difference<3>& b, const Difference<3>& c) {
  return detail::dot<Integer>(detail::cross<Integer>(a.vector, b.vector), c.vector);
}

/// Term of the expansion of det(rows (r / s, r^2 / s^2)) times all s^2, by the lifted column: r^2 of one row times s of
/// the others times the minor of their r.
template <std::size_t D, class... Others>
Integer lifted_minor(const Difference<D>& lifted, const Others&... others) {
  return lifted.square() * (others.scale * ...) * determinant(others...);
}

Point2 projected(const Point3& p, unsigned axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

}  // namespace

Sign Constructions::counted(Sign sign, Tier tier) const {
  if (tier == Tier::filter) {
    counter_->count_filter();
  } else {
    counter_->count_exact();
  }
  return sign;
}

Sign Constructions::turn_beyond_explicit(PointId a, PointId b, PointId c, unsigned axis) const {
  const auto axes = axes_across(axis);
  const int sign = filter::turn_rounded(rounded(a), rounded(b), rounded(c), axes[0], axes[1]);
  if (is_decided(sign)) return static_cast<Sign>(sign);
  const Homogeneous from = homogeneous(a);
  const Difference<2> ab(homogeneous(b), from, axes);
  const Difference<2> ac(homogeneous(c), from, axes);
  return counted(determinant(ab, ac).sign(), Tier::big);
}

Sign Constructions::orientation_any(PointId a, PointId b, PointId c, PointId d) const {
  if (is_explicit(a) && is_explicit(b) && is_explicit(c) && is_explicit(d)) return orientation(a, b, c, d);
  const int sign = filter::orientation_rounded(rounded(a), rounded(b), rounded(c), rounded(d));
  if (is_decided(sign)) return static_cast<Sign>(sign);
  const Homogeneous from = homogeneous(a);
  const Difference<3> ab(homogeneous(b), from, all_axes);
  const Difference<3> ac(homogeneous(c), from, all_axes);
  const Difference<3> ad(homogeneous(d), from, all_axes);
  return counted(determinant(ab, ac, ad).sign(), Tier::big);
}

Sign Constructions::in_circle(PointId a, PointId b, PointId c, PointId d, unsigned axis) const {
  if (has_exact_doubles(a) && has_exact_doubles(b) && has_exact_doubles(c) && has_exact_doubles(d)) {
    Tier tier{};
    const Sign sign = quoin::in_circle(projected(rounded(a), axis), projected(rounded(b), axis),
                                       projected(rounded(c), axis), projected(rounded(d), axis), tier);
    return counted(sign, tier);
  }
  const auto axes = axes_across(axis);
  const int sign = filter::in_circle_rounded(rounded(a), rounded(b), rounded(c), rounded(d), axes[0], axes[1]);
  if (is_decided(sign)) return static_cast<Sign>(sign);
  const Homogeneous from = homogeneous(d);
  const Difference<2> da(homogeneous(a), from, axes);
  const Difference<2> db(homogeneous(b), from, axes);
  const Difference<2> dc(homogeneous(c), from, axes);
  const Integer sum = lifted_minor(da, db, dc) + lifted_minor(db, dc, da) + lifted_minor(dc, da, db);
  return counted(sum.sign(), Tier::big);
}

Sign Constructions::in_sphere(PointId a, PointId b, PointId c, PointId d, PointId e) const {
  if (has_exact_doubles(a) && has_exact_doubles(b) && has_exact_doubles(c) && has_exact_doubles(d) &&
      has_exact_doubles(e)) {
    Tier tier{};
    const Sign sign = quoin::in_sphere(rounded(a), rounded(b), rounded(c), rounded(d), rounded(e), tier);
    return counted(sign, tier);
  }
  const int sign = filter::in_sphere_rounded(rounded(a), rounded(b), rounded(c), rounded(d), rounded(e));
  if (is_decided(sign)) return static_cast<Sign>(sign);
  const Homogeneous from = homogeneous(e);
  const Difference<3> ea(homogeneous(a), from, all_axes);
  const Difference<3> eb(homogeneous(b), from, all_axes);
  const Difference<3> ec(homogeneous(c), from, all_axes);
  const Difference<3> ed(homogeneous(d), from, all_axes);
  const Integer positive = lifted_minor(ea, eb, ec, ed) + lifted_minor(ec, ea, eb, ed);
  const Integer negative = lifted_minor(eb, ea, ec, ed) + lifted_minor(ed, ea, eb, ec);
  return counted((positive - negative).sign(), Tier::big);
}

Sign Constructions::compare_lexicographically(PointId p, PointId q) const {
  if (p == q) return Sign::zero;
  for (const unsigned axis : all_axes) {
    const Sign sign = compare(p, q, axis);
    if (sign != Sign::zero) return sign;
  }
  return Sign::zero;
}

Sign Constructions::compare_along(LineId line, PointId p, PointId q) const {
  const int sign = filter::compare_along_rounded(lines_[line.index()], rounded(p), rounded(q));
  if (is_decided(sign)) return static_cast<Sign>(sign);
  const Difference<3> difference(homogeneous(p), homogeneous(q), all_axes);
  return counted(detail::dot<Integer>(direction(line), difference.vector).sign(), Tier::big);
}

}  // namespace quoin
