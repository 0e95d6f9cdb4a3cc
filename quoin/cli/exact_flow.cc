// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/exact_flow.h"

#include <array>
#include <map>

namespace quoin::cli {

ExactFlow::ExactFlow(const FlowCells& flow, const Context& context)
    : flow_(flow), context_(context), values_(flow.triangulation()) {}

ExactCells ExactFlow::take() {
  cells_.cell_data.integers = {{"index", std::move(indices_)}, {"number", std::move(numbers_)}};
  cells_.cell_data.numbers.emplace_back("square_distance", std::move(squares_));
  return std::move(cells_);
}

void ExactFlow::add(std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number,
                    const Rational& square) {
  if (cells_.cell_count() % 256 == 0) context_.poll();
  cells_.add_cell(ExactCellKind::simplex, corners);
  indices_.push_back(index);
  numbers_.push_back(number);
  squares_.add(square);
}

void ExactFlow::add_critical_points(const FlowGraph& graph) {
  const auto add_one = [&](const auto& p, std::uint32_t index, std::uint32_t number, const Rational& square) {
    const std::uint32_t corner = add_point(p);
    add({&corner, 1}, index, number, square);
  };
  const Delaunay3& points = flow_.triangulation();
  for (std::uint32_t v = 0; v < points.vertex_count(); ++v) add_one(points.point(v), 0, points.inputs(v)[0], 0);
  std::uint32_t edges = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    add_one(values_.midpoint(cell, edge), 1, edges++, values_.exactly_of_edge(cell, edge));
  });
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i)
    add_one(values_.centre(graph.saddles()[i].facet), 2, i, graph.exact_square_of_saddle(i));
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i)
    add_one(values_.centre(graph.maxima()[i].cell), 3, i, graph.exact_square_of_maximum(i));
}

void ExactFlow::add_critical_edges(const std::optional<Rational>& most) {
  std::map<std::uint32_t, std::uint32_t> corner_of;
  std::uint32_t count = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const std::uint32_t number = count++;
    const Rational square = values_.exactly_of_edge(cell, edge);
    if (most && square > *most) return;
    std::array<std::uint32_t, 2> corners{};
    for (unsigned i = 0; i < 2; ++i) {
      const std::uint32_t v = flow_.cells()[cell].vertices[edge_slots[edge][i]];
      const auto [at, is_new] = corner_of.try_emplace(v, 0);
      if (is_new) at->second = add_point(flow_.triangulation().point(v));
      corners[i] = at->second;
    }
    add(corners, 1, number, square);
  });
}

void ExactFlow::add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles) {
  const auto first = static_cast<std::uint32_t>(cells_.point_count());
  for (const RationalPoint3& p : mesh.exact_points) cells_.add_point(p);
  Rational square;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners = mesh.triangles[t];
    for (std::uint32_t& corner : corners) corner += first;
    const std::uint32_t saddle = mesh.saddle_of[t];
    if (t == 0 || saddle != mesh.saddle_of[t - 1]) square = values_.exactly_of_facet(saddles[saddle].facet);
    add(corners, 2, saddle, square);
  }
}

}  // namespace quoin::cli
