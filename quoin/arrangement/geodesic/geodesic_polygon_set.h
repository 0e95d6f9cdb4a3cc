// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/arrangement/sets/overlay.h"
#include "quoin/arrangement/sets/polygon_set.h"

namespace quoin {

extern template class PolygonSet<GeodesicFamily>;
extern template class Overlay<GeodesicFamily>;
extern template Superposition<GeodesicFamily> superpose(std::span<const GeodesicArrangement* const>, const Context&);
extern template Overlay<GeodesicFamily> overlay(std::span<const GeodesicArrangement* const>, const Context&);
extern template void visit_cells(const Overlay<GeodesicFamily>&, OverlayVisitor<GeodesicFamily>&);
extern template PolygonSet<GeodesicFamily> combine(std::span<const PolygonSet<GeodesicFamily>* const>, SetOperation,
                                                   Regularity, const Context&);
extern template PolygonSet<GeodesicFamily> combine_rings(GeodesicFamily, const PieceList<GeodesicFamily>&,
                                                         std::span<const std::uint32_t>, std::uint32_t, FillRule,
                                                         SetOperation, const Context&);
extern template PolygonSet<GeodesicFamily> combine_regions(const Arrangement<GeodesicFamily>&, const RegionGroups&,
                                                           SetOperation);
extern template std::optional<RingProblem> find_ring_problem(const Arrangement<GeodesicFamily>&,
                                                             std::span<const std::uint32_t>, const std::vector<bool>&);
extern template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<GeodesicFamily>&);

using GeodesicPolygonSet = PolygonSet<GeodesicFamily>;

}  // namespace quoin
