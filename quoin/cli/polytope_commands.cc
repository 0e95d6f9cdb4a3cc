// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/solid/measure.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Json counts(std::size_t vertices, std::size_t edges, std::size_t facets) {
  return {{"vertices", vertices}, {"edges", edges}, {"facets", facets}};
}

Json counts_of(const ConvexHull& hull, std::size_t points) {
  const std::size_t edges = hull.dimension == 3   ? hull.corners.size() / 2
                            : hull.dimension == 2 ? hull.corners.size()
                            : hull.dimension == 1 ? 1
                                                  : 0;
  Json json{{"points", points}, {"dimension", hull.dimension}};
  json.update(counts(hull.vertices.size(), edges, hull.facet_count()));
  return json;
}

/// A hull that bounds no solid is reported, and nothing else.
int report_flat(const ConvexHull& hull, Json details, std::vector<std::string> warnings, const Options& options) {
  const std::string flat = "all points are in one " + std::string(hull.dimension == 2   ? "plane"
                                                                  : hull.dimension == 1 ? "line"
                                                                                        : "place");
  if (!options.outputs.empty()) throw InputError(flat + ": their hull bounds no solid that a file could hold");
  warnings.push_back(flat);
  const std::string text = as_text(details);
  print_report(std::move(details), text, warnings, options);
  return 0;
}

}  // namespace

int run_hull(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  std::vector<Point3> points;
  for (const std::string& name : options.inputs) {
    const std::vector<Point3> more = read_vertices(name, options, warnings, context);
    points.insert(points.end(), more.begin(), more.end());
  }
  if (points.empty()) throw InputError("there are no points to take the hull of");
  const ConvexHull hull = convex_hull(points, context);
  Json details = counts_of(hull, points.size());
  if (hull.dimension < 3) return report_flat(hull, std::move(details), std::move(warnings), options);
  const Brep boundary = convex_boundary(hull, points, "hull");
  return finish({boundary, "hull", std::move(warnings), start, std::move(details)}, options, context);
}

int run_polytope_sum(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const Polytope p =
      polytope_of(read_polytope(options.inputs[0], options, warnings, context), options.inputs[0], context);
  const Polytope q =
      polytope_of(read_polytope(options.inputs[1], options, warnings, context), options.inputs[1], context);
  const PolytopeSum sum = minkowski_sum(p, q, context);
  const Brep boundary = convex_boundary(exact_vertices(sum, p, q), sum.corners, sum.facet_begin, "sum");
  Json details = counts(sum.vertices.size(), sum.edge_count(), sum.facet_count());
  details["volume"] = volume(boundary, context).to_double();
  return finish({boundary, "minkowski", std::move(warnings), start, std::move(details)}, options, context);
}

}  // namespace quoin::cli
