// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/exact_flow.h"

#include <array>
#include <utility>

#include "quoin/cli/flow_outputs.h"
#include "quoin/cli/flow_sheets.h"
#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_sheets.h"

namespace quoin::cli {

ExactFlow::ExactFlow(const FlowCells& flow, const Context& context)
    : flow_(flow), context_(context), values_(flow.triangulation()) {}

ExactCells ExactFlow::take(const PointFile& file) {
  cells_.point_data.integers = {{"input", origins_.given()}};
  if (!is_away_) add_data(cells_.point_data, data_of(file, origins_));
  cells_.cell_data.integers = {{"index", std::move(indices_)}, {"number", std::move(numbers_)}};
  cells_.cell_data.numbers.emplace_back("square_distance", std::move(squares_));
  return std::move(cells_);
}

void ExactFlow::add(std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number,
                    const std::optional<Rational>& square, ExactCellKind kind) {
  if (cells_.cell_count() % 256 == 0) context_.poll();
  cells_.add_cell(kind, corners);
  indices_.push_back(index);
  numbers_.push_back(number);
  if (square) {
    squares_.add(*square);
  } else {
    squares_.add_none();
  }
}

template <class AddOrigin>
std::uint32_t ExactFlow::place(const RationalPoint3& p, const AddOrigin& add_origin) {
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
  add_origin();
  const auto number = static_cast<std::uint32_t>(cells_.point_count());
  cells_.add_point(p);
  places_.emplace(key, number);
  return number;
}

std::uint32_t ExactFlow::place_vertex(std::uint32_t vertex) {
  const Delaunay3& points = flow_.triangulation();
  return place(exact_point(points.point(vertex)), [&] { origins_.add_given(points.inputs(vertex)[0]); });
}

std::uint32_t ExactFlow::place_centre(const RationalPoint3& p, std::span<const std::uint32_t> vertices) {
  return place(p, [&] { origins_.add_made(vertices, flow_.triangulation()); });
}

void ExactFlow::add_critical_points(const FlowGraph& graph) {
  const Delaunay3& points = flow_.triangulation();
  for (std::uint32_t v = 0; v < points.vertex_count(); ++v) add(std::array{place_vertex(v)}, 0, points.inputs(v)[0], 0);
  std::uint32_t edges = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const std::uint32_t middle = place_centre(values_.midpoint(cell, edge), ends_of(flow_, cell, edge));
    add(std::array{middle}, 1, edges++, values_.exactly_of_edge(cell, edge));
  });
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    const CellFacet facet = graph.saddles()[i].facet;
    const std::uint32_t centre = place_centre(values_.centre(facet), flow_.vertices_of_polygon(facet));
    add(std::array{centre}, 2, i, graph.exact_square_of_saddle(i));
  }
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i) {
    const std::uint32_t cell = graph.maxima()[i].cell;
    const std::uint32_t centre = place_centre(values_.centre(cell), flow_.vertices_of(cell));
    add(std::array{centre}, 3, i, graph.exact_square_of_maximum(i));
  }
}

std::uint32_t ExactFlow::place_cell(std::uint32_t cell) {
  const auto [at, is_new] = centres_.try_emplace(cell, 0);
  if (is_new) at->second = place_constructed(values_.centre(cell));
  return at->second;
}

void ExactFlow::add_ways() {
  is_away_ = true;
  SaddleArcs arcs(flow_);
  std::uint32_t number = 0;
  flow_.for_each_saddle(context_, [&](CellFacet saddle) {
    arcs.ends(saddle, context_);
    const std::uint32_t middle = place_constructed(values_.centre(saddle));
    for (const std::uint32_t cell : {saddle.cell, flow_.mate(saddle).cell}) {
      if (!flow_.is_ghost(cell)) add(std::array{middle, place_cell(flow_.first_of(cell))}, 2, number, std::nullopt);
    }
    ++number;
  });
  for (std::uint32_t c = 0; c < flow_.cells().size(); ++c) {
    if (c % 64 == 0) context_.poll();
    if (flow_.is_ghost(c)) continue;
    const std::optional<ExactArcLeg> leg = arcs.exact_way_on(c, context_);
    if (!leg) continue;
    std::uint32_t at = place_cell(c);
    for (const RationalPoint3& p : leg->points) {
      const std::uint32_t next = place_constructed(p);
      add(std::array{at, next}, 2, number, std::nullopt);
      at = next;
    }
    if (leg->next) add(std::array{at, place_cell(*leg->next)}, 2, number, std::nullopt);
    ++number;
  }
}

std::size_t ExactFlow::add_sheets() {
  is_away_ = true;
  SaddleSheets sheets(flow_, SheetParts::fresh);
  const Rational unscale(flow_.triangulation().unscale());
  std::vector<std::uint32_t> constructed;
  const auto place = [&](const SheetCorner& corner) {
    if (!corner.is_constructed) return place_cell(corner.place);
    std::uint32_t& number = constructed[corner.place];
    if (number == PointOrigins::none) number = place_constructed(sheets.chain().exact_point(corner.place) * unscale);
    return number;
  };
  std::size_t unbounded = 0;
  std::uint32_t number = 0;
  std::vector<std::uint32_t> polygon;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const CellSheet& sheet = sheets.follow(cell, edge, context_);
    const Rational square = values_.exactly_of_edge(cell, edge);
    constructed.resize(sheets.chain().size(), PointOrigins::none);
    unbounded += for_each_bounded_piece(sheet, [&](std::span<const SheetCorner> corners) {
      context_.poll();
      polygon.clear();
      for (const SheetCorner& corner : corners) polygon.push_back(place(corner));
      add(polygon, 1, number, square, ExactCellKind::polygon);
    });
    ++number;
  });
  return unbounded;
}

void ExactFlow::add_critical_edges() {
  std::uint32_t count = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const auto [a, b] = ends_of(flow_, cell, edge);
    const std::uint32_t first = place_vertex(a);
    add(std::array{first, place_vertex(b)}, 1, count++, values_.exactly_of_edge(cell, edge));
  });
}

void ExactFlow::add_graph(const Rational& most) {
  const Delaunay3& points = flow_.triangulation();
  for (std::uint32_t v = 0; v < points.vertex_count(); ++v) add(std::array{place_vertex(v)}, 0, points.inputs(v)[0], 0);
  std::uint32_t count = 0;
  flow_.for_each_critical_edge(context_, [&](std::uint32_t cell, unsigned edge) {
    const std::uint32_t number = count++;
    const Rational square = values_.exactly_of_edge(cell, edge);
    if (square > most) return;
    const std::array<std::uint32_t, 2> vertices = ends_of(flow_, cell, edge);
    const std::uint32_t middle = place_centre(values_.midpoint(cell, edge), vertices);
    for (const std::uint32_t v : vertices) add(std::array{place_vertex(v), middle}, 1, number, square);
  });
}

void ExactFlow::add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles) {
  const PointOrigins origins = origins_of(mesh, flow_.triangulation());
  std::vector<std::uint32_t> number;
  number.reserve(mesh.exact_points.size());
  for (const RationalPoint3& p : mesh.exact_points) {
    const std::size_t i = number.size();
    if (i % 256 == 0) context_.poll();
    number.push_back(place(p, [&] { origins_.add(origins, i); }));
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
