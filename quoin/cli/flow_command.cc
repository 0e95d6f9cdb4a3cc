// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/exact_flow.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/flow_flat.h"
#include "quoin/cli/flow_outputs.h"
#include "quoin/cli/flow_report.h"
#include "quoin/cli/flow_sheets.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/view/histogram_svg.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// What a command asks of points of space, and what of it is to be written.
class FlowOfSpace {
 public:
  FlowOfSpace(const Delaunay3& triangulation, const Options& options, const Context& context)
      : options_(options), context_(context), flow_(triangulation, context) {}

  void report(Json& report) {
    add_counts(report);
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
    if (options_.shape) report["shape"] = shape();
    if (options_.simplify) report["simplified"] = simplified();
    if (options_.reconstruct) report["solid"] = solid();
  }

  VtkGrid grid() {
    VtkGrid grid;
    if (options_.unstable == 1) return grid_of_sheets(sheets());
    if (options_.unstable == 2) return grid_of_arcs(flow_, context_);
    if (options_.stable == 3) return grid_of_regions(graph(), context_);
    if (options_.stable == 1) {
      add_critical_edges(flow_, std::nullopt, grid, context_);
      return grid;
    }
    if (!has_surfaces()) return grid_of_critical_points(graph(), context_);
    if (options_.shape) add_critical_edges(flow_, square_of(*options_.shape), grid, context_);
    const FlowMesh& surfaces = mesh();
    add_surfaces(surfaces, walls_, graph(), grid);
    return grid;
  }

  ExactCells exact_cells() {
    ExactFlow exact(flow_, context_);
    if (options_.stable == 1) {
      exact.add_critical_edges();
    } else if (!has_surfaces()) {
      exact.add_critical_points(graph());
    } else {
      if (options_.shape) exact.add_graph(square_of(*options_.shape));
      const FlowMesh& surfaces = mesh();  // which makes the walls
      exact.add_surfaces(surfaces, walls_);
    }
    return exact.take();
  }

  const FlowMesh& mesh() {
    if (mesh_) return *mesh_;
    context_.progress("surfaces", 0);
    if (options_.stable == 2) {
      flow_.for_each_saddle(context_, [this](CellFacet facet) { walls_.push_back({facet, false}); });
    }
    return mesh_.emplace(flow_mesh(flow_, walls_, context_, {.keeps_exact_points = writes_exact_cells(options_)}));
  }

  Mesh faces() {
    if (options_.unstable == 1) return mesh_of_sheets(sheets());
    return has_surfaces() ? mesh_of_surfaces(mesh()) : Mesh{};
  }

  const std::vector<FlowHistogram>& histograms() const { return histograms_; }
  /// Of what is written, for warnings: pieces of sheets that reach to infinity.
  std::size_t unbounded_pieces() const { return sheets_ ? sheets_->unbounded : 0; }

  bool has_surfaces() const {
    return options_.stable == 2 || options_.stable == 3 || options_.shape || options_.simplify || options_.reconstruct;
  }

 private:
  static Rational square_of(double distance) { return Rational(distance) * Rational(distance); }

  const FlowGraph& graph() {
    if (!graph_) {
      context_.progress("ways to maxima", 0);
      graph_ = std::make_unique<FlowGraph>(flow_, context_);
    }
    return *graph_;
  }

  void add_counts(Json& report) const {
    report["critical"] = flow_.counts();
    report["euler_characteristic"] = alternating_sum(flow_.counts());
    report["stationary_regular"] = flow_.regular_polygons(context_).size() + flow_.regular_cells(context_).size();
    report["undecided_by_doubles"] = flow_.undecided().centres + flow_.undecided().spheres;
    if (options_.json) report["filters"] = report_of(flow_.undecided());
  }

  template <class Survey>
  Json told(const Survey& survey) {
    for (FlowHistogram& histogram : histograms_of(survey)) histograms_.push_back(std::move(histogram));
    return report_of(survey, options_.json);
  }

  Json regions() {
    context_.progress("regions", 0);
    const FlowRegions found = flow_regions(graph(), context_);
    const RegionSurvey survey = survey_regions(graph(), found, context_);
    histograms_ = histograms_of(survey);
    std::vector<std::uint32_t> all(graph().maxima().size());
    std::iota(all.begin(), all.end(), 0U);
    walls_ = walls_between(graph(), all);
    return report_of(found, survey, options_.json);
  }

  const SheetPolygons& sheets() {
    if (!sheets_) sheets_ = sheet_polygons(flow_, context_);
    return *sheets_;
  }

  Json shape() {
    const Rational square = square_of(*options_.shape);
    const std::array<std::size_t, 4> counts = graph().counts(square, context_);
    for (const std::uint32_t i : graph().saddles_up_to(square, context_)) {
      walls_.push_back({graph().saddles()[i].facet, false});
    }
    return {{"distance", *options_.shape},
            {"critical", counts},
            {"euler_characteristic", alternating_sum(counts)},
            {"betti_numbers", graph().betti_numbers(square, context_)}};
  }

  Json simplified() {
    const std::vector<std::uint32_t> becomes = graph().simplified(*options_.simplify, context_);
    std::size_t left = 0;
    std::size_t outside = 0;
    for (std::uint32_t i = 0; i < becomes.size(); ++i) {
      left += becomes[i] == i ? 1 : 0;
      outside += becomes[i] == graph().infinity() ? 1 : 0;
    }
    walls_ = walls_between(graph(), becomes);
    return {{"within", *options_.simplify},
            {"maxima", left},
            {"maxima_joined_to_infinity", outside},
            {"wall_saddles", walls_.size()}};
  }

  Json solid() {
    const double ratio = options_.ratio.value_or(default_ratio);
    const FlowSolid solid = flow_solid(graph(), {.ratio = ratio}, context_);
    walls_ = solid.wall;
    return {{"ratio", ratio},
            {"maxima_inside", std::count(solid.is_inside.begin(), solid.is_inside.end(), true)},
            {"wall_saddles", walls_.size()},
            {"triangles", mesh().triangles.size()},
            {"surfaces_not_ordinary", mesh().not_ordinary}};
  }

  const Options& options_;
  const Context& context_;
  FlowCells flow_;
  std::unique_ptr<FlowGraph> graph_;
  std::vector<WallSaddle> walls_;
  std::optional<FlowMesh> mesh_;
  std::optional<SheetPolygons> sheets_;
  std::vector<FlowHistogram> histograms_;
};

/// The report as lines for people: what is inside objects with the objects' names in front.
Json flat(const Json& report) {
  Json lines;
  for (const auto& [key, value] : report.items()) {
    if (!value.is_object()) {
      lines[key] = value;
      continue;
    }
    const Json inside = flat(value);
    for (const auto& [inner, number] : inside.items()) {
      std::string name = key;
      name.append(" ").append(inner);
      lines[name] = number;
    }
  }
  return lines;
}

void require_one_thing(const Options& options) {
  const int things = (options.stable > 0 ? 1 : 0) + (options.unstable > 0 ? 1 : 0) + (options.shape ? 1 : 0) +
                     (options.simplify ? 1 : 0) + (options.reconstruct ? 1 : 0);
  if (options.ratio && !options.reconstruct) throw UsageError("--ratio is that of --reconstruct");
  const std::vector<Target> targets = targets_of(options);
  const auto is_drawing = [](const Target& target) { return target.kind == Target::Kind::drawing; };
  if (std::ranges::any_of(targets, is_drawing) && options.stable < 2 && options.unstable == 0)
    throw UsageError(".svg holds histograms of what flows: it goes with --stable 2, --stable 3 or --unstable");
  if (things > 1 &&
      (!std::ranges::all_of(targets, is_drawing) || (options.shape || options.simplify || options.reconstruct)))
    throw UsageError(
        "one of --stable, --unstable, --shape, --simplify and --reconstruct at a time; without outputs, and for .svg, "
        "also --stable with --unstable");
}

void require_exact(const Options& options) {
  if (options.unstable > 0 && writes_exact_cells(options))
    throw UsageError("what --unstable writes has rounded coordinates: it does not go to .qcells");
}

std::function<void(std::ostream&)> drawing_of(const std::vector<FlowHistogram>& histograms, const Options& options) {
  return [&](std::ostream& out) {
    std::vector<NamedHistogram> named;
    for (const FlowHistogram& h : histograms) named.push_back({h.name, &h.histogram});
    write_histograms(out, named, "quoin flow of " + title_of(options.inputs[0]));
  };
}

std::uint64_t bytes_per_point(const Options& options) {
  if (writes_exact_cells(options)) return 28000;
  if (options.outputs.empty()) return 700;
  return options.unstable == 1 ? 30000 : 3000;
}

void warn_of_infinite_parts(std::size_t pieces, std::vector<std::string>& warnings) {
  if (pieces == 0) return;
  warnings.push_back(std::to_string(pieces) + " pieces of sheets reach to infinity and are not written");
}

}  // namespace

int run_flow(const Options& options, const Context& context) {
  require_one_thing(options);
  require_exact(options);
  std::vector<std::string> warnings;
  PointFile file = read_point_input(options, warnings, context);
  if (options.onto_plane) {
    for (Point3& p : file.points) p.z = 0;
  }
  announce_memory(file.points.size() * bytes_per_point(options), file.points.size(), options);
  const Delaunay3 triangulation(file.points, context, {.is_canonical = true});
  Json report = describe(file, options);
  report["distinct"] = triangulation.vertex_count();
  report["dimension"] = triangulation.dimension();
  if (triangulation.dimension() < 3) {
    FlowOfFlat flow(triangulation, options, context);
    flow.report(report, warnings);
    write_cells({.grid = [&] { return flow.grid(); },
                 .mesh = [&] { return flow.mesh(); },
                 .cells = [&] { return flow.exact_cells(); },
                 .text = {},
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
  } else {
    FlowOfSpace flow(triangulation, options, context);
    flow.report(report);
    write_cells({.grid = [&] { return flow.grid(); },
                 .mesh = [&] { return flow.faces(); },
                 .cells = [&] { return flow.exact_cells(); },
                 .text = {},
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
    warn_of_infinite_parts(flow.unbounded_pieces(), warnings);
  }
  const std::string text = as_text(flat(report));
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
