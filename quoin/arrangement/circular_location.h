// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/batch_location.h"
#include "quoin/arrangement/circular_arrangement.h"
#include "quoin/arrangement/trapezoid_locator.h"
#include "quoin/arrangement/vertical_decomposition.h"

/// Point location in arrangements of circles, arcs and segments; see location.h.
namespace quoin {

extern template class TrapezoidMapBuilder<CircularFamily>;
extern template class TrapezoidLocator<CircularFamily>;
extern template std::vector<Location> locate_batch(const CircularArrangement&, std::span<const CircularPoint>,
                                                   const Context&);
extern template VerticalDecomposition decompose_vertically(const CircularArrangement&, const DecompositionOptions&,
                                                           const Context&);

}  // namespace quoin
