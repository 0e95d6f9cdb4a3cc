// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_of_space.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "quoin/cli/exact_flow.h"
#include "quoin/cli/flow_scene.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/targets.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/saddle_surfaces.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

bool has_pages_alone(const Options& options) {
  return std::ranges::all_of(targets_of(options),
                             [](const Target& target) { return target.kind == Target::Kind::page; });
}

Rational square_of(const Rational& distance) {
  return distance * distance;
}

}  // namespace

std::uint64_t memory_of_flow(std::size_t points, const Options& options) {
  const auto bytes = [&]() -> std::uint64_t {
    if (writes(options, Target::Kind::cells)) return options.unstable == 1 ? 100000 : 28000;
    if (has_pages_alone(options)) return 700;
    return options.unstable == 1 ? 30000 : 3000;
  };
  return points * bytes();
}

FlowOfSpace::FlowOfSpace(const Delaunay3& triangulation, const Options& options, const Context& context)
    : options_(options), context_(context), flow_(triangulation, context) {}

void FlowOfSpace::report(Json& report) {
  add_counts(report);
  if (options_.stable == 1) report["stable"] = report_of_edges(flow_.counts()[1], options_.json);
  if (options_.stable == 2) {
    context_.progress("stable surfaces", 0);
    report["stable"] = told(survey_stable(flow_, context_));
  }
  if (options_.stable == 3) report["stable"] = regions();
  if (options_.unstable == 1) {
    context_.progress("unstable sheets", 0);
    report["unstable"] = told(survey_sheets(flow_, context_));
  }
  if (options_.unstable == 2) {
    context_.progress("ways to maxima", 0);
    report["unstable"] = told(survey_unstable(flow_, context_));
  }
  if (options_.separate) report["separation"] = separated();
  if (options_.shape) report["shape"] = shape();
  if (options_.simplify) report["simplified"] = simplified();
  if (options_.reconstruct) report["solid"] = solid();
}

VtkGrid FlowOfSpace::grid(const PointFile& file) {
  if (options_.unstable == 1) return grid_of_sheets(sheets());
  if (options_.unstable == 2) return grid_of_arcs(flow_, context_);
  TracedGrid made = traced();
  made.cells.point_integers.emplace_back("input", made.origins.given());
  add_data(made.cells, data_of(file, made.origins));
  return std::move(made.cells);
}

TracedGrid FlowOfSpace::traced() {
  TracedGrid grid;
  if (options_.stable == 3) return grid_of_regions(graph(), context_);
  if (options_.stable == 1) {
    add_critical_edges(flow_, std::nullopt, grid, context_);
    return grid;
  }
  if (!has_surfaces()) return grid_of_critical_points(graph(), separation_, context_);
  if (options_.shape) add_critical_edges(flow_, square_of(*options_.shape), grid, context_);
  const FlowMesh& surfaces = mesh();
  add_surfaces(surfaces, walls_, graph(), grid);
  return grid;
}

ExactCells FlowOfSpace::exact_cells(const PointFile& file) {
  ExactFlow exact(flow_, context_);
  if (options_.unstable == 1) {
    unbounded_ = exact.add_sheets();
  } else if (options_.unstable == 2) {
    exact.add_ways();
  } else if (options_.stable == 1) {
    exact.add_critical_edges();
  } else if (!has_surfaces()) {
    exact.add_critical_points(graph());
  } else {
    if (options_.shape) exact.add_graph(square_of(*options_.shape));
    const FlowMesh& surfaces = mesh();  // which makes the walls
    exact.add_surfaces(surfaces, walls_);
  }
  return exact.take(file);
}

void FlowOfSpace::announce_page() const {
  const std::size_t points = flow_.triangulation().vertex_count();
  const std::uint64_t bytes = memory_of_flow_page(flow_page_of(options_, points), flow_);
  announce_memory(memory_of_flow(points, options_) + bytes, points, options_);
}

LayeredScene FlowOfSpace::page(const PointFile& file) {
  FlowPage page = flow_page_of(options_, flow_.triangulation().vertex_count());
  page.separation = separation_;
  page.walls = walls_;
  page.chosen = chosen_;
  context_.progress("page", 0);
  return scene_of_flow(graph(), page, file, context_);
}

const FlowMesh& FlowOfSpace::mesh() {
  if (mesh_) return *mesh_;
  context_.progress("surfaces", 0);
  if (options_.stable == 2) {
    flow_.for_each_saddle(context_, [this](CellFacet facet) { walls_.push_back({facet, false}); });
  }
  return mesh_.emplace(
      flow_mesh(flow_, walls_, context_, {.keeps_exact_points = writes(options_, Target::Kind::cells)}));
}

CellMesh FlowOfSpace::faces(const PointFile& file) {
  if (options_.unstable == 1) return mesh_of_sheets(sheets());
  if (!has_surfaces()) return {};
  CellMesh made(mesh_of_surfaces(mesh()));
  made.data = data_of(file, origins_of(mesh(), flow_.triangulation()));
  return made;
}

bool FlowOfSpace::has_surfaces() const {
  return options_.stable == 2 || options_.stable == 3 || options_.shape || options_.simplify || options_.reconstruct;
}

const FlowGraph& FlowOfSpace::graph() {
  if (!graph_) {
    context_.progress("ways to maxima", 0);
    graph_ = std::make_unique<FlowGraph>(flow_, context_);
  }
  return *graph_;
}

void FlowOfSpace::add_counts(Json& report) const {
  report["critical"] = flow_.counts();
  report["euler_characteristic"] = alternating_sum(flow_.counts());
  report["stationary_regular"] = flow_.regular_polygons(context_).size() + flow_.regular_cells(context_).size();
  report["undecided_by_doubles"] = flow_.undecided().centres + flow_.undecided().spheres;
  if (options_.json) report["filters"] = report_of(flow_.undecided());
}

template <class Survey>
Json FlowOfSpace::told(const Survey& survey) {
  for (FlowHistogram& histogram : histograms_of(survey)) histograms_.push_back(std::move(histogram));
  return report_of(survey, options_.json);
}

Json FlowOfSpace::regions() {
  context_.progress("regions", 0);
  const FlowRegions found = flow_regions(graph(), context_);
  const RegionSurvey survey = survey_regions(graph(), found, context_);
  histograms_ = histograms_of(survey);
  std::vector<std::uint32_t> all(graph().maxima().size());
  std::iota(all.begin(), all.end(), 0U);
  walls_ = walls_between(graph(), all);
  return report_of(found, survey, options_.json);
}

const SheetPolygons& FlowOfSpace::sheets() {
  if (!sheets_) sheets_ = sheet_polygons(flow_, context_);
  unbounded_ = sheets_->unbounded;
  return *sheets_;
}

Json FlowOfSpace::shape() {
  const Rational square = square_of(*options_.shape);
  const std::array<std::size_t, 4> counts = graph().counts(square, context_);
  for (const std::uint32_t i : graph().saddles_up_to(square, context_)) {
    walls_.push_back({graph().saddles()[i].facet, false});
  }
  Json shape;
  add_number(shape, "distance", *options_.shape);
  shape["critical"] = counts;
  shape["euler_characteristic"] = alternating_sum(counts);
  shape["betti_numbers"] = graph().betti_numbers(square, context_);
  return shape;
}

Json FlowOfSpace::simplified() {
  const std::vector<std::uint32_t> becomes = graph().simplified(*options_.simplify, context_);
  std::size_t left = 0;
  std::size_t outside = 0;
  for (std::uint32_t i = 0; i < becomes.size(); ++i) {
    chosen_.push_back(becomes[i] == i);
    left += becomes[i] == i ? 1 : 0;
    outside += becomes[i] == graph().infinity() ? 1 : 0;
  }
  walls_ = walls_between(graph(), becomes);
  Json simplified;
  add_number(simplified, "within", *options_.simplify);
  simplified["maxima"] = left;
  simplified["maxima_joined_to_infinity"] = outside;
  simplified["wall_saddles"] = walls_.size();
  return simplified;
}

const CriticalSeparation& FlowOfSpace::separation() {
  if (!separation_) {
    context_.progress("separation", 0);
    separation_ = separate(graph(), context_);
  }
  return *separation_;
}

Json FlowOfSpace::separated() {
  const CriticalSeparation& found = separation();
  std::array<std::size_t, 4> of_surface = flow_.counts();
  for (std::size_t i = 0; i < 4; ++i) of_surface[i] -= found.medial[i];
  return {{"surface", of_surface}, {"medial", found.medial}, {"disputed", found.disputed}};
}

/// By ratios of distances.
Json FlowOfSpace::peeled() {
  const Rational ratio = options_.ratio.value_or(default_ratio);
  FlowSolid solid = flow_solid(graph(), {.ratio = ratio}, context_);
  walls_ = std::move(solid.wall);
  chosen_ = std::move(solid.is_inside);
  Json told;
  add_number(told, "ratio", ratio);
  return told;
}

Json FlowOfSpace::solid() {
  Json told;
  if (options_.separate) {
    SeparatedSolid found = separated_solid(graph(), separation(), context_);
    walls_ = std::move(found.solid.wall);
    chosen_ = std::move(found.solid.is_inside);
    told = {{"parts_of_space", found.parts}, {"unclear_saddles", found.unclear}};
  } else {
    told = peeled();
  }
  // Without coordinates, which take much longer and are not always written.
  std::size_t triangles = 0;
  std::size_t not_ordinary = 0;
  SaddleSurfaces surfaces(flow_);
  for (const WallSaddle& wall : walls_) {
    context_.poll();
    const SurfacePieces& surface = surfaces.follow(wall.facet, context_);
    triangles += 2 * surface.pieces.size();
    not_ordinary += surface.is_ordinary() ? 0 : 1;
  }
  told["maxima_inside"] = std::count(chosen_.begin(), chosen_.end(), true);
  told["wall_saddles"] = walls_.size();
  told["triangles"] = triangles;
  told["surfaces_not_ordinary"] = not_ordinary;
  return told;
}

}  // namespace quoin::cli
