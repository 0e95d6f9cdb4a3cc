// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_outputs.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "quoin/flow/saddle_arcs.h"

namespace quoin::cli {

namespace {

/// The distance from bounds of its square.
double distance(const Interval& square) {
  return std::sqrt(square.lower() + (square.upper() - square.lower()) / 2);
}

/// The arrays of cells, made when they are first needed.
std::vector<std::uint32_t>& integers(VtkGrid& grid, std::size_t i) {
  if (grid.cell_integers.empty()) grid.cell_integers = {{"index", {}}, {"number", {}}};
  return grid.cell_integers[i].second;
}
std::vector<double>& distances(VtkGrid& grid) {
  if (grid.cell_doubles.empty()) grid.cell_doubles = {{"distance", {}}};
  return grid.cell_doubles[0].second;
}

void add(VtkGrid& grid, VtkCell type, std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number,
         double at) {
  grid.add_cell(type, corners);
  integers(grid, 0).push_back(index);
  integers(grid, 1).push_back(number);
  distances(grid).push_back(at);
}

std::uint32_t add_point(VtkGrid& grid, const Point3& p) {
  grid.points.push_back(p);
  return static_cast<std::uint32_t>(grid.points.size() - 1);
}

}  // namespace

std::array<std::uint32_t, 2> ends_of(const FlowCells& flow, std::uint32_t cell, unsigned edge) {
  const std::array<std::uint32_t, 4>& vertices = flow.cells()[cell].vertices;
  return {vertices[edge_slots[edge][0]], vertices[edge_slots[edge][1]]};
}

std::uint32_t TracedGrid::add_given(const Point3& p, std::uint32_t input) {
  origins.add_given(input);
  return add_point(cells, p);
}

std::uint32_t TracedGrid::add_made(const Point3& p, std::span<const std::uint32_t> vertices,
                                   const Delaunay3& triangulation) {
  origins.add_made(vertices, triangulation);
  return add_point(cells, p);
}

TracedGrid grid_of_critical_points(const FlowGraph& graph, const std::optional<CriticalSeparation>& separation,
                                   const Context& context) {
  TracedGrid grid;
  const FlowCells& flow = graph.cells();
  const Delaunay3& triangulation = flow.triangulation();
  const CriticalValues values(triangulation);
  const auto add_one = [&](std::uint32_t corner, std::uint32_t index, std::uint32_t number, double at) {
    if (corner % 256 == 0) context.poll();
    add(grid.cells, VtkCell::vertex, std::span(&corner, 1), index, number, at);
  };
  for (std::uint32_t v = 0; v < triangulation.vertex_count(); ++v) {
    const std::uint32_t input = triangulation.inputs(v)[0];
    add_one(grid.add_given(triangulation.point(v), input), 0, input, 0);
  }
  std::uint32_t edges = 0;
  flow.for_each_critical_edge(context, [&](std::uint32_t cell, unsigned edge) {
    const Point3 middle = to_nearest_doubles(values.midpoint(cell, edge));
    add_one(grid.add_made(middle, ends_of(flow, cell, edge), triangulation), 1, edges++,
            distance(values.of_edge(cell, edge)));
  });
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    const FlowGraph::Saddle& saddle = graph.saddles()[i];
    const Point3 centre = to_nearest_doubles(values.centre(saddle.facet));
    add_one(grid.add_made(centre, flow.vertices_of_polygon(saddle.facet), triangulation), 2, i,
            distance(saddle.square));
  }
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i) {
    const FlowGraph::Maximum& maximum = graph.maxima()[i];
    const Point3 centre = to_nearest_doubles(values.centre(maximum.cell));
    add_one(grid.add_made(centre, flow.vertices_of(maximum.cell), triangulation), 3, i, distance(maximum.square));
  }
  if (separation) {
    std::vector<std::uint32_t> medial(triangulation.vertex_count(), 0);
    for (const std::vector<bool>* list : {&separation->edges, &separation->saddles, &separation->maxima}) {
      medial.insert(medial.end(), list->begin(), list->end());
    }
    grid.cells.cell_integers.emplace_back("medial", std::move(medial));
  }
  return grid;
}

void add_critical_edges(const FlowCells& flow, const std::optional<Rational>& most, TracedGrid& grid,
                        const Context& context) {
  const Delaunay3& triangulation = flow.triangulation();
  const CriticalValues values(triangulation);
  const Interval around = most ? Interval::around(*most) : Interval::unbounded();
  std::map<std::uint32_t, std::uint32_t> corner_of;
  std::uint32_t count = 0;
  flow.for_each_critical_edge(context, [&](std::uint32_t cell, unsigned edge) {
    const std::uint32_t number = count++;
    const Interval square = values.of_edge(cell, edge);
    const auto exact = [&] { return values.exactly_of_edge(cell, edge); };
    if (most && !is_at_most(square, exact, *most, around)) return;
    std::array<std::uint32_t, 2> corners = ends_of(flow, cell, edge);
    for (std::uint32_t& corner : corners) {
      const auto [at, is_new] = corner_of.try_emplace(corner, 0);
      if (is_new) at->second = grid.add_given(triangulation.point(corner), triangulation.inputs(corner)[0]);
      corner = at->second;
    }
    add(grid.cells, VtkCell::line, corners, 1, number, distance(square));
  });
}

void add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles, const FlowGraph& graph, TracedGrid& grid) {
  const auto first = static_cast<std::uint32_t>(grid.cells.points.size());
  grid.cells.points.insert(grid.cells.points.end(), mesh.points.begin(), mesh.points.end());
  grid.origins.add(origins_of(mesh, graph.cells().triangulation()));
  const CriticalValues values(graph.cells().triangulation());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners = mesh.triangles[t];
    for (std::uint32_t& corner : corners) corner += first;
    const std::uint32_t saddle = mesh.saddle_of[t];
    add(grid.cells, VtkCell::triangle, corners, 2, saddle, distance(values.of_facet(saddles[saddle].facet)));
  }
}

namespace {

/// Lines between points, those of Voronoi vertices shared.
class ArcLines {
 public:
  explicit ArcLines(const FlowCells& flow) : flow_(flow), values_(flow.triangulation()) {
    grid_.cell_integers = {{"number", {}}};
  }

  std::uint32_t add(const Point3& p) { return add_point(grid_, p); }
  std::uint32_t centre(std::uint32_t first) {
    const auto [at, is_new] = centres_.try_emplace(first, 0);
    if (is_new) at->second = add(to_nearest_doubles(values_.centre(first)));
    return at->second;
  }
  void line(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
    grid_.add_cell(VtkCell::line, std::array{from, to});
    grid_.cell_integers[0].second.push_back(number);
  }
  /// The way from a saddle to both sides, up to the first Voronoi vertices.
  void saddle(CellFacet saddle, std::uint32_t number) {
    const std::uint32_t middle = add(to_nearest_doubles(values_.centre(saddle)));
    for (const std::uint32_t cell : {saddle.cell, flow_.mate(saddle).cell}) {
      if (!flow_.is_ghost(cell)) line(middle, centre(flow_.first_of(cell)), number);
    }
  }
  void leg(std::uint32_t first, const ArcLeg& leg, std::uint32_t number) {
    std::uint32_t at = centre(first);
    for (const Point3& p : leg.points) {
      const std::uint32_t next = add(p);
      line(at, next, number);
      at = next;
    }
    if (leg.next) line(at, centre(*leg.next), number);
  }
  VtkGrid take() { return std::move(grid_); }

 private:
  const FlowCells& flow_;
  CriticalValues values_;
  VtkGrid grid_;
  std::unordered_map<std::uint32_t, std::uint32_t> centres_;
};

}  // namespace

VtkGrid grid_of_arcs(const FlowCells& flow, const Context& context) {
  ArcLines lines(flow);
  SaddleArcs arcs(flow);
  std::uint32_t number = 0;
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    arcs.ends(saddle, context);
    lines.saddle(saddle, number++);
  });
  for (std::uint32_t c = 0; c < flow.cells().size(); ++c) {
    if (c % 64 == 0) context.poll();
    if (flow.is_ghost(c)) continue;
    const std::optional<ArcLeg> leg = arcs.way_on(c, context);
    if (leg) lines.leg(c, *leg, number++);
  }
  return lines.take();
}

Mesh mesh_of_surfaces(const FlowMesh& surfaces) {
  Mesh mesh;
  mesh.vertices = surfaces.points;
  for (const std::array<std::uint32_t, 3>& t : surfaces.triangles) mesh.add_face(t);
  return mesh;
}

}  // namespace quoin::cli
