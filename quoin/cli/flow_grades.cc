// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_grades.h"

namespace quoin::cli {

namespace {

std::vector<CriticalEdge> critical_edges(const FlowGraph& graph, const Context& context) {
  std::vector<CriticalEdge> edges;
  graph.cells().for_each_critical_edge(context, [&edges](std::uint32_t cell, unsigned edge) {
    edges.push_back({cell, edge});
  });
  return edges;
}

}  // namespace

FlowGrades::FlowGrades(const FlowGraph& graph, const Context& context)
    : graph_(graph),
      values_(graph.cells().triangulation()),
      spheres_(graph.cells().triangulation()),
      edges_(critical_edges(graph, context)),
      grades_(squares(), context) {
  for (const std::uint32_t i : grades_.order()) {
    if (i < first_saddle()) edges_in_order_.push_back(i);
    if (i >= first_saddle() && i < first_maximum()) saddles_in_order_.push_back(i - first_saddle());
  }
}

SquareList FlowGrades::squares() const {
  return {.count = first_maximum() + static_cast<std::uint32_t>(graph_.maxima().size()),
          .bounds = [this](std::uint32_t i) { return bounds(i); },
          .numbers = {[this](std::uint32_t i) { return spheres_.close_square(face(i)); },
                      [this](std::uint32_t i) { return spheres_.exact_square(face(i)); }}};
}

Interval FlowGrades::bounds(std::uint32_t i) const {
  if (i < first_saddle()) return values_.of_edge(edges_[i].cell, edges_[i].edge);
  if (i < first_maximum()) return graph_.saddles()[i - first_saddle()].square;
  return graph_.maxima()[i - first_maximum()].square;
}

CriticalFace FlowGrades::face(std::uint32_t i) const {
  const FlowCells& flow = graph_.cells();
  if (i < first_saddle()) return CriticalFace::edge(flow, edges_[i].cell, edges_[i].edge);
  if (i < first_maximum()) return CriticalFace::facet(flow, graph_.saddles()[i - first_saddle()].facet);
  return CriticalFace::simplex(flow, graph_.maxima()[i - first_maximum()].cell);
}

}  // namespace quoin::cli
