// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_location.h"

#include "quoin/arrangement/location/batch_location_impl.h"
#include "quoin/arrangement/location/grid_build_impl.h"
#include "quoin/arrangement/location/trapezoid_locator_impl.h"
#include "quoin/arrangement/location/vertical_decomposition_impl.h"
#include "quoin/arrangement/location/walk_locator.h"

namespace quoin {

static_assert(VerticalFamily<CircularFamily>);
static_assert(RayShooter<NaiveLocator<CircularFamily>>);
static_assert(RayShooter<WalkLocator<CircularFamily>>);
static_assert(PointLocator<GridLocator<CircularFamily>>);
static_assert(RayShooter<TrapezoidLocator<CircularFamily>>);

template class TrapezoidMapBuilder<CircularFamily>;
template class TrapezoidLocator<CircularFamily>;
template class GridLocator<CircularFamily>;
template std::vector<Location> locate_batch(const CircularArrangement&, std::span<const CircularPoint>, const Context&);

template VerticalDecomposition decompose_vertically(const CircularArrangement&, const DecompositionOptions&,
                                                    const Context&);

}  // namespace quoin
