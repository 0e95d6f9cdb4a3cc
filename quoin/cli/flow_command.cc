// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/flow_flat.h"
#include "quoin/cli/flow_of_space.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"
#include "quoin/view/histogram_svg.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

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

/// Reports hold all that is asked for; pictures of distributions and pages manifolds of both kinds; other files one
/// thing.
void require_one_thing(const Options& options) {
  const int manifolds = (options.stable > 0 ? 1 : 0) + (options.unstable > 0 ? 1 : 0);
  const int others = (options.shape ? 1 : 0) + (options.simplify ? 1 : 0) + (options.reconstruct ? 1 : 0);
  if (options.ratio && !options.reconstruct) throw UsageError("--ratio is that of --reconstruct");
  if (options.ratio && options.separate) throw UsageError("--reconstruct goes by --ratio or by --separate");
  const std::vector<Target> targets = targets_of(options);
  const auto is_drawing = [](const Target& target) { return target.kind == Target::Kind::drawing; };
  const auto takes_one = [&](const Target& target) {
    return !is_drawing(target) && (others > 0 || target.kind != Target::Kind::page);
  };
  if (std::ranges::any_of(targets, is_drawing) && options.stable < 2 && options.unstable == 0)
    throw UsageError(".svg holds histograms of what flows: it goes with --stable 2, --stable 3 or --unstable");
  if (manifolds + others > 1 && std::ranges::any_of(targets, takes_one))
    throw UsageError(
        "outputs hold one of --stable, --unstable, --shape, --simplify and --reconstruct; pages also --stable with "
        "--unstable");
}

std::function<void(std::ostream&)> drawing_of(const std::vector<FlowHistogram>& histograms, const Options& options) {
  return [&](std::ostream& out) {
    std::vector<NamedHistogram> named;
    for (const FlowHistogram& h : histograms) named.push_back({h.name, &h.histogram});
    write_histograms(out, named, "quoin flow of " + title_of(options.inputs[0]));
  };
}

void warn_of_infinite_parts(std::size_t pieces, std::vector<std::string>& warnings) {
  if (pieces == 0) return;
  warnings.push_back(std::to_string(pieces) + " pieces of sheets reach to infinity and are not written");
}

/// Ways and sheets of space are away from the points: nothing is said of places there.
void warn_of_unstable(const PointFile& file, const Options& options, std::vector<std::string>& warnings) {
  const bool is_written = writes(options, Target::Kind::grid) || writes(options, Target::Kind::mesh) ||
                          writes(options, Target::Kind::cells);
  if (options.unstable == 0 || !is_written) return;
  for (const auto& [name, is_there] :
       {std::pair("normals", !file.normals.empty()), std::pair("colours", !file.colors.empty()),
        std::pair("intensities", !file.intensities.empty())}) {
    if (is_there) warnings.push_back(std::string("ways and sheets have no ") + name + ": those are of points");
  }
}

}  // namespace

int run_flow(const Options& options, const Context& context) {
  require_one_thing(options);
  std::vector<std::string> warnings;
  PointFile file = read_point_input(options, warnings, context);
  if (options.onto_plane) {
    for (Point3& p : file.points) p.z = 0;
  }
  announce_memory(memory_of_flow(file.points.size(), options), file.points.size(), options);
  const Delaunay3 triangulation(file.points, context, {.is_canonical = true});
  Json report = describe(file, options);
  report["distinct"] = triangulation.vertex_count();
  report["dimension"] = triangulation.dimension();
  if (triangulation.dimension() < 3) {
    FlowOfFlat flow(triangulation, options, context);
    if (writes(options, Target::Kind::page)) flow.announce_page();
    flow.report(report, warnings);
    write_cells({.grid = [&] { return flow.grid(file); },
                 .mesh = [&] { return flow.mesh(file); },
                 .cells = [&] { return flow.exact_cells(file); },
                 .text = {},
                 .page = [&] { return flow.page(file); },
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
  } else {
    FlowOfSpace flow(triangulation, options, context);
    if (writes(options, Target::Kind::page)) flow.announce_page();
    flow.report(report);
    write_cells({.grid = [&] { return flow.grid(file); },
                 .mesh = [&] { return flow.faces(file); },
                 .cells = [&] { return flow.exact_cells(file); },
                 .text = {},
                 .page = [&] { return flow.page(file); },
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
    warn_of_infinite_parts(flow.unbounded_pieces(), warnings);
    warn_of_unstable(file, options, warnings);
  }
  const std::string text = as_text(flat(report));
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
