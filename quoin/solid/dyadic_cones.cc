// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/dyadic_cones.h"

#include <algorithm>
#include <cmath>

#include "quoin/kernel/exact_arithmetic.h"

namespace quoin {

DyadicCones::DyadicCones(const Brep& boundary, int lo)
    : boundary_(&boundary),
      lo_(lo),
      scale_first_(std::ldexp(1.0, -lo / 2)),
      scale_second_(std::ldexp(1.0, -lo - (-lo / 2))) {}

// The table's class bounds the range of bits of all its points, hence of these from their largest magnitude down.
std::optional<DyadicCones> DyadicCones::of(const Brep& boundary) {
  const Constructions& table = boundary.points;
  if (table.grid_class() != GridClass::bits30 && table.grid_class() != GridClass::bits61) return std::nullopt;
  double largest = 0;
  for (std::size_t i = 0; i < table.explicit_count(); ++i) {
    const Point3& p = table.rounded(PointId{i});
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return DyadicCones(boundary, largest == 0 ? 0 : std::ilogb(largest) + 1 - 61);
}

bool DyadicCones::holds(std::uint32_t face) const {
  const std::size_t explicit_count = boundary_->points.explicit_count();
  for (std::uint32_t l = boundary_->face_first_loop[face]; l < boundary_->face_first_loop[face + 1]; ++l) {
    for (const PointId p : boundary_->loop(l)) {
      if (p.index() >= explicit_count) return false;
    }
  }
  return true;
}

std::array<FixedInt<1>, 3> DyadicCones::scaled(PointId p) const {
  const Point3& point = boundary_->points.rounded(p);
  std::array<FixedInt<1>, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = FixedInt<1>(static_cast<std::int64_t>(point[k] * scale_first_ * scale_second_));
  }
  return result;
}

void DyadicCones::add(std::uint32_t face, Sum& sum) const {
  for (std::uint32_t l = boundary_->face_first_loop[face]; l < boundary_->face_first_loop[face + 1]; ++l) {
    const auto loop = boundary_->loop(l);
    if (loop.size() < 3) continue;
    const std::array<FixedInt<1>, 3> apex = scaled(loop[0]);
    std::array<FixedInt<1>, 3> previous = scaled(loop[1]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      const std::array<FixedInt<1>, 3> here = scaled(loop[i]);
      sum = sum + detail::dot<Sum>(apex, detail::cross<FixedInt<2>>(previous, here));
      previous = here;
    }
  }
}

Rational DyadicCones::value(const Sum& sum) const {
  const Integer units = to_integer(sum);
  const auto shift = static_cast<std::size_t>(std::abs(3 * lo_));
  return lo_ < 0 ? Rational(units, Integer(1) << shift) : Rational(units << shift);
}

}  // namespace quoin
