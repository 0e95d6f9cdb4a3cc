// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <variant>

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

/// What bounds no solid is reported, and nothing else. `what` lies in one place, line or plane.
int report_flat(int dimension, const std::string& what, Json details, std::vector<std::string> warnings,
                const Options& options) {
  const std::string flat = what + " in one " + (dimension == 2 ? "plane" : dimension == 1 ? "line" : "place");
  if (!options.outputs.empty()) throw InputError(flat + ", which bounds no solid that a file could hold");
  warnings.push_back(flat);
  const std::string text = as_text(details);
  print_report(std::move(details), text, warnings, options);
  return 0;
}

}  // namespace

int run_hull(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const InputPoints input = read_vertices(options.inputs, options, warnings, context);
  return std::visit(
      [&](const auto& points) {
        if (points.empty()) throw InputError("there are no points to take the hull of");
        const ConvexHull hull = convex_hull(points, context);
        Json details = counts_of(hull, points.size());
        if (hull.dimension < 3) {
          return report_flat(hull.dimension, "all points are", std::move(details), std::move(warnings), options);
        }
        const Brep boundary = convex_boundary(hull, points, "hull");
        return finish({boundary, "hull", std::move(warnings), start, std::move(details)}, options, context);
      },
      input);
}

int run_polytope_sum(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  std::vector<Polytope> summands;
  for (const std::string& name : options.inputs) {
    summands.push_back(polytope_of(read_polytope(name, options, warnings, context), name, context));
  }
  const PolytopeSumOfMany sum = minkowski_sum(summands, context);
  Json details{{"dimension", sum.dimension}};
  details.update(counts(sum.vertex_count(), sum.edge_count(), sum.facet_count()));
  if (sum.dimension < 3) {
    return report_flat(sum.dimension, "the sum is", std::move(details), std::move(warnings), options);
  }
  const Brep boundary = convex_boundary(exact_vertices(sum, summands), sum.corners, sum.facet_begin, "sum");
  details["volume"] = volume(boundary, context).to_double();
  return finish({boundary, "minkowski", std::move(warnings), start, std::move(details)}, options, context);
}

}  // namespace quoin::cli
