// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/order.h"

#include <array>
#include <cmath>

#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/predicate_filters.h"
#include "quoin/kernel/sum_of_products.h"

namespace quoin {

using detail::Factors;

Sign compare_along(const Vector2& d, const Point2& p, const Point2& q, Tier& tier) {
  tier = Tier::filter;
  const double x = d.x * (p.x - q.x);
  const double y = d.y * (p.y - q.y);
  const int sign = filter::sum_of_products(x + y, std::fabs(x) + std::fabs(y));
  if (sign != 0) return static_cast<Sign>(sign);
  const std::array<Factors, 4> products{{{d.x, p.x}, {-d.x, q.x}, {d.y, p.y}, {-d.y, q.y}}};
  return detail::exact_sign_of_sum(products, tier);
}

Sign compare_along(const Vector2& d, const Point2& p, const Point2& q) {
  Tier ignored;
  return compare_along(d, p, q, ignored);
}

Sign compare_along(const Vector3& d, const Point3& p, const Point3& q, Tier& tier) {
  tier = Tier::filter;
  const double x = d.x * (p.x - q.x);
  const double y = d.y * (p.y - q.y);
  const double z = d.z * (p.z - q.z);
  const int sign = filter::sum_of_products(x + y + z, std::fabs(x) + std::fabs(y) + std::fabs(z));
  if (sign != 0) return static_cast<Sign>(sign);
  const std::array<Factors, 6> products{{{d.x, p.x}, {-d.x, q.x}, {d.y, p.y}, {-d.y, q.y}, {d.z, p.z}, {-d.z, q.z}}};
  return detail::exact_sign_of_sum(products, tier);
}

Sign compare_along(const Vector3& d, const Point3& p, const Point3& q) {
  Tier ignored;
  return compare_along(d, p, q, ignored);
}

Sign compare_along_line(const Point3& a, const Point3& b, const Point3& p, const Point3& q, Tier& tier) {
  tier = Tier::filter;
  const double x = (b.x - a.x) * (p.x - q.x);
  const double y = (b.y - a.y) * (p.y - q.y);
  const double z = (b.z - a.z) * (p.z - q.z);
  const int sign = filter::sum_of_products(x + y + z, std::fabs(x) + std::fabs(y) + std::fabs(z));
  if (sign != 0) return static_cast<Sign>(sign);
  const std::array<double, 12> values{a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z, q.x, q.y, q.z};
  return detail::decide_on_grid(values, tier, [&]<class N>(const detail::CallReader<N>& difference) {
    const std::array<typename N::Linear, 3> d{difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)};
    const std::array<typename N::Linear, 3> e{difference(p.x, q.x), difference(p.y, q.y), difference(p.z, q.z)};
    return detail::dot<typename N::Quadratic>(d, e).sign();
  });
}

Sign compare_along_line(const Point3& a, const Point3& b, const Point3& p, const Point3& q) {
  Tier ignored;
  return compare_along_line(a, b, p, q, ignored);
}

}  // namespace quoin
