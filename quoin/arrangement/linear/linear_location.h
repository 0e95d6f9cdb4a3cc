// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/arrangement/location/batch_location.h"
#include "quoin/arrangement/location/grid_locator.h"
#include "quoin/arrangement/location/trapezoid_locator.h"
#include "quoin/arrangement/location/vertical_decomposition.h"

/// Point location in arrangements of segments, rays and lines; see location.h.
namespace quoin {

template <>
struct GridTraits<LinearFamily> {
  static LinearPoint point(const Point2& p) { return LinearFamily::point(p); }
  static std::optional<Point2> turning_point(const LinearFamily&, BranchId) { return std::nullopt; }
};

extern template class TrapezoidMapBuilder<LinearFamily>;
extern template class TrapezoidLocator<LinearFamily>;
extern template class GridLocator<LinearFamily>;
extern template std::vector<Location> locate_batch(const LinearArrangement&, std::span<const LinearPoint>,
                                                   const Context&);

extern template VerticalDecomposition decompose_vertically(const LinearArrangement&, const DecompositionOptions&,
                                                           const Context&);

}  // namespace quoin
