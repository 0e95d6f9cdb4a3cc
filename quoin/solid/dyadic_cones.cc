// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/dyadic_cones.h"

#include <algorithm>
#include <cmath>

#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/number/whole_double.h"
#include "quoin/solid/face_loops.h"

namespace quoin {

DyadicCones::DyadicCones(const Brep& boundary, int lo, bool is_wide)
    : boundary_(&boundary),
      lo_(lo),
      is_wide_(is_wide),
      scale_first_(std::ldexp(1.0, -lo / 2)),
      scale_second_(std::ldexp(1.0, -lo - (-lo / 2))) {}

// The table's class bounds the range of bits of all its points, hence of these from their largest magnitude down.
std::optional<DyadicCones> DyadicCones::of(const Brep& boundary) {
  const Constructions& table = boundary.points;
  const bool is_wide = table.grid_class() == GridClass::bits124;
  if (!table.has_explicit_doubles()) return std::nullopt;
  if (!is_wide && table.grid_class() != GridClass::bits30 && table.grid_class() != GridClass::bits61)
    return std::nullopt;
  double largest = 0;
  for (std::size_t i = 0; i < table.explicit_count(); ++i) {
    const Point3& p = table.rounded(PointId{i});
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return DyadicCones(boundary, largest == 0 ? 0 : std::ilogb(largest) + 1 - (is_wide ? 124 : 61), is_wide);
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

void DyadicCones::measure_from(PointId apex) {
  from_ = scaled<2>(boundary_->points.rounded(apex));
}

template <std::size_t Limbs>
std::array<FixedInt<Limbs>, 3> DyadicCones::scaled(const Point3& point) const {
  std::array<FixedInt<Limbs>, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double units = point[k] * scale_first_ * scale_second_;
    if constexpr (Limbs == 1) {
      result[k] = FixedInt<1>(static_cast<std::int64_t>(units));
    } else {
      result[k] = from_whole_double(units);
    }
  }
  return result;
}

template <std::size_t Limbs>
std::array<FixedInt<Limbs>, 3> DyadicCones::corner(PointId p) const {
  std::array<FixedInt<Limbs>, 3> result = scaled<Limbs>(boundary_->points.rounded(p));
  for (std::size_t k = 0; k < 3; ++k) result[k] = result[k] - FixedInt<Limbs>(from_[k]);
  return result;
}

template <std::size_t Limbs, std::size_t SumLimbs>
FixedInt<SumLimbs> DyadicCones::determinants(std::span<const PointId> loop) const {
  FixedInt<SumLimbs> sum;
  const auto apex = corner<Limbs>(loop[0]);
  auto previous = corner<Limbs>(loop[1]);
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const auto here = corner<Limbs>(loop[i]);
    sum = sum + detail::dot<FixedInt<SumLimbs>>(apex, detail::cross<FixedInt<2 * Limbs>>(previous, here));
    previous = here;
  }
  return sum;
}

void DyadicCones::add(std::uint32_t face, Sum& sum) const {
  for_each_ring(*boundary_, face, [&](std::span<const PointId> loop) {
    sum = sum + (is_wide_ ? determinants<2, 7>(loop) : Sum(determinants<1, 4>(loop)));
  });
}

Rational DyadicCones::value(const Sum& sum) const {
  const Integer units = to_integer(sum);
  const auto shift = static_cast<std::size_t>(std::abs(3 * lo_));
  return lo_ < 0 ? Rational(units, Integer(1) << shift) : Rational(units << shift);
}

}  // namespace quoin
