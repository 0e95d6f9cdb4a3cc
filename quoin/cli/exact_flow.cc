// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/exact_flow.h"

#include <array>
#include <utility>

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

std::uint32_t ExactFlow::place(const RationalPoint3& p) {
  const Point3 rounded = to_nearest_doubles(p);
  const std::array<double, 3> key{rounded.x, rounded.y, rounded.z};
  const auto is_there = [&](std::uint32_t i) {
    for (unsigned k = 0; k < 3; ++k) {
      if (cells_.positions.exact(std::size_t{3} * i + k) != p[k]) return false;
    }
    return true;
  };
  const auto [begin, end] = places_.equal_range(key);
  for (auto at = begin; at != end; ++at) {
    if (is_there(at->second)) return at->second;
  }
  const auto number = static_cast<std::uint32_t>(cells_.point_count());
  cells_.add_point(p);
  places_.emplace(key, number);
  return number;
}

void ExactFlow::add_critical_points(const FlowGraph& graph) {
  const auto add_one = [&](const RationalPoint3& p, std::uint32_t index, std::uint32_t number, const Rational& square) {
    add(std::array{place(p)}, index, number, square);
  };
  const Delaunay3& points = flow_.triangulation();
  for (std::uint32_t v = 0; v < points.vertex_count(); ++v)
    add_one(exact_point(points.point(v)), 0, points.inputs(v)[0], 0);
  std::uint32_t edges = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    add_one(values_.midpoint(cell, edge), 1, edges++, values_.exactly_of_edge(cell, edge));
  });
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i)
    add_one(values_.centre(graph.saddles()[i].facet), 2, i, graph.exact_square_of_saddle(i));
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i)
    add_one(values_.centre(graph.maxima()[i].cell), 3, i, graph.exact_square_of_maximum(i));
}

std::array<std::uint32_t, 2> ExactFlow::ends(std::uint32_t cell, unsigned edge) {
  const auto end = [&](unsigned i) {
    return place(exact_point(flow_.triangulation().point(flow_.cells()[cell].vertices[edge_slots[edge][i]])));
  };
  const std::uint32_t first = end(0);
  return {first, end(1)};
}

void ExactFlow::add_critical_edges() {
  std::uint32_t count = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    add(ends(cell, edge), 1, count++, values_.exactly_of_edge(cell, edge));
  });
}

void ExactFlow::add_graph(const Rational& most) {
  const Delaunay3& points = flow_.triangulation();
  for (std::uint32_t v = 0; v < points.vertex_count(); ++v)
    add(std::array{place(exact_point(points.point(v)))}, 0, points.inputs(v)[0], 0);
  std::uint32_t count = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const std::uint32_t number = count++;
    const Rational square = values_.exactly_of_edge(cell, edge);
    if (square > most) return;
    const std::uint32_t middle = place(values_.midpoint(cell, edge));
    for (const std::uint32_t end : ends(cell, edge)) add(std::array{end, middle}, 1, number, square);
  });
}

void ExactFlow::add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles) {
  std::vector<std::uint32_t> number;
  number.reserve(mesh.exact_points.size());
  for (const RationalPoint3& p : mesh.exact_points) {
    if (number.size() % 256 == 0) context_.poll();
    number.push_back(place(p));
  }
  Rational square;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners = mesh.triangles[t];
    for (std::uint32_t& corner : corners) corner = number[corner];
    const std::uint32_t saddle = mesh.saddle_of[t];
    if (t == 0 || saddle != mesh.saddle_of[t - 1]) square = values_.exactly_of_facet(saddles[saddle].facet);
    add(corners, 2, saddle, square);
  }
}

}  // namespace quoin::cli
