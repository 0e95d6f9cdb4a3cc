// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/edit/arrangement_editor.h"
#include "quoin/arrangement/edit/insert.h"
#include "quoin/arrangement/edit/zone.h"
#include "quoin/arrangement/sweep/sweep_queries.h"

/// Editing of arrangements of arcs of circles and segments.
namespace quoin {

extern template class CellGeometry<CircularFamily>;
extern template class ArrangementEditor<CircularFamily>;
extern template void zone(const CircularArrangement&, const ZonePiece<CircularPoint>&, ZoneVisitor<CircularPoint>&,
                          const ZoneLocator<CircularPoint>&);
extern template std::vector<ZoneStep<CircularPoint>> zone_steps(const CircularArrangement&,
                                                                const ZonePiece<CircularPoint>&,
                                                                const ZoneLocator<CircularPoint>&);
extern template bool meets_anything(const CircularArrangement&, const ZonePiece<CircularPoint>&,
                                    const ZoneLocator<CircularPoint>&);
extern template CurveId insert(CircularArrangement&, const CircularFamily&, const PieceList<CircularFamily>&,
                               const Context&, const InsertOptions<CircularPoint>&);
extern template CurveId insert_many(CircularArrangement&, const CircularFamily&, const PieceList<CircularFamily>&,
                                    const Context&);
extern template CellMap renumber(CircularArrangement&, const Context&);
extern template void remove_curve(CircularArrangement&, CurveId, const RemoveCurveOptions&);
extern template bool crosses_anything(const CircularFamily&, const PieceList<CircularFamily>&, const Context&);
extern template std::vector<Intersection<CircularPoint>> report_intersections(const CircularFamily&,
                                                                              const PieceList<CircularFamily>&,
                                                                              const Context&,
                                                                              const IntersectionOptions&);
extern template std::vector<SubCurve<CircularPoint>> sub_curves(const CircularFamily&, const PieceList<CircularFamily>&,
                                                                const Context&);

}  // namespace quoin
