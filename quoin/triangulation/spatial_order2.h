// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// The distinct points of a list along a curve that stays local, and where each is in the list.
struct SpatialOrder2 {
  UnsetVector<Point2> points;              ///< distinct, zeros are +0
  UnsetVector<std::uint32_t> inputs;       ///< indices into the list, ascending for equal points
  LargeVector<std::uint32_t> input_begin;  ///< per point and one more; empty while all points are distinct

  std::span<const std::uint32_t> inputs_of(std::size_t i) const {
    if (input_begin.empty()) return std::span(inputs).subspan(i, 1);
    return std::span(inputs).subspan(input_begin[i], input_begin[i + 1] - input_begin[i]);
  }
};

/// Sorts along Hilbert's curve on 2^16 x 2^16 cells of the box of the points; cells with many points are sorted by the
/// cells of their own boxes, those with few lexicographically. The order of the distinct points is a function of their
/// set. O(n) with equal keys rare, O(n log n) otherwise, whatever the coordinates; 24 bytes per point beyond the input.
/// Passes on all threads; the result does not depend on them.
/// @throws InputError  names the first point that is not finite
SpatialOrder2 spatial_order(std::span<const Point2> points, const Context& context);

}  // namespace quoin
