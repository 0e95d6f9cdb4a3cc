// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_survey.h"

#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_sheets.h"
#include "quoin/flow/saddle_surfaces.h"

namespace quoin {

namespace {

void add_if(bool is_so, std::uint32_t number, ManifoldList& list) {
  if (is_so) list.push_back(number);
}

CrossingStatistics statistics(const CellCrosser& crosser) {
  const CrossingChain& chain = crosser.chain();
  return {crosser.filters(),   crosser.undecided_count(), chain.most_depth(),
          chain.exact_count(), chain.most_bits(),         chain.exact_bytes()};
}

}  // namespace

StableSurvey survey_stable(const FlowCells& flow, const Context& context) {
  StableSurvey survey;
  SaddleSurfaces surfaces(flow);
  std::uint32_t number = 0;
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    const SurfacePieces& surface = surfaces.follow(saddle, context);
    survey.triangles += 2 * surface.pieces.size();
    add_if(surface.has_voronoi_vertex, number, survey.with_voronoi_vertex);
    add_if(surface.has_solid_part, number, survey.with_solid_part);
    add_if(surface.has_regular_point, number, survey.with_regular_point);
    ++number;
    for (const SurfacePiece& piece : surface.pieces) {
      if (piece.is_side) survey.depths.add(piece.depth);
    }
  });
  survey.crossings = statistics(surfaces.crosser());
  return survey;
}

UnstableSurvey survey_unstable(const FlowCells& flow, const Context& context) {
  UnstableSurvey survey;
  SaddleArcs arcs(flow);
  std::uint32_t number = 0;
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    for (const SaddleEnd& end : arcs.ends(saddle, context)) {
      survey.segments.add(end.segments);
      survey.to_infinity += end.kind == SaddleEnd::Kind::infinity ? 1 : 0;
      add_if(end.has_passed_regular, number, survey.passed_regular);
      add_if(end.kind == SaddleEnd::Kind::saddle, number, survey.in_saddles);
    }
    ++number;
  });
  survey.cascades = arcs.cascades();
  survey.crossings = statistics(arcs.crosser());
  return survey;
}

SheetSurvey survey_sheets(const FlowCells& flow, const Context& context) {
  SheetSurvey survey;
  SaddleSheets sheets(flow);
  std::uint32_t number = 0;
  flow.for_each_critical_edge(context, [&](std::uint32_t cell, unsigned edge) {
    const CellSheet& sheet = sheets.follow(cell, edge, context);
    survey.pieces += sheet.pieces.size();
    survey.parts.add(sheet.parts);
    survey.saddles.add(sheet.saddles.size());
    survey.vertices.add(sheet.cells.size());
    survey.to_infinity += sheet.is_infinite ? 1 : 0;
    add_if(sheet.has_regular_point, number, survey.with_regular_point);
    add_if(sheet.has_stationary_end, number, survey.with_stationary_end);
    ++number;
  });
  survey.crossings = statistics(sheets.crosser());
  return survey;
}

}  // namespace quoin
