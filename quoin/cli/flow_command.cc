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

void require_one_thing(const Options& options) {
  const int things = (options.stable > 0 ? 1 : 0) + (options.unstable > 0 ? 1 : 0) + (options.shape ? 1 : 0) +
                     (options.simplify ? 1 : 0) + (options.reconstruct ? 1 : 0);
  if (options.ratio && !options.reconstruct) throw UsageError("--ratio is that of --reconstruct");
  if (options.ratio && options.separate) throw UsageError("--reconstruct goes by --ratio or by --separate");
  const std::vector<Target> targets = targets_of(options);
  const auto is_drawing = [](const Target& target) { return target.kind == Target::Kind::drawing; };
  const auto takes_two = [&](const Target& target) { return is_drawing(target) || target.kind == Target::Kind::page; };
  if (std::ranges::any_of(targets, is_drawing) && options.stable < 2 && options.unstable == 0)
    throw UsageError(".svg holds histograms of what flows: it goes with --stable 2, --stable 3 or --unstable");
  if (things > 1 &&
      (!std::ranges::all_of(targets, takes_two) || (options.shape || options.simplify || options.reconstruct)))
    throw UsageError(
        "one of --stable, --unstable, --shape, --simplify and --reconstruct at a time; without outputs, and for .svg "
        "and "
        "pages, "
        "also --stable with --unstable");
}

void require_exact(const Options& options) {
  if (options.unstable > 0 && writes(options, Target::Kind::cells))
    throw UsageError("what --unstable writes has rounded coordinates: it does not go to .qcells");
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

}  // namespace

int run_flow(const Options& options, const Context& context) {
  require_one_thing(options);
  require_exact(options);
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
    write_cells({.grid = [&] { return flow.grid(); },
                 .mesh = [&] { return flow.mesh(); },
                 .cells = [&] { return flow.exact_cells(); },
                 .text = {},
                 .page = [&] { return flow.page(file); },
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
  } else {
    FlowOfSpace flow(triangulation, options, context);
    if (writes(options, Target::Kind::page)) flow.announce_page();
    flow.report(report);
    write_cells({.grid = [&] { return flow.grid(); },
                 .mesh = [&] { return flow.faces(); },
                 .cells = [&] { return flow.exact_cells(); },
                 .text = {},
                 .page = [&] { return flow.page(file); },
                 .drawing = drawing_of(flow.histograms(), options)},
                options, warnings, context);
    warn_of_infinite_parts(flow.unbounded_pieces(), warnings);
  }
  const std::string text = as_text(flat(report));
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
