// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_regions.h"

#include <algorithm>

#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_surfaces.h"

namespace quoin {

namespace {

void count_vertices(const FlowGraph& graph, FlowRegions& found, const Context& context) {
  const FlowCells& flow = graph.cells();
  const std::span<const FlowGraph::Maximum> maxima = graph.maxima();
  SaddleArcs arcs(flow);
  for (std::uint32_t c = 0; c < flow.cells().size(); ++c) {
    if (c % 256 == 0) context.poll();
    if (flow.is_ghost(c) || flow.first_of(c) != c) continue;
    const SaddleEnd end = arcs.end(c, context);
    found.vertices_to_infinity += end.kind == SaddleEnd::Kind::infinity ? 1 : 0;
    found.vertices_to_saddles += end.kind == SaddleEnd::Kind::saddle ? 1 : 0;
    if (end.kind != SaddleEnd::Kind::maximum) continue;
    const auto at = std::lower_bound(maxima.begin(), maxima.end(), end.cell,
                                     [](const FlowGraph::Maximum& m, std::uint32_t cell) { return m.cell < cell; });
    ++found.regions[static_cast<std::size_t>(at - maxima.begin())].vertices;
  }
}

}  // namespace

FlowRegions flow_regions(const FlowGraph& graph, const Context& context) {
  FlowRegions found;
  found.regions.resize(graph.maxima().size());
  for (std::uint32_t i = 0; i < found.regions.size(); ++i) found.regions[i].maximum = i;
  count_vertices(graph, found, context);
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    const FlowGraph::Saddle& saddle = graph.saddles()[i];
    if (saddle.ends[0] == saddle.ends[1]) {
      if (saddle.ends[0] != graph.infinity()) ++found.regions[saddle.ends[0]].inner_saddles;
      continue;
    }
    for (unsigned side = 0; side < 2; ++side) {
      if (saddle.ends[side] == graph.infinity()) continue;
      FlowRegion& region = found.regions[saddle.ends[side]];
      region.walls.push_back({saddle.facet, side == 0});
      region.wall_numbers.push_back(i);
      region.is_beside_infinity |= saddle.ends[1 - side] == graph.infinity();
    }
  }
  return found;
}

RegionSurvey survey_regions(const FlowGraph& graph, const FlowRegions& regions, const Context& context) {
  RegionSurvey survey;
  SaddleSurfaces surfaces(graph.cells());
  std::vector<bool> is_ordinary(graph.saddles().size(), true);
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    if (i % 64 == 0) context.poll();
    const FlowGraph::Saddle& saddle = graph.saddles()[i];
    if (saddle.ends[0] == saddle.ends[1]) continue;
    const SurfacePieces& surface = surfaces.follow(saddle.facet, context);
    survey.triangles += 2 * surface.pieces.size();
    is_ordinary[i] = surface.is_ordinary();
  }
  for (const FlowRegion& region : regions.regions) {
    survey.vertices.add(region.vertices);
    survey.walls.add(region.walls.size());
    survey.inner_saddles += region.inner_saddles;
    survey.beside_infinity += region.is_beside_infinity ? 1 : 0;
    const bool is_plain = std::all_of(region.wall_numbers.begin(), region.wall_numbers.end(),
                                      [&](std::uint32_t saddle) { return is_ordinary[saddle]; });
    if (!is_plain) survey.not_ordinary.push_back(region.maximum);
  }
  return survey;
}

}  // namespace quoin
