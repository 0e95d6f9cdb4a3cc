// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/linear/linear_polygon_set.h"

namespace quoin {

/// The double nearest to the area of a bounded set; infinite beyond the largest one.
///
/// Terms are cut off to three doubles each, with a bound of what was cut off; where that leaves the rounding in doubt,
/// the exact area is worked out (`area`), whose numbers grow with the set. O(n) but for that.
/// @throws InputError if it is unbounded
double rounded_area(const LinearPolygonSet& set);

}  // namespace quoin
