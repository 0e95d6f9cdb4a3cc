// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/exact_outputs.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/point_scenes.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"
#include "quoin/cli/triangulated_points.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Json report_of(const TriangulatedPoints& made, const PointFile& file, const Options& options) {
  Json report = describe(file, options);
  report["distinct"] = made.distinct;
  report["dimension"] = made.dimension;
  if (options.weighted) {
    report["vertices"] = made.vertices;
    report["hidden"] = made.hidden;
  }
  report["largest_multiplicity"] = made.largest_multiplicity;
  report["cells"] = made.cells;
  report["delone_cells"] = made.delone;
  report["hull_vertices"] = made.hull_vertices;
  report["hull_simplices"] = made.hull_simplices;
  if (options.check) report["check"] = "passed";
  return report;
}

LayeredScene page_of(const TriangulatedPoints& made, const PointFile& file, const Options& options,
                     const Context& context) {
  LayeredScene scene = scene_of_triangulation(made, file, context);
  std::vector<ViewFact> facts{{"Points", std::to_string(file.points.size())},
                              {"Cells", std::to_string(made.cells)},
                              {"Delone cells", std::to_string(made.delone)}};
  if (options.weighted) facts.emplace_back("Hidden points", std::to_string(made.hidden));
  scene.facts.insert(scene.facts.begin(), facts.begin(), facts.end());
  return scene;
}

void require_delone(const Options& options) {
  if (options.weighted) throw UsageError("--delone is of points without weights");
  for (const Target& target : targets_of(options)) {
    if (target.kind == Target::Kind::page) throw UsageError(target.name + ": pages show simplices, not --delone cells");
  }
}

}  // namespace

int run_delaunay(const Options& options, const Context& context) {
  if (options.weighted && options.check)
    throw UsageError("--check proves that spheres are empty: there is no such proof yet for --weighted");
  if (options.delone) require_delone(options);
  std::vector<std::string> warnings;
  const PointFile file = read_point_input(options, warnings, context);
  const bool is_written = !options.outputs.empty();
  const TriangulateOptions how{.of_plane = is_of_plane(file, options),
                               .check = options.check,
                               .is_written = is_written,
                               .delone = options.delone && is_written};
  announce_memory(memory_to_triangulate(file.points.size(), how, options.weighted), file.points.size(), options);
  const TriangulatedPoints made = triangulate(file, how, context);
  warn_of_points(made.heights_lost, made.dimension, options, how.of_plane, warnings);
  write_cells({.grid = [&] { return grid_of(made, file); },
               .mesh = [&] { return mesh_of(made, file); },
               .cells = [&] { return exact_cells_of(made, file); },
               .page = [&] { return page_of(made, file, options, context); }},
              options, warnings, context);
  Json report = report_of(made, file, options);
  const std::string text = as_text(report);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
