// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/alpha_outputs.h"
#include "quoin/cli/alpha_points.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/exact_outputs.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/persistence_diagram.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/point_scenes.h"
#include "quoin/cli/primes.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"
#include "quoin/cli/triangulated_points.h"
#include "quoin/triangulation/alpha_topology.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr double largest = std::numeric_limits<double>::max();

/// The value that the command line tells; nothing where it tells none.
std::optional<Rational> value_of(const Options& options) {
  const int ways = (options.value ? 1 : 0) + (options.radius ? 1 : 0) + (options.pieces ? 1 : 0);
  if (ways > 1) throw UsageError("--value, --radius and --pieces are three ways to choose a complex: give one");
  if (!options.radius) return options.value;
  return *options.radius * *options.radius;
}

void require_sense(const Options& options) {
  const bool has_value = options.value || options.radius || options.pieces;
  if (options.persistence && (has_value || !options.graph.empty()))
    throw UsageError("--persistence is of all values: it goes without --value, --radius, --pieces and --graph");
  if (options.persistence) prime_of(options);
  if (!options.persistence && (options.barcode || !options.primes.empty()))
    throw UsageError("--prime and --barcode go with --persistence");
  if (!options.graph.empty()) {
    if (options.weighted) throw UsageError("--graph is of points without weights");
    if (has_value) throw UsageError("--graph is of all points: it goes without --value, --radius and --pieces");
  }
  for (const Target& target : targets_of(options)) {
    if (!options.graph.empty() && target.kind == Target::Kind::mesh)
      throw UsageError(target.name + ": the edges of a graph go to .vtk, .qcells and .txt");
  }
}

/// Null beyond the largest double.
Json rounded(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json counts_of(const std::vector<SimplexId>& simplices, int dimension) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(dimension) + 1, 0);
  for (const SimplexId s : simplices) ++counts[static_cast<std::size_t>(s.dimension)];
  return counts;
}

/// The complex of so many grades.
Json describe_shape(const AlphaComplex& alpha, const AlphaIntervals& intervals, std::uint32_t grades,
                    const Context& context) {
  const AlphaShape shape = alpha_shape(alpha, intervals, grades, context);
  const int dimension = alpha.dimension();
  const auto betti = alpha_betti_numbers(alpha, grades, context);
  std::vector<std::size_t> counts(static_cast<std::size_t>(dimension) + 1, 0);
  std::int64_t euler = 0;
  for (const auto* list : {&shape.singular, &shape.regular, &shape.interior}) {
    for (const SimplexId s : *list) {
      ++counts[static_cast<std::size_t>(s.dimension)];
      euler += s.dimension % 2 == 0 ? 1 : -1;
    }
  }
  return {{"simplices", counts},
          {"singular", counts_of(shape.singular, dimension)},
          {"regular", counts_of(shape.regular, dimension)},
          {"interior", counts_of(shape.interior, dimension)},
          {"euler_characteristic", euler},
          {"betti", betti},
          {"pieces", alpha_pieces(alpha, grades, context)}};
}

void add_values(Json& report, const AlphaComplex& alpha, const Options& options, const Context& context) {
  Json values = Json::array();
  Json exact = Json::array();
  for (std::uint32_t g = 0; g < alpha.grade_count(); ++g) {
    if (g % 1024 == 0) context.poll();
    values.push_back(rounded(alpha.value(g)));
    if (options.exact) exact.push_back(alpha.exact_value(g).to_string());
  }
  report["values"] = std::move(values);
  if (options.exact) report["exact_values"] = std::move(exact);
}

/// For people, a line per value.
std::string text_of_values(const Json& report) {
  std::string text;
  for (std::size_t i = 0; i < report["values"].size(); ++i) {
    text += "value " + report["values"][i].dump();
    if (report.contains("exact_values")) text += " = " + report["exact_values"][i].get<std::string>();
    text += "\n";
  }
  return text;
}

VertexPairs graph_of(const AlphaComplex& alpha, const std::string& name, const Context& context) {
  context.progress("graph", 0);
  if (name == "gabriel") return gabriel_edges(alpha);
  if (name == "relative-neighbours") return relative_neighbours(alpha, context);
  return minimum_spanning_tree(alpha, context);
}

void run_graph(const AlphaPoints& points, const PointFile& file, Json& report, std::vector<std::string>& warnings,
               const Options& options, const Context& context) {
  const VertexPairs edges = graph_of(points.alpha, options.graph, context);
  double length = 0;
  for (const double of_edge : lengths_of(points, edges)) length += of_edge;
  report["graph"] = options.graph;
  report["edges"] = edges.size();
  report["length"] = rounded(length);
  write_cells({.grid = [&] { return grid_of_graph(points, edges, file); },
               .mesh = {},
               .cells = [&] { return exact_cells_of_graph(points, edges, file); },
               .text = [&](std::ostream& out) { write_graph(out, points, edges, context); },
               .page = [&] { return scene_of_graph(points, edges, options.graph, file); }},
              options, warnings, context);
}

struct Choice {
  std::uint32_t grades;
  std::optional<Rational> value;  // nothing: all
};

Choice choose(const AlphaComplex& alpha, const std::optional<Rational>& value, const Options& options,
              const Context& context) {
  if (value) return {alpha.grades_up_to(*value), value};
  if (!options.pieces) return {alpha.grade_count(), std::nullopt};
  const std::uint32_t grades = grades_with_pieces(alpha, *options.pieces, context);
  return {grades, alpha.exact_value(grades - 1)};
}

LayeredScene page_of(const AlphaPoints& points, const AlphaIntervals& intervals, const Choice& choice,
                     const PointFile& file, const Context& context) {
  context.progress("persistence", 0);
  const auto shown = choice.value ? std::optional(choice.grades) : std::nullopt;
  LayeredScene scene = scene_of_alpha(points, intervals, shown, file, context);
  scene.facts.insert(scene.facts.begin(), {"Points", std::to_string(file.points.size())});
  return scene;
}

void run_shape(const AlphaPoints& points, const PointFile& file, const std::optional<Rational>& value, Json& report,
               std::vector<std::string>& warnings, const Options& options, const Context& context) {
  const AlphaComplex& alpha = points.alpha;
  const Choice choice = choose(alpha, value, options, context);
  if (choice.value) {
    report["value"] = rounded(choice.value->to_double());
    report["exact_value"] = choice.value->to_string();
    if (!options.weighted) report["radius"] = rounded(std::sqrt(choice.value->to_double()));
  }
  context.progress("shape", 0);
  const AlphaIntervals intervals(alpha, context);
  report["shape"] = describe_shape(alpha, intervals, choice.grades, context);
  write_cells({.grid = [&] { return grid_of_shape(points, intervals, choice.grades, file, context); },
               .mesh = [&] { return mesh_of_shape(points, intervals, choice.grades, file, context); },
               .cells = [&] { return exact_cells_of_shape(points, choice.grades, file, context); },
               .text =
                   [&](std::ostream& out) {
                     const std::size_t merged = write_filtration(out, points, choice.grades, options.exact, context);
                     if (merged == 0) return;
                     warnings.push_back(std::to_string(merged) +
                                        " values are the same doubles as the ones before: '--exact' keeps them apart");
                   },
               .page = [&] { return page_of(points, intervals, choice, file, context); }},
              options, warnings, context);
}

PersistenceDiagram run_persistence_of(const AlphaComplex& alpha, Json& report, const Options& options,
                                      const Context& context) {
  context.progress("persistence", 0);
  const PersistenceOptions how{.prime = prime_of(options)};
  const GradeValues values{[&](std::uint32_t grade) { return std::clamp(alpha.value(grade), -largest, largest); },
                           [&](std::uint32_t grade) { return alpha.exact_value(grade).to_string(); }, options.exact};
  PersistenceDiagram diagram(alpha.filtration(), values, persistence(alpha.filtration(), how, context), context);
  diagram.write(options);
  report["prime"] = how.prime;
  diagram.add_to(report, options.json);
  return diagram;
}

/// Nested keys as lines of their own.
std::string text_of(const Json& report) {
  Json flat;
  for (const auto& [key, value] : report.items()) {
    if (key == "values" || key == "exact_values") continue;
    if (key == "shape") {
      flat.update(Json{{"simplices_of_shape", value["simplices"]}});
      for (const auto& [inner, count] : value.items()) {
        if (inner != "simplices") flat[inner] = count;
      }
    } else {
      flat[key] = value;
    }
  }
  return as_text(flat);
}

}  // namespace

int run_alpha(const Options& options, const Context& context) {
  const std::optional<Rational> value = value_of(options);
  require_sense(options);
  if (!options.weighted && value && value->sign() == Sign::negative)
    throw UsageError("--value is below zero, and squared radii are not");
  std::vector<std::string> warnings;
  const PointFile file = read_point_input(options, warnings, context);
  const TriangulateOptions how{.of_plane = is_of_plane(file, options)};
  announce_memory(memory_to_triangulate(file.points.size(), how, options.weighted), file.points.size(), options);
  const AlphaPoints points = alpha_of_points(file, options, context);
  warn_of_points(points.heights_lost, points.alpha.dimension(), options, how.of_plane, warnings);
  Json report = describe(file, options);
  report["distinct"] = points.distinct;
  report["dimension"] = points.alpha.dimension();
  if (options.weighted) {
    report["vertices"] = points.first_input.size();
    report["hidden"] = points.hidden;
  }
  std::vector<std::size_t> counts;
  for (int k = 0; k <= points.alpha.dimension(); ++k) counts.push_back(points.alpha.complex().count(k));
  report["simplices"] = counts;
  report["critical_values"] = points.alpha.grade_count();
  std::string intervals;
  if (options.persistence) {
    const PersistenceDiagram diagram = run_persistence_of(points.alpha, report, options, context);
    if (const std::string lost = diagram.lost_by_rounding(); !lost.empty()) warnings.push_back(lost);
    if (!options.json && !options.quiet) intervals = diagram.text(options.verbose);
  } else if (options.graph.empty()) {
    run_shape(points, file, value, report, warnings, options, context);
  } else {
    run_graph(points, file, report, warnings, options, context);
  }
  if (options.values) add_values(report, points.alpha, options, context);
  std::string text;
  if (!options.json && !options.quiet)
    text = text_of(report) + intervals + (options.values ? text_of_values(report) : "");
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
