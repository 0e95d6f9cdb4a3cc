// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <span>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/proximity_inputs.h"
#include "quoin/cli/proximity_path.h"
#include "quoin/cli/proximity_report.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/polytope/proximity.h"
#include "quoin/polytope/proximity_queries.h"
#include "quoin/solid/query/distance.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

RationalPoint3 vector_of(const std::vector<Rational>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

void require_convex(const ProximityOperand& a, const ProximityOperand& b) {
  for (const ProximityOperand* operand : {&a, &b}) {
    if (operand->is_convex()) continue;
    throw InputError(shown(operand->name) + ": --direction needs convex solids with corners that are doubles");
  }
}

Json convex_distance(const Polytope& a, const Polytope& b, const Vector3& translation,
                     const std::optional<RationalPoint3>& direction, const Context& context) {
  const ProximityQueries queries(a, b, context);
  ProximityHint hint;
  const TranslationDistance d = queries.distance(translation, hint);
  Json report = describe_distance(d.relation, d.squared_distance, d.witness);
  if (d.relation == Proximity::touching) report.update(describe_contact(queries, d.feature));
  if (d.relation == Proximity::overlapping) {
    const ShortestPenetration shortest = queries.shortest_penetration(translation, hint, context);
    report["witness"] = {as_json(shortest.witness[0]), as_json(shortest.witness[1])};
    report["exact_witness"] = {as_exact_json(shortest.witness[0]), as_exact_json(shortest.witness[1])};
    report["squared_penetration"] = shortest.squared_depth.to_double();
    report["exact_squared_penetration"] = shortest.squared_depth.to_string();
    report["separation"] = as_json(shortest.separation);
    report["exact_separation"] = as_exact_json(shortest.separation);
  }
  if (direction) {
    const std::optional<Vector3> along = as_doubles(*direction);
    if (!along) throw InputError("--direction is no vector of doubles");
    const Rational depth = queries.penetration(translation, *along, hint).depth;
    report["directional_penetration"] = depth.to_double();
    report["exact_directional_penetration"] = depth.to_string();
  }
  return report;
}

int print(Json report, const std::vector<std::string>& warnings, const Options& options) {
  const std::string text = as_text(report);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace

int run_distance(const Options& options, const Context& context) {
  RationalPoint3 at{0, 0, 0};
  if (!options.translation.empty()) at = vector_of(parse_argument(options.translation, 3, "--translate"));
  std::optional<RationalPoint3> direction;
  if (!options.direction.empty()) direction = vector_of(parse_argument(options.direction, 3, "--direction", 0));
  if (options.path.empty() && !options.outputs.empty()) throw UsageError("distance draws a trail only of a --path");
  if (!options.path.empty() && (direction || !options.translation.empty())) {
    throw UsageError("--path names the places itself: it goes with neither --translate nor --direction");
  }
  std::vector<std::string> warnings;
  const ProximityOperand a = read_proximity_operand(options.inputs[0], options, warnings, context);
  const ProximityOperand b = read_proximity_operand(options.inputs[1], options, warnings, context);
  if (!options.path.empty()) return run_path(a, b, read_path(options), warnings, options, context);
  if (direction) require_convex(a, b);
  const std::optional<Vector3> translation = as_doubles(at);
  if (a.is_convex() && b.is_convex() && translation) {
    return print(convex_distance((*a.pieces)[0], (*b.pieces)[0], *translation, direction, context), warnings, options);
  }
  if (direction)
    throw InputError("--translate " + options.translation + " is no vector of doubles, as --direction needs");
  const SolidDistance d = SolidProximity(solid_of(a, context), solid_of(b, context), context).distance(at, context);
  return print(describe_distance(proximity_of(d.relation), d.squared_distance, d.witness), warnings, options);
}

int run_width(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const Polytope p =
      polytope_of(read_polytope(options.inputs[0], options, warnings, context), options.inputs[0], context);
  const PolytopeWidth w = polytope_width(p, context);
  const PolytopeDiameter diameter = polytope_diameter(p, context);
  const auto points_of = [&](std::span<const std::uint32_t> vertices) {
    Json points = Json::array();
    for (const std::uint32_t v : vertices) points.push_back({p.vertex(v).x, p.vertex(v).y, p.vertex(v).z});
    return points;
  };
  return print({{"width", std::sqrt(w.squared_width.to_double())},
                {"squared_width", w.squared_width.to_double()},
                {"exact_squared_width", w.squared_width.to_string()},
                {"direction", as_json(w.direction)},
                {"exact_direction", as_exact_json(w.direction)},
                {"witness", {points_of(w.faces[0]), points_of(w.faces[1])}},
                {"diameter", std::sqrt(diameter.squared_diameter.to_double())},
                {"exact_squared_diameter", diameter.squared_diameter.to_string()},
                {"diameter_witness", points_of(diameter.vertices)}},
               warnings, options);
}

}  // namespace quoin::cli
