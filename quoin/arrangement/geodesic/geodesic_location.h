// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/arrangement/location/batch_location.h"
#include "quoin/arrangement/location/trapezoid_locator.h"
#include "quoin/arrangement/location/vertical_decomposition.h"

/// Point location in arrangements of arcs of great circles; see location.h. Points may be given by any of their copies.
namespace quoin {

extern template class TrapezoidMapBuilder<GeodesicFamily>;
extern template class TrapezoidLocator<GeodesicFamily>;
extern template std::vector<Location> locate_batch(const GeodesicArrangement&, std::span<const GeodesicFamily::Point>,
                                                   const Context&);
extern template VerticalDecomposition decompose_vertically(const GeodesicArrangement&, const DecompositionOptions&,
                                                           const Context&);

}  // namespace quoin
