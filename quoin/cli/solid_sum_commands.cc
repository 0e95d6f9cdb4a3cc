// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/polytope_report.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/polytope/ball.h"
#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/convex_pieces.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/notches.h"
#include "quoin/polytope/polytope.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/topology_counts.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// An operand of a sum: a solid, or points that mean their hull, which may be flat.
using Operand = std::variant<Solid, Polytope>;

Operand read_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                     const Context& context) {
  const Input input = read_input(name, options, warnings, context);
  if (has_points_only(input)) return polytope_of(std::get<Mesh>(input).vertices, name, context);
  Solid solid = solid_of_input(input, name, warnings, context);
  if (solid.boundary().is_unbounded) throw InputError(shown(name) + ": the solid is unbounded");
  return solid;
}

bool is_convex(const Operand& operand, const Context& context) {
  const Solid* solid = std::get_if<Solid>(&operand);
  if (solid == nullptr) return true;
  return solid->boundary().shells.size() == 1 && !has_notch(solid->boundary(), context);
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
                         << " pairs of edges: seconds for each billion, and memory for what they make" << std::endl;
}

std::vector<Operand> read_operands(const Options& options, std::vector<std::string>& warnings, const Context& context) {
  std::vector<Operand> operands;
  for (const std::string& name : options.inputs) operands.push_back(read_operand(name, options, warnings, context));
  if (options.ball) operands.emplace_back(ball_of(options, context));
  return operands;
}

/// Solids first: what they sum to is a solid that polytopes of any dimension are added to.
Solid sum_of_solids(const std::vector<Operand>& operands, const Options& options, const Context& context) {
  std::optional<Solid> sum;
  for (const Operand& operand : operands) {
    const Solid* solid = std::get_if<Solid>(&operand);
    if (solid == nullptr) continue;
    if (sum) announce(*sum, *solid, options);
    sum = sum ? minkowski_sum(*sum, *solid, context) : *solid;
  }
  for (const Operand& operand : operands) {
    if (const Polytope* hull = std::get_if<Polytope>(&operand)) sum = minkowski_sum(*sum, *hull, context);
  }
  return *sum;
}

std::vector<Polytope> polytopes_of(std::vector<Operand> operands, const Context& context) {
  std::vector<Polytope> polytopes;
  for (Operand& operand : operands) {
    if (const Solid* solid = std::get_if<Solid>(&operand)) {
      polytopes.push_back(hull_of_boundary(solid->boundary(), context));
    } else {
      polytopes.push_back(std::get<Polytope>(std::move(operand)));
    }
  }
  return polytopes;
}

int finish_polytope_sum(std::span<const Polytope> summands, std::vector<std::string> warnings, Clock::time_point start,
                        const Options& options, const Context& context) {
  const PolytopeSumOfMany sum = minkowski_sum(summands, context);
  Json details{{"dimension", sum.dimension}};
  details.update(cell_counts(sum.vertex_count(), sum.edge_count(), sum.facet_count()));
  if (sum.dimension < 3)
    return report_flat(sum.dimension, "the sum is", std::move(details), std::move(warnings), options);
  const Brep boundary = convex_boundary(exact_vertices(sum, summands), sum.corners, sum.facet_begin, "sum");
  details["volume"] = rounded_volume(boundary, context);
  return finish({boundary, "minkowski", std::move(warnings), start, std::move(details)}, options, context);
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

int run_minkowski_sum(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  std::vector<Operand> operands = read_operands(options, warnings, context);
  if (std::ranges::all_of(operands, [&](const Operand& operand) { return is_convex(operand, context); })) {
    return finish_polytope_sum(polytopes_of(std::move(operands), context), std::move(warnings), start, options,
                               context);
  }
  const Solid sum = sum_of_solids(operands, options, context);
  return finish({sum.boundary(), "minkowski", std::move(warnings), start, details_of(sum, context)}, options, context);
}

int run_erosion(const Options& options, const Context& context) {
  require_operands(options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::vector<Operand> operands = read_operands(options, warnings, context);
  const Solid* solid = std::get_if<Solid>(&operands[0]);
  if (solid == nullptr) throw InputError(shown(options.inputs[0]) + ": points bound no solid to be eroded");
  const Solid* tool = std::get_if<Solid>(&operands[1]);
  if (tool != nullptr) announce(*solid, *tool, options);
  const Solid rest =
      tool != nullptr ? erosion(*solid, *tool, context) : erosion(*solid, std::get<Polytope>(operands[1]), context);
  return finish({rest.boundary(), "erode", std::move(warnings), start, details_of(rest, context)}, options, context);
}

}  // namespace quoin::cli
