// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_location.h"

#include "quoin/arrangement/location/batch_location_impl.h"
#include "quoin/arrangement/location/grid_build_impl.h"
#include "quoin/arrangement/location/trapezoid_locator_impl.h"
#include "quoin/arrangement/location/vertical_decomposition_impl.h"
#include "quoin/arrangement/location/walk_locator.h"

namespace quoin {

static_assert(VerticalFamily<LinearFamily>);
static_assert(RayShooter<NaiveLocator<LinearFamily>>);
static_assert(RayShooter<WalkLocator<LinearFamily>>);
static_assert(PointLocator<GridLocator<LinearFamily>>);
static_assert(RayShooter<TrapezoidLocator<LinearFamily>>);

template class TrapezoidMapBuilder<LinearFamily>;
template class TrapezoidLocator<LinearFamily>;
template class GridLocator<LinearFamily>;
template std::vector<Location> locate_batch(const LinearArrangement&, std::span<const LinearPoint>, const Context&);

template VerticalDecomposition decompose_vertically(const LinearArrangement&, const DecompositionOptions&,
                                                    const Context&);

}  // namespace quoin
