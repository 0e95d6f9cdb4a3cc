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
#include "quoin/polytope/smallest_ball.h"
#include "quoin/polytope/solid_penetration.h"
#include "quoin/solid/query/distance.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

RationalPoint3 vector_of(const std::vector<Rational>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Polytope translated(const Polytope& p, const RationalPoint3& by, const Context& context) {
  std::vector<RationalPoint3> moved;
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) moved.push_back(p.exact_vertex(v) + by);
  return Polytope::hull_of(moved, context);
}

SmallestBall ball_of(const Polytope& p, const Context& context) {
  std::vector<RationalPoint3> vertices;
  vertices.reserve(p.vertex_count());
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) vertices.push_back(p.exact_vertex(v));
  return smallest_ball(vertices, context);
}

/// Walks take one solid at least.
bool are_for_queries(const Polytope& a, const Polytope& b) {
  return a.dimension() == 3 || b.dimension() == 3;
}

void add_penetration(Json& report, const Rational& squared_depth, const RationalPoint3& separation) {
  report["squared_penetration"] = squared_depth.to_double();
  report["exact_squared_penetration"] = squared_depth.to_string();
  report["separation"] = as_json(separation);
  report["exact_separation"] = as_exact_json(separation);
}

void add_directional(Json& report, const Rational& depth) {
  report["directional_penetration"] = depth.to_double();
  report["exact_directional_penetration"] = depth.to_string();
}

/// Of polytopes of any dimension, in any place.
Json polytopes_distance(const Polytope& a, const Polytope& b, const RationalPoint3& at, const Context& context) {
  const PolytopeDistance d = polytope_distance(translated(a, at, context), b, context);
  Json report = describe_distance(d.relation, d.squared_distance, d.witness);
  if (d.relation == Proximity::overlapping) add_penetration(report, d.squared_penetration, d.separation);
  return report;
}

/// Of any solids. How deep they overlap takes their sum.
Json solids_distance(const Solid& a, const Solid& b, const RationalPoint3& at,
                     const std::optional<RationalPoint3>& direction, const Context& context) {
  const SolidDistance d = SolidProximity(a, b, context).distance(at, context);
  Json report = describe_distance(proximity_of(d.relation), d.squared_distance, d.witness);
  const bool overlap = d.relation == Interference::overlapping;
  const bool are_bounded = !a.boundary().is_unbounded && !b.boundary().is_unbounded;
  if (direction && !are_bounded) throw InputError("--direction needs bounded solids");
  if (direction && !overlap) add_directional(report, Rational(0));
  if (!overlap || !are_bounded) return report;
  const SolidPenetration penetration(a, b, context);
  if (const auto shortest = penetration.shortest(at, context))
    add_penetration(report, shortest->squared_depth, shortest->separation);
  if (direction) add_directional(report, penetration.along(at, *direction, context));
  return report;
}

Json convex_distance(const Polytope& a, const Polytope& b, const Vector3& translation,
                     const std::optional<Vector3>& direction, const Context& context) {
  const ProximityQueries queries(a, b, context);
  ProximityHint hint;
  const TranslationDistance d = queries.distance(translation, hint);
  Json report = describe_distance(d.relation, d.squared_distance, d.witness);
  if (d.relation == Proximity::touching) report.update(describe_contact(queries, d.feature));
  if (d.relation == Proximity::overlapping) {
    const ShortestPenetration shortest = queries.shortest_penetration(translation, hint, context);
    report["witness"] = {as_json(shortest.witness[0]), as_json(shortest.witness[1])};
    report["exact_witness"] = {as_exact_json(shortest.witness[0]), as_exact_json(shortest.witness[1])};
    add_penetration(report, shortest.squared_depth, shortest.separation);
  }
  if (direction) add_directional(report, queries.penetration(translation, *direction, hint).depth);
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
  const std::optional<Vector3> translation = as_doubles(at);
  const std::optional<Vector3> along = direction ? as_doubles(*direction) : std::nullopt;
  if (a.is_convex() && b.is_convex()) {
    const Polytope& p = (*a.pieces)[0];
    const Polytope& q = (*b.pieces)[0];
    if (translation && along.has_value() == direction.has_value() && are_for_queries(p, q))
      return print(convex_distance(p, q, *translation, along, context), warnings, options);
    if (!direction) return print(polytopes_distance(p, q, at, context), warnings, options);
  }
  return print(solids_distance(solid_of(a, context), solid_of(b, context), at, direction, context), warnings, options);
}

int run_width(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const Polytope p = read_polytope(options.inputs[0], options, warnings, context);
  const PolytopeWidth w = polytope_width(p, context);
  const PolytopeDiameter diameter = polytope_diameter(p, context);
  const auto points_of = [&](std::span<const std::uint32_t> vertices) {
    Json points = Json::array();
    for (const std::uint32_t v : vertices) points.push_back({p.vertex(v).x, p.vertex(v).y, p.vertex(v).z});
    return points;
  };
  const SmallestBall ball = ball_of(p, context);
  Json report{{"width", std::sqrt(w.squared_width.to_double())},
              {"squared_width", w.squared_width.to_double()},
              {"exact_squared_width", w.squared_width.to_string()},
              {"direction", as_json(w.direction)},
              {"exact_direction", as_exact_json(w.direction)},
              {"witness", {points_of(w.faces[0]), points_of(w.faces[1])}},
              {"diameter", std::sqrt(diameter.squared_diameter.to_double())},
              {"exact_squared_diameter", diameter.squared_diameter.to_string()},
              {"diameter_witness", points_of(diameter.vertices)}};
  report["ball"] = {{"radius", std::sqrt(ball.squared_radius.to_double())},
                    {"squared_radius", ball.squared_radius.to_double()},
                    {"exact_squared_radius", ball.squared_radius.to_string()},
                    {"center", as_json(ball.center)},
                    {"exact_center", as_exact_json(ball.center)},
                    {"witness", points_of(ball.support)}};
  return print(std::move(report), warnings, options);
}

}  // namespace quoin::cli
