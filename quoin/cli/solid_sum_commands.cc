// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/polytope/ball.h"
#include "quoin/polytope/notches.h"
#include "quoin/polytope/polytope.h"
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

/// An operand of a sum: a solid, or points that mean their hull, which may be flat.
struct Operand {
  std::optional<Solid> solid;
  std::optional<Polytope> hull;
  bool is_convex() const { return hull.has_value() || is_convex_solid; }
  bool is_convex_solid = false;
};

Operand read_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                     const Context& context) {
  Operand operand;
  const Input input = read_input(name, options, warnings, context);
  if (has_points_only(input)) {
    operand.hull = Polytope::hull_of(std::get<Mesh>(input).vertices, context);
    return operand;
  }
  LeafResult leaf = make_leaf(input, name, context);
  if (!leaf.leaf) throw InputError(refusal(name, "bounds no solid", describe(input, leaf.diagnosis)));
  if (const Brep* exact = std::get_if<Brep>(&input); exact != nullptr && exact->is_unbounded)
    throw InputError(shown(name) + ": the solid is unbounded");
  operand.solid = Solid::from_leaf(std::move(leaf.leaf), context);
  operand.is_convex_solid = is_convex(*operand.solid, context);
  return operand;
}

void require_operands(const Options& options) {
  const std::size_t count = options.inputs.size() + (options.ball ? 1 : 0);
  if (count < 2 || (count > 2 && options.command == "erode"))
    throw UsageError(options.command + " takes " + (options.command == "erode" ? "two solids" : "two or more solids") +
                     ", or one and --ball");
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

std::vector<Operand> read_operands(const Options& options, std::vector<std::string>& warnings, const Context& context) {
  std::vector<Operand> operands;
  for (const std::string& name : options.inputs) operands.push_back(read_operand(name, options, warnings, context));
  if (options.ball) operands.push_back({ball_of(options, context), std::nullopt, true});
  return operands;
}

/// Solids first: what they sum to is a solid that polytopes of any dimension are added to.
Solid sum_of(const std::vector<Operand>& operands, const Options& options, const Context& context) {
  std::optional<Solid> sum;
  for (const Operand& operand : operands) {
    if (!operand.solid) continue;
    if (sum) announce(*sum, *operand.solid, options);
    sum = sum ? minkowski_sum(*sum, *operand.solid, context) : *operand.solid;
  }
  for (const Operand& operand : operands) {
    if (operand.hull) sum = minkowski_sum(*sum, *operand.hull, context);
  }
  return *sum;
}

Json details_of(const Solid& result, const Context& context) {
  const TopologyCounts counts = count_topology(result.boundary());
  return {{"dimension", 3},
          {"vertices", counts.vertices},
          {"edges", counts.edges},
          {"facets", counts.faces},
          {"volume", rounded_volume(result.boundary(), context)}};
}

}  // namespace

int run_solid_sum(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::vector<Operand> operands = read_operands(options, warnings, context);
  if (!options.ball && std::ranges::all_of(operands, &Operand::is_convex)) return run_polytope_sum(options, context);
  const Solid sum = sum_of(operands, options, context);
  return finish({sum.boundary(), "minkowski", std::move(warnings), start, details_of(sum, context)}, options, context);
}

int run_erosion(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::vector<Operand> operands = read_operands(options, warnings, context);
  if (!operands[0].solid) throw InputError(shown(options.inputs[0]) + ": points bound no solid to be eroded");
  const Solid& solid = *operands[0].solid;
  if (operands[1].solid) announce(solid, *operands[1].solid, options);
  const Solid rest =
      operands[1].solid ? erosion(solid, *operands[1].solid, context) : erosion(solid, *operands[1].hull, context);
  return finish({rest.boundary(), "erode", std::move(warnings), start, details_of(rest, context)}, options, context);
}

}  // namespace quoin::cli
