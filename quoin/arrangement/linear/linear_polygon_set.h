// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/arrangement/sets/overlay.h"
#include "quoin/arrangement/sets/polygon_set.h"

namespace quoin {

extern template class PolygonSet<LinearFamily>;
extern template class Overlay<LinearFamily>;
extern template Superposition<LinearFamily> superpose(std::span<const LinearArrangement* const>, const Context&);
extern template Overlay<LinearFamily> overlay(std::span<const LinearArrangement* const>, const Context&);
extern template void visit_cells(const Overlay<LinearFamily>&, OverlayVisitor<LinearFamily>&);
extern template PolygonSet<LinearFamily> combine(std::span<const PolygonSet<LinearFamily>* const>, SetOperation,
                                                 Regularity, const Context&);
extern template PolygonSet<LinearFamily> combine_rings(LinearFamily, const PieceList<LinearFamily>&,
                                                       std::span<const std::uint32_t>, std::uint32_t, FillRule,
                                                       SetOperation, const Context&);
extern template PolygonSet<LinearFamily> combine_regions(const Arrangement<LinearFamily>&, const RegionGroups&,
                                                         SetOperation);
extern template std::optional<RingProblem> find_ring_problem(const Arrangement<LinearFamily>&,
                                                             std::span<const std::uint32_t>, const std::vector<bool>&);
extern template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<LinearFamily>&);

using LinearPolygonSet = PolygonSet<LinearFamily>;

/// Exact area of a bounded set. @throws InputError if it is unbounded
Rational area(const LinearPolygonSet& set);

}  // namespace quoin
