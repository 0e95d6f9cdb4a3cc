// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/constructions_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "quoin/base/error.h"
#include "quoin/kernel/constructions_filters.h"

namespace quoin::detail {

namespace {

/// Exponent of the lowest set bit of x != 0.
int lowest_bit(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const auto biased = static_cast<int>((bits >> 52) & 0x7FF);
  if (biased == 0) return -1074 + std::countr_zero(fraction);
  return biased - 1075 + std::countr_zero(fraction | (std::uint64_t{1} << 52));
}

double largest_magnitude(std::vector<Point3>& points) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point3& p = points[i];
    p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw InputError("point " + std::to_string(i) + " has a coordinate that is not finite");
    }
    largest = std::max(largest, filter::max_abs(p));
  }
  return largest;
}

}  // namespace

Grid grid_of(std::vector<Point3>& points) {
  return grid_of(points, {});
}

Grid grid_of(std::vector<Point3>& points, const std::vector<Point3>& tails) {
  Grid grid;
  grid.largest = largest_magnitude(points);
  if (grid.largest == 0) return grid;
  grid.hi = std::ilogb(grid.largest) + 1;
  grid.lo = grid.hi;
  const auto lower_to = [&](const Point3& p) {
    for (const double x : {p.x, p.y, p.z}) {
      if (x != 0) grid.lo = std::min(grid.lo, lowest_bit(x));
    }
  };
  for (const Point3& p : points) lower_to(p);
  for (const Point3& p : tails) lower_to(p);
  const int bits = grid.hi - grid.lo;
  grid.grid_class = bits <= 30    ? GridClass::bits30
                    : bits <= 61  ? GridClass::bits61
                    : bits <= 124 ? GridClass::bits124
                                  : GridClass::big;
  return grid;
}

}  // namespace quoin::detail
