// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/sets/overlay.h"
#include "quoin/arrangement/sets/polygon_set.h"

namespace quoin {

extern template class PolygonSet<CircularFamily>;
extern template class Overlay<CircularFamily>;
extern template Superposition<CircularFamily> superpose(std::span<const CircularArrangement* const>, const Context&);
extern template Overlay<CircularFamily> overlay(std::span<const CircularArrangement* const>, const Context&);
extern template void visit_cells(const Overlay<CircularFamily>&, OverlayVisitor<CircularFamily>&);
extern template PolygonSet<CircularFamily> combine(std::span<const PolygonSet<CircularFamily>* const>, SetOperation,
                                                   Regularity, const Context&);
extern template PolygonSet<CircularFamily> combine_rings(CircularFamily, const PieceList<CircularFamily>&,
                                                         std::span<const std::uint32_t>, std::uint32_t, FillRule,
                                                         SetOperation, const Context&);
extern template PolygonSet<CircularFamily> combine_regions(const Arrangement<CircularFamily>&, const RegionGroups&,
                                                           SetOperation);
extern template std::optional<RingProblem> find_ring_problem(const Arrangement<CircularFamily>&,
                                                             std::span<const std::uint32_t>, const std::vector<bool>&);
extern template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<CircularFamily>&);

using CircularPolygonSet = PolygonSet<CircularFamily>;

}  // namespace quoin
