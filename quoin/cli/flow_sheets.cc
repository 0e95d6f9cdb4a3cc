// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_sheets.h"

#include <cmath>
#include <span>

namespace quoin::cli {

namespace {

double distance(const Interval& square) {
  return std::sqrt(square.lower() + (square.upper() - square.lower()) / 2);
}

constexpr std::uint32_t none = 0xFFFFFFFF;

}  // namespace

SheetPolygonMaker::SheetPolygonMaker(const FlowCells& flow, SheetParts parts)
    : parts_(parts), sheets_(flow, parts), values_(flow.triangulation()), unscale_(flow.triangulation().unscale()) {}

void SheetPolygonMaker::add(std::uint32_t cell, unsigned edge, std::uint32_t number, const Context& context) {
  const CellSheet& sheet = sheets_.follow(cell, edge, context);
  const double at = distance(values_.of_edge(cell, edge));
  if (parts_ == SheetParts::all) {
    centres_.clear();
    constructed_.clear();
  }
  constructed_.resize(sheets_.chain().size(), none);
  made_.unbounded += for_each_bounded_piece(sheet, [&](std::span<const SheetCorner> corners) {
    for (const SheetCorner& corner : corners) made_.corners.push_back(place(corner));
    made_.begin.push_back(made_.corners.size());
    made_.number.push_back(number);
    made_.distance.push_back(at);
  });
}

std::uint32_t SheetPolygonMaker::add_point(const Point3& p) {
  made_.points.push_back(p);
  return static_cast<std::uint32_t>(made_.points.size() - 1);
}

/// Sheets pass the same Voronoi vertices.
const Point3& SheetPolygonMaker::centre(std::uint32_t cell) {
  const auto [at, is_new] = rounded_.try_emplace(cell);
  if (is_new) at->second = to_nearest_doubles(values_.centre(cell));
  return at->second;
}

std::uint32_t SheetPolygonMaker::place(const SheetCorner& corner) {
  if (!corner.is_constructed) {
    const auto [at, is_new] = centres_.try_emplace(corner.place, 0);
    if (is_new) at->second = add_point(centre(corner.place));
    return at->second;
  }
  if (constructed_[corner.place] == none) {
    const Point3 p = sheets_.chain().near_point(corner.place, 0x1p-20);
    constructed_[corner.place] = add_point({p.x * unscale_, p.y * unscale_, p.z * unscale_});
  }
  return constructed_[corner.place];
}

SheetPolygons sheet_polygons(const FlowCells& flow, const Context& context) {
  SheetPolygonMaker maker(flow, SheetParts::fresh);
  std::uint32_t number = 0;
  flow.for_each_critical_edge(context,
                              [&](std::uint32_t cell, unsigned edge) { maker.add(cell, edge, number++, context); });
  return maker.take();
}

VtkGrid grid_of_sheets(const SheetPolygons& sheets) {
  VtkGrid grid;
  grid.points = sheets.points;
  for (std::size_t i = 0; i < sheets.count(); ++i) grid.add_cell(VtkCell::polygon, sheets.polygon(i));
  grid.cell_integers = {{"index", std::vector<std::uint32_t>(sheets.count(), 1)}, {"number", sheets.number}};
  grid.cell_doubles = {{"distance", sheets.distance}};
  return grid;
}

Mesh mesh_of_sheets(const SheetPolygons& sheets) {
  Mesh mesh;
  mesh.vertices = sheets.points;
  for (std::size_t i = 0; i < sheets.count(); ++i) mesh.add_face(sheets.polygon(i));
  return mesh;
}

TracedGrid grid_of_regions(const FlowGraph& graph, const Context& context) {
  const FlowRegions found = flow_regions(graph, context);
  // All walls once; where the triangles of each saddle begin.
  std::vector<WallSaddle> walls;
  std::vector<std::uint32_t> place(graph.saddles().size(), 0);
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    const FlowGraph::Saddle& saddle = graph.saddles()[i];
    if (saddle.ends[0] == saddle.ends[1]) continue;
    place[i] = static_cast<std::uint32_t>(walls.size());
    walls.push_back({saddle.facet, true});
  }
  const FlowMesh mesh = flow_mesh(graph.cells(), walls, context);
  std::vector<std::size_t> begin(walls.size() + 1, 0);
  for (const std::uint32_t saddle : mesh.saddle_of) ++begin[saddle + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  TracedGrid traced{.cells = {}, .origins = origins_of(mesh, graph.cells().triangulation())};
  VtkGrid& grid = traced.cells;
  grid.points = mesh.points;
  grid.cell_integers = {{"index", {}}, {"number", {}}, {"walls", {}}, {"beside_infinity", {}}};
  grid.cell_doubles = {{"distance", {}}};
  std::vector<std::uint32_t> faces;
  for (const FlowRegion& region : found.regions) {
    if (region.maximum % 256 == 0) context.poll();
    faces.assign(1, 0);
    for (std::size_t i = 0; i < region.walls.size(); ++i) {
      const std::uint32_t wall = place[region.wall_numbers[i]];
      for (std::size_t t = begin[wall]; t < begin[wall + 1]; ++t) {
        const std::array<std::uint32_t, 3>& corners = mesh.triangles[t];
        // Counterclockwise from outside.
        const unsigned second = region.walls[i].is_inside_first ? 1 : 2;
        faces.insert(faces.end(), {3, corners[0], corners[second], corners[3 - second]});
        ++faces[0];
      }
    }
    grid.add_cell(VtkCell::polyhedron, faces);
    const std::array<std::uint32_t, 4> numbers{3, region.maximum, static_cast<std::uint32_t>(region.walls.size()),
                                               region.is_beside_infinity ? 1U : 0U};
    for (std::size_t i = 0; i < numbers.size(); ++i) grid.cell_integers[i].second.push_back(numbers[i]);
    grid.cell_doubles[0].second.push_back(distance(graph.maxima()[region.maximum].square));
  }
  return traced;
}

}  // namespace quoin::cli
