// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_editing.h"

#include "quoin/arrangement/edit/cell_geometry_impl.h"
#include "quoin/arrangement/edit/insert_impl.h"
#include "quoin/arrangement/sweep/sweep_queries_impl.h"

namespace quoin {

template class CellGeometry<CircularFamily>;
template class ArrangementEditor<CircularFamily>;
template void zone(const CircularArrangement&, const ZonePiece<CircularPoint>&, ZoneVisitor<CircularPoint>&,
                   const ZoneLocator<CircularPoint>&);
template std::vector<ZoneStep<CircularPoint>> zone_steps(const CircularArrangement&, const ZonePiece<CircularPoint>&,
                                                         const ZoneLocator<CircularPoint>&);
template bool meets_anything(const CircularArrangement&, const ZonePiece<CircularPoint>&,
                             const ZoneLocator<CircularPoint>&);
template CurveId insert(CircularArrangement&, const CircularFamily&, const PieceList<CircularFamily>&, const Context&,
                        const InsertOptions<CircularPoint>&);
template CurveId insert_many(CircularArrangement&, const CircularFamily&, const PieceList<CircularFamily>&,
                             const Context&);
template CellMap renumber(CircularArrangement&, const Context&);
template void remove_curve(CircularArrangement&, CurveId, const RemoveCurveOptions&);
template bool crosses_anything(const CircularFamily&, const PieceList<CircularFamily>&, const Context&);
template std::vector<Intersection<CircularPoint>> report_intersections(const CircularFamily&,
                                                                       const PieceList<CircularFamily>&, const Context&,
                                                                       const IntersectionOptions&);
template std::vector<SubCurve<CircularPoint>> sub_curves(const CircularFamily&, const PieceList<CircularFamily>&,
                                                         const Context&);

}  // namespace quoin
