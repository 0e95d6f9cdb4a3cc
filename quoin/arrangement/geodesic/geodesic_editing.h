// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/edit/arrangement_editor.h"
#include "quoin/arrangement/edit/insert.h"
#include "quoin/arrangement/edit/zone.h"
#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/arrangement/sweep/sweep_queries.h"

/// Editing of arrangements of geodesic arcs on the sphere.
namespace quoin {

extern template class CellGeometry<GeodesicFamily>;
extern template class ArrangementEditor<GeodesicFamily>;
extern template void zone(const GeodesicArrangement&, const ZonePiece<GeodesicFamily::Point>&,
                          ZoneVisitor<GeodesicFamily::Point>&, const ZoneLocator<GeodesicFamily::Point>&);
extern template std::vector<ZoneStep<GeodesicFamily::Point>> zone_steps(const GeodesicArrangement&,
                                                                        const ZonePiece<GeodesicFamily::Point>&,
                                                                        const ZoneLocator<GeodesicFamily::Point>&);
extern template bool meets_anything(const GeodesicArrangement&, const ZonePiece<GeodesicFamily::Point>&,
                                    const ZoneLocator<GeodesicFamily::Point>&);
extern template CurveId insert(GeodesicArrangement&, const GeodesicFamily&, const PieceList<GeodesicFamily>&,
                               const Context&, const InsertOptions<GeodesicFamily::Point>&);
extern template CurveId insert_many(GeodesicArrangement&, const GeodesicFamily&, const PieceList<GeodesicFamily>&,
                                    const Context&);
extern template CellMap renumber(GeodesicArrangement&, const Context&);
extern template void remove_curve(GeodesicArrangement&, CurveId, const RemoveCurveOptions&);
extern template bool crosses_anything(const GeodesicFamily&, const PieceList<GeodesicFamily>&, const Context&);
extern template std::vector<Intersection<GeodesicFamily::Point>> report_intersections(const GeodesicFamily&,
                                                                                      const PieceList<GeodesicFamily>&,
                                                                                      const Context&,
                                                                                      const IntersectionOptions&);
extern template std::vector<SubCurve<GeodesicFamily::Point>> sub_curves(const GeodesicFamily&,
                                                                        const PieceList<GeodesicFamily>&,
                                                                        const Context&);

}  // namespace quoin
