// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/region_direction.h"

#include "quoin/number/rational.h"

namespace quoin {

namespace {

double scaled(const SphereDirection& d, std::size_t axis) {
  if (d.bits() <= 53 && d.is_small()) {
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(d.small(axis))), -static_cast<int>(d.bits()));
  }
  return Rational(d.integer(axis), Integer(1) << d.bits()).to_double();
}

}  // namespace

RegionDirection::RegionDirection(const SphereDirection& direction)
    : exact_(direction.primitive()), rounded_{scaled(exact_, 0), scaled(exact_, 1), scaled(exact_, 2)} {}

std::strong_ordering compare(const SphereDirection& a, const SphereDirection& b) {
  const bool are_small = a.is_small() && b.is_small();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!are_small) {
      const std::strong_ordering order = a.integer(axis) <=> b.integer(axis);
      if (order != 0) return order;
    } else if (a.small(axis) != b.small(axis)) {
      return a.small(axis) < b.small(axis) ? std::strong_ordering::less : std::strong_ordering::greater;
    }
  }
  return std::strong_ordering::equal;
}

}  // namespace quoin
