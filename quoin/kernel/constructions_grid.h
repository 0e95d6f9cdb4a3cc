// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"

namespace quoin::detail {

/// The grid of powers of two that holds some coordinates: all are multiples of 2^lo and of magnitude below 2^hi.
struct Grid {
  int lo = 0;
  int hi = 0;
  double largest = 0;  ///< magnitude of a coordinate
  GridClass grid_class = GridClass::bits30;
};

/// The grid of the points, in which -0 is replaced by +0. O(n).
/// @throws InputError  names the first point that is not finite
Grid grid_of(std::vector<Point3>& points);

/// The grid of sums of two doubles, of which the second are `tails`.
Grid grid_of(std::vector<Point3>& points, const std::vector<Point3>& tails);

}  // namespace quoin::detail
