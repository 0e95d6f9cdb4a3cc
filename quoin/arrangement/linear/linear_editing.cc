// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/linear/linear_editing.h"

#include "quoin/arrangement/edit/cell_geometry_impl.h"
#include "quoin/arrangement/edit/insert_impl.h"
#include "quoin/arrangement/sweep/sweep_queries_impl.h"

namespace quoin {

template class CellGeometry<LinearFamily>;
template class ArrangementEditor<LinearFamily>;
template void zone(const LinearArrangement&, const ZonePiece<LinearPoint>&, ZoneVisitor<LinearPoint>&,
                   const ZoneLocator<LinearPoint>&);
template std::vector<ZoneStep<LinearPoint>> zone_steps(const LinearArrangement&, const ZonePiece<LinearPoint>&,
                                                       const ZoneLocator<LinearPoint>&);
template bool meets_anything(const LinearArrangement&, const ZonePiece<LinearPoint>&, const ZoneLocator<LinearPoint>&);
template CurveId insert(LinearArrangement&, const LinearFamily&, const PieceList<LinearFamily>&, const Context&,
                        const InsertOptions<LinearPoint>&);
template CurveId insert_many(LinearArrangement&, const LinearFamily&, const PieceList<LinearFamily>&, const Context&);
template CellMap renumber(LinearArrangement&, const Context&);
template void remove_curve(LinearArrangement&, CurveId, const RemoveCurveOptions&);
template bool crosses_anything(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);
template std::vector<Intersection<LinearPoint>> report_intersections(const LinearFamily&,
                                                                     const PieceList<LinearFamily>&, const Context&,
                                                                     const IntersectionOptions&);
template std::vector<SubCurve<LinearPoint>> sub_curves(const LinearFamily&, const PieceList<LinearFamily>&,
                                                       const Context&);

}  // namespace quoin
