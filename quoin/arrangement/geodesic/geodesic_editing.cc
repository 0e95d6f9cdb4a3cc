// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_editing.h"

#include "quoin/arrangement/edit/cell_geometry_impl.h"
#include "quoin/arrangement/edit/insert_impl.h"
#include "quoin/arrangement/sweep/sweep_queries_impl.h"

namespace quoin {

template class CellGeometry<GeodesicFamily>;
template class ArrangementEditor<GeodesicFamily>;
template void zone(const GeodesicArrangement&, const ZonePiece<GeodesicFamily::Point>&,
                   ZoneVisitor<GeodesicFamily::Point>&, const ZoneLocator<GeodesicFamily::Point>&);
template std::vector<ZoneStep<GeodesicFamily::Point>> zone_steps(const GeodesicArrangement&,
                                                                 const ZonePiece<GeodesicFamily::Point>&,
                                                                 const ZoneLocator<GeodesicFamily::Point>&);
template bool meets_anything(const GeodesicArrangement&, const ZonePiece<GeodesicFamily::Point>&,
                             const ZoneLocator<GeodesicFamily::Point>&);
template CurveId insert(GeodesicArrangement&, const GeodesicFamily&, const PieceList<GeodesicFamily>&, const Context&,
                        const InsertOptions<GeodesicFamily::Point>&);
template CurveId insert_many(GeodesicArrangement&, const GeodesicFamily&, const PieceList<GeodesicFamily>&,
                             const Context&);
template CellMap renumber(GeodesicArrangement&, const Context&);
template void remove_curve(GeodesicArrangement&, CurveId, const RemoveCurveOptions&);
template bool crosses_anything(const GeodesicFamily&, const PieceList<GeodesicFamily>&, const Context&);
template std::vector<Intersection<GeodesicFamily::Point>> report_intersections(const GeodesicFamily&,
                                                                               const PieceList<GeodesicFamily>&,
                                                                               const Context&,
                                                                               const IntersectionOptions&);
template std::vector<SubCurve<GeodesicFamily::Point>> sub_curves(const GeodesicFamily&,
                                                                 const PieceList<GeodesicFamily>&, const Context&);

}  // namespace quoin
