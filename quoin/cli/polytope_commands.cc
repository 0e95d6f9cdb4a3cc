// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/polytope_report.h"
#include "quoin/cli/reporting.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Json counts_of(const ConvexHull& hull, std::size_t points) {
  const std::size_t edges = hull.dimension == 3   ? hull.corners.size() / 2
                            : hull.dimension == 2 ? hull.corners.size()
                            : hull.dimension == 1 ? 1
                                                  : 0;
  Json json{{"points", points}, {"dimension", hull.dimension}};
  json.update(cell_counts(hull.vertices.size(), edges, hull.facet_count()));
  return json;
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

}  // namespace quoin::cli
