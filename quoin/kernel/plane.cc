// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/plane.h"

#include <array>
#include <cmath>

#include "quoin/kernel/predicate_filters.h"
#include "quoin/kernel/sum_of_products.h"

namespace quoin {

Sign side(const Point3& p, const Plane3& plane, Tier& tier) {
  tier = Tier::filter;
  const Vector3& n = plane.normal;
  const double x = n.x * p.x;
  const double y = n.y * p.y;
  const double z = n.z * p.z;
  const int sign = filter::sum_of_products(x + y + z - plane.offset,
                                           std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(plane.offset));
  if (sign != 0) return static_cast<Sign>(sign);
  const std::array<detail::Factors, 4> products{{{n.x, p.x}, {n.y, p.y}, {n.z, p.z}, {-plane.offset, 1}}};
  return detail::exact_sign_of_sum(products, tier);
}

Sign side(const Point3& p, const Plane3& plane) {
  Tier ignored;
  return side(p, plane, ignored);
}

}  // namespace quoin
