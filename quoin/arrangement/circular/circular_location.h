// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/location/batch_location.h"
#include "quoin/arrangement/location/grid_locator.h"
#include "quoin/arrangement/location/trapezoid_locator.h"
#include "quoin/arrangement/location/vertical_decomposition.h"

/// Point location in arrangements of circles, circular arcs and segments; see location.h.
namespace quoin {

template <>
struct GridTraits<CircularFamily> {
  static CircularPoint point(const Point2& p) { return CircularFamily::query(p); }
  static std::optional<Point2> turning_point(const CircularFamily& family, BranchId branch) {
    if (family.is_line(branch)) return std::nullopt;
    const CircularSupport& circle = family.rounded(CircularFamily::support(branch));
    return Point2{circle.x, CircularFamily::is_upper(branch) ? circle.y + circle.radius : circle.y - circle.radius};
  }
};

extern template class TrapezoidMapBuilder<CircularFamily>;
extern template class TrapezoidLocator<CircularFamily>;
extern template class GridLocator<CircularFamily>;
extern template std::vector<Location> locate_batch(const CircularArrangement&, std::span<const CircularPoint>,
                                                   const Context&);

extern template VerticalDecomposition decompose_vertically(const CircularArrangement&, const DecompositionOptions&,
                                                           const Context&);

}  // namespace quoin
