// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"

#include "quoin/arrangement/arrangement_impl.h"
#include "quoin/arrangement/sets/overlay_impl.h"
#include "quoin/arrangement/sets/polygon_rings_impl.h"
#include "quoin/arrangement/sets/polygon_set_combine_impl.h"
#include "quoin/arrangement/sets/ring_problem_impl.h"

namespace quoin {

template class PolygonSet<GeodesicFamily>;
template class Overlay<GeodesicFamily>;
template Superposition<GeodesicFamily> superpose(std::span<const GeodesicArrangement* const>, const Context&);
template Overlay<GeodesicFamily> overlay(std::span<const GeodesicArrangement* const>, const Context&);
template void visit_cells(const Overlay<GeodesicFamily>&, OverlayVisitor<GeodesicFamily>&);
template PolygonSet<GeodesicFamily> combine(std::span<const PolygonSet<GeodesicFamily>* const>, SetOperation,
                                            Regularity, const Context&);
template PolygonSet<GeodesicFamily> combine_rings(GeodesicFamily, const PieceList<GeodesicFamily>&,
                                                  std::span<const std::uint32_t>, std::uint32_t, FillRule, SetOperation,
                                                  const Context&);
template PolygonSet<GeodesicFamily> combine_regions(const Arrangement<GeodesicFamily>&, const RegionGroups&,
                                                    SetOperation);
template std::optional<RingProblem> find_ring_problem(const Arrangement<GeodesicFamily>&,
                                                      std::span<const std::uint32_t>, const std::vector<bool>&);
template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<GeodesicFamily>&);

}  // namespace quoin
