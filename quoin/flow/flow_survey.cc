// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_survey.h"

#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_surfaces.h"

namespace quoin {

namespace {

CrossingStatistics statistics(const CellCrosser& crosser) {
  return {crosser.comparison_count(), crosser.undecided_count(), crosser.chain().exact_count(),
          crosser.chain().most_bits()};
}

}  // namespace

StableSurvey survey_stable(const FlowCells& flow, const Context& context) {
  StableSurvey survey;
  SaddleSurfaces surfaces(flow);
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    const SurfacePieces& surface = surfaces.follow(saddle, context);
    survey.triangles += 2 * surface.pieces.size();
    survey.with_voronoi_vertex += surface.has_voronoi_vertex ? 1 : 0;
    survey.with_solid_part += surface.has_solid_part ? 1 : 0;
    survey.with_regular_point += surface.has_regular_point ? 1 : 0;
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
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    for (const SaddleEnd& end : arcs.ends(saddle, context)) {
      survey.segments.add(end.segments);
      survey.to_infinity += end.kind == SaddleEnd::Kind::infinity ? 1 : 0;
      survey.passed_regular += end.has_passed_regular ? 1 : 0;
      survey.in_saddles += end.kind == SaddleEnd::Kind::saddle ? 1 : 0;
    }
  });
  survey.cascades = arcs.cascades();
  survey.crossings = statistics(arcs.crosser());
  return survey;
}

}  // namespace quoin
