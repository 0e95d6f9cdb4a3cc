// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_location.h"

#include "quoin/arrangement/location/batch_location_impl.h"
#include "quoin/arrangement/location/trapezoid_locator_impl.h"
#include "quoin/arrangement/location/vertical_decomposition_impl.h"
#include "quoin/arrangement/location/walk_locator.h"

namespace quoin {

static_assert(PointLocator<NaiveLocator<GeodesicFamily>>);
static_assert(PointLocator<WalkLocator<GeodesicFamily>>);
static_assert(PointLocator<TrapezoidLocator<GeodesicFamily>>);

template class TrapezoidMapBuilder<GeodesicFamily>;
template class TrapezoidLocator<GeodesicFamily>;
template std::vector<Location> locate_batch(const GeodesicArrangement&, std::span<const GeodesicFamily::Point>,
                                            const Context&);
template VerticalDecomposition decompose_vertically(const GeodesicArrangement&, const DecompositionOptions&,
                                                    const Context&);

}  // namespace quoin
