// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_polygon_set.h"

#include "quoin/arrangement/arrangement_impl.h"
#include "quoin/arrangement/sets/overlay_impl.h"
#include "quoin/arrangement/sets/polygon_rings_impl.h"
#include "quoin/arrangement/sets/polygon_set_combine_impl.h"
#include "quoin/arrangement/sets/ring_problem_impl.h"

namespace quoin {

template class PolygonSet<CircularFamily>;
template class Overlay<CircularFamily>;
template Superposition<CircularFamily> superpose(std::span<const CircularArrangement* const>, const Context&);
template Overlay<CircularFamily> overlay(std::span<const CircularArrangement* const>, const Context&);
template void visit_cells(const Overlay<CircularFamily>&, OverlayVisitor<CircularFamily>&);
template PolygonSet<CircularFamily> combine(std::span<const PolygonSet<CircularFamily>* const>, SetOperation,
                                            Regularity, const Context&);
template PolygonSet<CircularFamily> combine_rings(CircularFamily, const PieceList<CircularFamily>&,
                                                  std::span<const std::uint32_t>, std::uint32_t, FillRule, SetOperation,
                                                  const Context&);
template PolygonSet<CircularFamily> combine_regions(const Arrangement<CircularFamily>&, const RegionGroups&,
                                                    SetOperation);
template std::optional<RingProblem> find_ring_problem(const Arrangement<CircularFamily>&,
                                                      std::span<const std::uint32_t>, const std::vector<bool>&);
template std::vector<PolygonWithHoles> polygons_of(const PolygonSet<CircularFamily>&);

}  // namespace quoin
