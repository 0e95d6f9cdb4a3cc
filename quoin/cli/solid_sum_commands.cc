// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/polytope/ball.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/notches.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/topology_counts.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

bool has_points_only(const Input& input) {
  const Mesh* mesh = std::get_if<Mesh>(&input);
  return mesh != nullptr && mesh->face_count() == 0 && !mesh->vertices.empty();
}

bool is_convex(const Solid& solid, const Context& context) {
  const Brep& b = solid.boundary();
  return b.shells.size() == 1 && !b.is_unbounded && find_notches(b, context).empty();
}

/// An operand of a sum: points mean their hull.
struct Operand {
  Solid solid;
  bool is_polytope = false;
};

Operand hull_of_points(const std::vector<Point3>& points, const std::string& name, const Context& context) {
  const ConvexHull hull = convex_hull(points, context);
  if (hull.dimension < 3) return {{}, true};
  return {Solid::from_boundary(convex_boundary(hull, points, title_of(name)), title_of(name), context), true};
}

Operand read_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                     const Context& context) {
  const Input input = read_input(name, options, warnings, context);
  if (has_points_only(input)) return hull_of_points(std::get<Mesh>(input).vertices, name, context);
  LeafResult leaf = make_leaf(input, name, context);
  if (!leaf.leaf) throw InputError(refusal(name, "bounds no solid", describe(input, leaf.diagnosis)));
  if (const Brep* exact = std::get_if<Brep>(&input); exact != nullptr && exact->is_unbounded)
    throw InputError(shown(name) + ": the solid is unbounded");
  Operand operand{Solid::from_leaf(std::move(leaf.leaf), context), false};
  operand.is_polytope = is_convex(operand.solid, context);
  return operand;
}

void require_operands(const Options& options) {
  const std::size_t count = options.inputs.size() + (options.ball ? 1 : 0);
  if (count != 2) throw UsageError(options.command + " takes two solids, or one and --ball");
  if (!options.ball && (options.within || options.inner)) throw UsageError("--within and --inner are of --ball");
}

/// The polytope for the ball such that the result holds the exact one, or lies within it. What is taken away is larger
/// the smaller the erosion is to be.
Solid ball_of(const Options& options, const Context& context) {
  const bool is_small = (options.command == "minkowski") == options.inner;
  const double within = options.within.value_or(*options.ball / 100);
  return ball_polytope(*options.ball, within, is_small ? BallSide::within : BallSide::around, context);
}

/// Announced where it may take long.
void announce(const Solid& a, const Solid& b, const Options& options) {
  constexpr double many = 1e9;
  const SumEstimate estimate = estimate_sum(a, b);
  if (estimate.edge_pairs < many || options.quiet) return;
  report_stream(options) << "a sum over " << estimate.edges_of_first << " x " << estimate.edges_of_second
                         << " pairs of edges: seconds for each billion, and memory for what they make\n";
}

Json details_of(const Solid& result, const Context& context) {
  const TopologyCounts counts = count_topology(result.boundary());
  return {{"vertices", counts.vertices},
          {"edges", counts.edges},
          {"facets", counts.faces},
          {"volume", rounded_volume(result.boundary(), context)}};
}

}  // namespace

int run_solid_sum(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const Operand a = read_operand(options.inputs[0], options, warnings, context);
  const Operand b =
      options.ball ? Operand{ball_of(options, context)} : read_operand(options.inputs[1], options, warnings, context);
  if (a.is_polytope && b.is_polytope) return run_polytope_sum(options, context);
  if ((a.is_polytope && a.solid.is_empty()) || (b.is_polytope && b.solid.is_empty()))
    throw InputError("sums of a solid that is not convex and a flat polytope are not made");
  announce(a.solid, b.solid, options);
  const Solid sum = minkowski_sum(a.solid, b.solid, context);
  return finish({sum.boundary(), "minkowski", std::move(warnings), start, details_of(sum, context)}, options, context);
}

int run_erosion(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const Operand a = read_operand(options.inputs[0], options, warnings, context);
  const Operand b =
      options.ball ? Operand{ball_of(options, context)} : read_operand(options.inputs[1], options, warnings, context);
  if (b.is_polytope && b.solid.is_empty())
    throw InputError("the second operand is flat: erosions by such are not made");
  announce(a.solid, b.solid, options);
  const Solid rest = erosion(a.solid, b.solid, context);
  return finish({rest.boundary(), "erode", std::move(warnings), start, details_of(rest, context)}, options, context);
}

}  // namespace quoin::cli
