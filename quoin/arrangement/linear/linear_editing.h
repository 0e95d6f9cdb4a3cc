// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/arrangement_editor.h"
#include "quoin/arrangement/edit/insert.h"
#include "quoin/arrangement/edit/zone.h"
#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/arrangement/sweep/sweep_queries.h"

/// Editing of arrangements of segments, rays and lines.
namespace quoin {

extern template class CellGeometry<LinearFamily>;
extern template class ArrangementEditor<LinearFamily>;
extern template void zone(const LinearArrangement&, const ZonePiece<LinearPoint>&, ZoneVisitor<LinearPoint>&,
                          const ZoneLocator<LinearPoint>&);
extern template std::vector<ZoneStep<LinearPoint>> zone_steps(const LinearArrangement&, const ZonePiece<LinearPoint>&,
                                                              const ZoneLocator<LinearPoint>&);
extern template bool meets_anything(const LinearArrangement&, const ZonePiece<LinearPoint>&,
                                    const ZoneLocator<LinearPoint>&);
extern template CurveId insert(LinearArrangement&, const LinearFamily&, const PieceList<LinearFamily>&, const Context&,
                               const InsertOptions<LinearPoint>&);
extern template CurveId insert_many(LinearArrangement&, const LinearFamily&, const PieceList<LinearFamily>&,
                                    const Context&);
extern template CellMap renumber(LinearArrangement&, const Context&);
extern template void remove_curve(LinearArrangement&, CurveId, const RemoveCurveOptions&);
extern template bool crosses_anything(const LinearFamily&, const PieceList<LinearFamily>&, const Context&);
extern template std::vector<Intersection<LinearPoint>> report_intersections(const LinearFamily&,
                                                                            const PieceList<LinearFamily>&,
                                                                            const Context&, const IntersectionOptions&);
extern template std::vector<SubCurve<LinearPoint>> sub_curves(const LinearFamily&, const PieceList<LinearFamily>&,
                                                              const Context&);

}  // namespace quoin
