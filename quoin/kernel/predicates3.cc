// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/predicates3.h"

#include <array>

#include "quoin/kernel/call_grid.h"

namespace quoin::detail {

namespace {

template <class N>
using Row = std::array<typename N::Linear, 3>;

template <class N>
Row<N> row(const CallReader<N>& difference, const Point3& p, const Point3& q) {
  return {difference(p.x, q.x), difference(p.y, q.y), difference(p.z, q.z)};
}

template <class N>
typename N::Cubic determinant(const Row<N>& a, const Row<N>& b, const Row<N>& c) {
  return dot<typename N::Cubic>(cross<typename N::Quadratic>(a, b), c);
}

template <class N>
typename N::Quintic lifted_minor(const Row<N>& lifted, const Row<N>& b, const Row<N>& c, const Row<N>& d) {
  return product<typename N::Quintic>(determinant<N>(b, c, d), dot<typename N::Quadratic>(lifted, lifted));
}

}  // namespace

Sign exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d, Tier& tier) {
  const std::array<double, 12> values{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z};
  return decide_on_grid(values, tier, [&]<class N>(const CallReader<N>& difference) {
    return determinant<N>(row(difference, b, a), row(difference, c, a), row(difference, d, a)).sign();
  });
}

Sign orientation_of_any_size(const Point3& a, const Point3& b, const Point3& c, const Point3& d, Tier& tier) {
  const int sign = filter::orientation_by_maxima(a, b, c, d);
  if (sign == 0) return exact_orientation(a, b, c, d, tier);
  tier = Tier::filter;
  return static_cast<Sign>(sign);
}

Sign exact_in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e, Tier& tier) {
  const std::array<double, 15> values{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z};
  return decide_on_grid(values, tier, [&]<class N>(const CallReader<N>& difference) {
    const Row<N> ra = row(difference, a, e);
    const Row<N> rb = row(difference, b, e);
    const Row<N> rc = row(difference, c, e);
    const Row<N> rd = row(difference, d, e);
    const auto positive = lifted_minor<N>(ra, rb, rc, rd) + lifted_minor<N>(rc, ra, rb, rd);
    const auto negative = lifted_minor<N>(rb, ra, rc, rd) + lifted_minor<N>(rd, ra, rb, rc);
    return (positive - negative).sign();
  });
}

}  // namespace quoin::detail
