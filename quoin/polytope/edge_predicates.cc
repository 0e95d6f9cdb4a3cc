// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/edge_predicates.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "quoin/kernel/call_grid.h"

namespace quoin {

namespace {

template <class N>
using Row = std::array<typename N::Linear, 3>;

template <class N>
Row<N> row(const detail::CallReader<N>& difference, const EdgeVector& v) {
  return {difference(v.to.x, v.from.x), difference(v.to.y, v.from.y), difference(v.to.z, v.from.z)};
}

Row<detail::RationalCallNumbers> rational_row(const EdgeVector& v) {
  RationalPoint3 p = exact_vector(v);
  return {std::move(p.x), std::move(p.y), std::move(p.z)};
}

template <class Formula>
Sign on_grid(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c, const Formula& formula) {
  if (a.exact != nullptr || b.exact != nullptr || c.exact != nullptr) {
    return formula.template operator()<detail::RationalCallNumbers>(rational_row(a), rational_row(b), rational_row(c));
  }
  const std::array<double, 18> values{a.from.x, a.from.y, a.from.z, a.to.x, a.to.y, a.to.z,
                                      b.from.x, b.from.y, b.from.z, b.to.x, b.to.y, b.to.z,
                                      c.from.x, c.from.y, c.from.z, c.to.x, c.to.y, c.to.z};
  Tier ignored;
  return detail::decide_on_grid(values, ignored, [&]<class N>(const detail::CallReader<N>& difference) {
    return formula.template operator()<N>(row(difference, a), row(difference, b), row(difference, c));
  });
}

/// Zero, or rounded with all bits.
bool is_kept(const Rational& exact, double rounded) {
  return rounded == 0 ? exact.sign() == Sign::zero : std::fabs(rounded) > 0x1p-1000 && std::isfinite(rounded);
}

}  // namespace

EdgeVector edge_vector(const RationalPoint3& exact) {
  Point3 to{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
  if (!is_kept(exact.x, to.x) || !is_kept(exact.y, to.y) || !is_kept(exact.z, to.z)) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    to = {unknown, unknown, unknown};
  }
  return {{0, 0, 0}, to, &exact};
}

RationalPoint3 exact_vector(const EdgeVector& v) {
  return v.exact != nullptr ? *v.exact : exact_point(v.to) - exact_point(v.from);
}

Sign exact_determinant(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c) {
  return on_grid(a, b, c, []<class N>(const Row<N>& p, const Row<N>& q, const Row<N>& r) {
    return detail::dot<typename N::Cubic>(detail::cross<typename N::Quadratic>(p, q), r).sign();
  });
}

Sign first_sign_of_double_cross(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c) {
  return on_grid(a, b, c, []<class N>(const Row<N>& p, const Row<N>& q, const Row<N>& r) {
    const auto normal = detail::cross<typename N::Quadratic>(p, q);
    for (const auto& component : detail::cross<typename N::Cubic>(normal, r)) {
      if (component.sign() != Sign::zero) return component.sign();
    }
    return Sign::zero;
  });
}

bool are_parallel(const EdgeVector& a, const EdgeVector& b) {
  const Vector3 p = rounded(a);
  const Vector3 q = rounded(b);
  const auto differs = [](double x, double y, double z, double w) {
    const double left = x * w;
    const double right = y * z;
    return std::fabs(left - right) > 8 * 0x1p-53 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000;
  };
  if (differs(p.x, p.y, q.x, q.y) || differs(p.y, p.z, q.y, q.z) || differs(p.z, p.x, q.z, q.x)) return false;
  return on_grid(a, b, a, []<class N>(const Row<N>& r, const Row<N>& s, const Row<N>& /*same*/) {
           for (const auto& component : detail::cross<typename N::Quadratic>(r, s)) {
             if (component.sign() != Sign::zero) return Sign::positive;
           }
           return Sign::zero;
         }) == Sign::zero;
}

bool point_one_way(const EdgeVector& a, const EdgeVector& b) {
  if (!are_parallel(a, b)) return false;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Sign sign = component_sign(a, axis);
    if (sign != Sign::zero) return component_sign(b, axis) == sign;
  }
  return false;
}

Sign component_sign(const EdgeVector& v, unsigned axis) {
  if (v.exact != nullptr) return (*v.exact)[axis].sign();
  return static_cast<Sign>((v.to[axis] > v.from[axis]) - (v.to[axis] < v.from[axis]));
}

Sign cross_sign(const EdgeVector& a, const EdgeVector& b, unsigned axis) {
  return on_grid(a, b, a, [axis]<class N>(const Row<N>& r, const Row<N>& s, const Row<N>& /*same*/) {
    const unsigned i = (axis + 1) % 3;
    const unsigned j = (axis + 2) % 3;
    return detail::cross<typename N::Quadratic>(r[i], r[j], s[i], s[j]).sign();
  });
}

}  // namespace quoin
