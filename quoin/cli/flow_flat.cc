// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_flat.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "quoin/cli/flat_scene.h"
#include "quoin/cli/flow_of_space.h"
#include "quoin/cli/flow_page.h"
#include "quoin/cli/flow_report.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/point_origins.h"
#include "quoin/flow/critical_values.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

/// Points that are centres of faces, each once, and cells over them.
class FlowOfFlat::Cells {
 public:
  Cells(const FlowComplex& flow, const Delaunay3& triangulation) : flow_(flow), triangulation_(triangulation) {
    for (unsigned d = 0; d < 3; ++d) places_[d].assign(flow.faces().count(d), none);
    grid_.cell_integers = {{"index", {}}, {"number", {}}};
    grid_.cell_doubles = {{"distance", {}}};
  }

  std::uint32_t centre(DeloneFace face) {
    std::uint32_t& place = places_[face.dimension][face.index];
    if (place == none) {
      place = static_cast<std::uint32_t>(grid_.points.size());
      grid_.points.push_back(face.dimension == 0 ? flow_.point(face.index) : to_nearest_doubles(flow_.centre(face)));
      centres_.push_back(face);
    }
    return place;
  }
  std::uint32_t vertex(std::uint32_t v) { return centre({0, v}); }
  void add(VtkCell type, std::initializer_list<std::uint32_t> corners, DeloneFace face, std::uint32_t number) {
    grid_.add_cell(type, std::span(corners.begin(), corners.size()));
    grid_.cell_integers[0].second.push_back(face.dimension);
    grid_.cell_integers[1].second.push_back(number);
    Interval square = square_radius_bounds(flow_, face);
    // Of thin triangles bounds say little.
    const bool is_near = square.upper() - square.lower() <= 1e-12 * square.lower();
    if (!is_near) square = Interval::around(flow_.square_radius(face));
    grid_.cell_doubles[0].second.push_back(std::sqrt(square.lower() + (square.upper() - square.lower()) / 2));
    faces_.push_back(face);
  }

  const VtkGrid& grid() const { return grid_; }

  PointOrigins origins() const {
    const DeloneFaces& faces = flow_.faces();
    PointOrigins origins;
    for (const DeloneFace face : centres_) {
      if (face.dimension == 0) {
        origins.add_given(triangulation_.inputs(face.index)[0]);
      } else if (face.dimension == 1) {
        origins.add_made(faces.edge(face.index), triangulation_);
      } else {
        origins.add_made(faces.polygon(face.index), triangulation_);
      }
    }
    return origins;
  }
  VtkGrid traced(const PointFile& file) const {
    VtkGrid grid = grid_;
    const PointOrigins from = origins();
    grid.point_integers.emplace_back("input", from.given());
    add_data(grid, data_of(file, from));
    return grid;
  }

  /// The same with exact coordinates and squared distances.
  ExactCells exact(const PointFile& file, const Context& context) const {
    ExactCells cells;
    const PointOrigins from = origins();
    cells.point_data.integers = {{"input", from.given()}};
    add_data(cells.point_data, data_of(file, from));
    for (const DeloneFace face : centres_) {
      if (cells.point_count() % 64 == 0) context.poll();
      cells.add_point(face.dimension == 0 ? exact_point(flow_.point(face.index)) : flow_.centre(face));
    }
    ExactNumbers squares;
    for (std::size_t c = 0; c < faces_.size(); ++c) {
      if (c % 64 == 0) context.poll();
      const std::size_t begin = grid_.cell_begin[c];
      const std::size_t end = grid_.cell_begin[c + 1];
      cells.add_cell(ExactCellKind::simplex, std::span(grid_.cells).subspan(begin, end - begin));
      squares.add(faces_[c].dimension == 0 ? Rational(0) : flow_.square_radius(faces_[c]));
    }
    cells.cell_data.integers.assign(grid_.cell_integers.begin(), grid_.cell_integers.end());
    cells.cell_data.numbers.emplace_back("square_distance", std::move(squares));
    return cells;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  const FlowComplex& flow_;
  const Delaunay3& triangulation_;
  VtkGrid grid_;
  std::vector<DeloneFace> centres_;  ///< of points
  std::vector<DeloneFace> faces_;    ///< of cells
  std::array<std::vector<std::uint32_t>, 3> places_;
};

FlowOfFlat::FlowOfFlat(const Delaunay3& triangulation, const Options& options, const Context& context)
    : triangulation_(triangulation),
      options_(options),
      context_(context),
      complex_(triangulation, context),
      flow_(complex_) {}

void FlowOfFlat::report(Json& report, std::vector<std::string>& warnings) {
  report["critical"] = complex_.counts();
  report["euler_characteristic"] = alternating_sum(complex_.counts());
  report["stationary_regular"] = complex_.faces_of_kind(FlowKind::regular).size();
  edges_ = critical_faces(complex_, 1);
  polygons_ = critical_faces(complex_, 2);
  if (options_.stable == 1) report["stable"] = report_of_edges(edges_.size(), options_.json);
  if (options_.stable == 2) {
    const StableSurvey survey = survey_flat_stable(complex_, context_);
    report["stable"] = report_of(survey, options_.json);
    histograms_ = histograms_of(survey);
  }
  if (options_.stable == 3) report["stable"] = report_of(FlowRegions{}, RegionSurvey{}, options_.json);
  if (options_.unstable > 0) report["unstable"] = unstable();
  if (options_.shape) report["shape"] = shape();
  if (options_.simplify) {
    Json& simplified = report["simplified"];
    add_number(simplified, "within", *options_.simplify);
    for (const char* name : {"maxima", "maxima_joined_to_infinity", "wall_saddles"}) simplified[name] = 0;
  }
  if (options_.reconstruct) {
    Json& solid = report["solid"];
    add_number(solid, "ratio", options_.ratio.value_or(default_ratio));
    for (const char* name : {"maxima_inside", "wall_saddles", "triangles", "surfaces_not_ordinary"}) solid[name] = 0;
  }
  if (options_.separate) {
    warnings.push_back("the points are in one plane: they sample no surface, and critical points are not separated");
  }
  if (options_.stable == 3 || options_.simplify || options_.reconstruct) {
    polygons_.clear();
    warnings.push_back("the points are in one plane: no maximum is in space, and nothing is enclosed");
  }
}

Json FlowOfFlat::unstable() {
  if (options_.unstable == 2) {
    // Straight across the plane, to both sides.
    UnstableSurvey survey;
    for (std::size_t i = 0; i < 2 * polygons_.size(); ++i) survey.segments.add(1);
    survey.to_infinity = 2 * polygons_.size();
    for (const FlowHistogram& histogram : histograms_of(survey)) histograms_.push_back(histogram);
    return report_of(survey, options_.json);
  }
  const FlatSurvey survey = survey_flat_unstable(flow_, context_);
  for (const FlowHistogram& histogram : histograms_of(survey)) histograms_.push_back(histogram);
  return report_of(survey, options_.json);
}

Json FlowOfFlat::shape() {
  const FlatShape shape = flat_shape(complex_, *options_.shape * *options_.shape, context_);
  edges_ = shape.faces[1];
  polygons_ = shape.faces[2];
  const std::array<std::size_t, 4> counts{shape.faces[0].size(), edges_.size(), polygons_.size(), 0};
  Json report;
  add_number(report, "distance", *options_.shape);
  report["critical"] = counts;
  report["euler_characteristic"] = alternating_sum(counts);
  report["betti_numbers"] = shape.betti_numbers;
  return report;
}

void FlowOfFlat::add_points(Cells& cells) const {
  for (unsigned d = 0; d < 3; ++d) {
    std::uint32_t number = 0;
    for (const std::uint32_t i : critical_faces(complex_, d)) {
      if (number % 256 == 0) context_.poll();
      cells.add(VtkCell::vertex, {cells.centre({d, i})}, {d, i}, d == 0 ? triangulation_.inputs(i)[0] : number);
      ++number;
    }
  }
}

void FlowOfFlat::add_edges(Cells& cells) const {
  std::uint32_t number = 0;
  for (const std::uint32_t e : edges_) {
    if (number % 256 == 0) context_.poll();
    const std::array<std::uint32_t, 2> ends = complex_.faces().edge(e);
    cells.add(VtkCell::line, {cells.vertex(ends[0]), cells.vertex(ends[1])}, {1, e}, number++);
  }
}

void FlowOfFlat::add_triangles(Cells& cells) const {
  std::uint32_t number = 0;
  for (const std::uint32_t f : polygons_) {
    if (number % 64 == 0) context_.poll();
    const StableSurface surface = stable_surface(complex_, f, context_);
    for (const StableTriangle& t : surface.triangles) {
      cells.add(VtkCell::triangle,
                {cells.vertex(t.vertex), cells.centre(surface.points.face(t.from)),
                 cells.centre(surface.points.face(t.towards))},
                {2, f}, number);
    }
    ++number;
  }
}

/// From each midpoint to centres of polygons, then from each of those to the next, once.
void FlowOfFlat::add_ways(Cells& cells) {
  if (options_.unstable == 2) return;
  std::uint32_t number = 0;
  std::vector<bool> is_reached(complex_.faces().count(2), false);
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t polygon) {
    if (polygon == FlatWay::infinity || is_reached[polygon]) return;
    is_reached[polygon] = true;
    open.push_back(polygon);
  };
  for (const std::uint32_t e : critical_faces(complex_, 1)) {
    for (const FlatWay& way : flow_.ways(e, context_)) {
      if (way.first == FlatWay::infinity) continue;
      cells.add(VtkCell::line, {cells.centre({1, e}), cells.centre({2, way.first})}, {1, e}, number++);
      reach(way.first);
    }
  }
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    bool passes = false;
    const std::uint32_t next = flow_.next(at, passes);
    if (next == at || next == FlatWay::infinity) continue;
    cells.add(VtkCell::line, {cells.centre({2, at}), cells.centre({2, next})}, {2, at}, number++);
    reach(next);
  }
}

FlowOfFlat::Cells FlowOfFlat::cells() {
  Cells cells(complex_, triangulation_);
  const bool has_any = options_.stable > 0 || options_.shape || options_.simplify || options_.reconstruct;
  if (options_.unstable > 0) {
    add_ways(cells);
  } else if (!has_any) {
    add_points(cells);
  }
  if (options_.stable == 1 || options_.shape) add_edges(cells);
  if (options_.stable == 2 || options_.shape) add_triangles(cells);
  return cells;
}

VtkGrid FlowOfFlat::grid(const PointFile& file) {
  return cells().traced(file);
}

ExactCells FlowOfFlat::exact_cells(const PointFile& file) {
  if (!options_.shape) return cells().exact(file, context_);
  // Where edges meet triangles these have their midpoints as corners.
  Cells shape(complex_, triangulation_);
  for (std::uint32_t v = 0; v < triangulation_.vertex_count(); ++v)
    shape.add(VtkCell::vertex, {shape.vertex(v)}, {0, v}, triangulation_.inputs(v)[0]);
  std::uint32_t number = 0;
  for (const std::uint32_t e : edges_) {
    for (const std::uint32_t end : complex_.faces().edge(e))
      shape.add(VtkCell::line, {shape.vertex(end), shape.centre({1, e})}, {1, e}, number);
    ++number;
  }
  add_triangles(shape);
  return shape.exact(file, context_);
}

LayeredScene FlowOfFlat::page(const PointFile& file) {
  context_.progress("page", 0);
  return scene_of_flat_flow(flow_, triangulation_, flat_page_of(options_, triangulation_.vertex_count()), file,
                            context_);
}

void FlowOfFlat::announce_page() const {
  const std::size_t points = triangulation_.vertex_count();
  announce_memory(memory_of_flow(points, options_) + memory_of_flat_page(points), points, options_);
}

CellMesh FlowOfFlat::mesh(const PointFile& file) {
  CellMesh made;
  Mesh& mesh = made.mesh;
  if (options_.stable != 2 && !options_.shape) return made;
  Cells cells(complex_, triangulation_);
  add_triangles(cells);
  const VtkGrid& grid = cells.grid();
  mesh.vertices = grid.points;
  for (std::size_t i = 0; i < grid.types.size(); ++i) {
    mesh.add_face(std::span(grid.cells).subspan(grid.cell_begin[i], 3));
  }
  made.data = data_of(file, cells.origins());
  return made;
}

}  // namespace quoin::cli
