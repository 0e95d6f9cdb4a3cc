// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <span>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/polytope/proximity.h"
#include "quoin/polytope/smallest_ball.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Proximity relation) {
  switch (relation) {
    case Proximity::touching:
      return "touching";
    case Proximity::overlapping:
      return "overlapping";
    case Proximity::apart:
      break;
  }
  return "apart";
}

Json rounded(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}
Json exact(const RationalPoint3& p) {
  return {p.x.to_string(), p.y.to_string(), p.z.to_string()};
}

InputPoints translated(const InputPoints& points, const std::string& text) {
  const std::vector<Rational> by = parse_argument(text, 3, "--translate");
  std::vector<RationalPoint3> moved = as_rationals(points);
  for (RationalPoint3& p : moved) p = p + RationalPoint3{by[0], by[1], by[2]};
  return moved;
}

SmallestBall ball_of(const Polytope& p, const Context& context) {
  std::vector<Point3> vertices;
  vertices.reserve(p.vertex_count());
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) vertices.push_back(p.vertex(v));
  return smallest_ball(vertices, context);
}

int print(Json report, const std::vector<std::string>& warnings, const Options& options) {
  const std::string text = as_text(report);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace

int run_distance(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  InputPoints points = read_polytope(options.inputs[0], options, warnings, context);
  if (!options.translation.empty()) points = translated(points, options.translation);
  const Polytope a = polytope_of(points, options.inputs[0], context);
  const Polytope b =
      polytope_of(read_polytope(options.inputs[1], options, warnings, context), options.inputs[1], context);
  const PolytopeDistance d = polytope_distance(a, b, context);
  Json report{{"relation", name_of(d.relation)},
              {"squared_distance", d.squared_distance.to_double()},
              {"exact_squared_distance", d.squared_distance.to_string()},
              {"distance", std::sqrt(d.squared_distance.to_double())},
              {"witness", {rounded(d.witness[0]), rounded(d.witness[1])}},
              {"exact_witness", {exact(d.witness[0]), exact(d.witness[1])}}};
  if (d.relation == Proximity::overlapping) {
    report["squared_penetration"] = d.squared_penetration.to_double();
    report["exact_squared_penetration"] = d.squared_penetration.to_string();
    report["separation"] = rounded(d.separation);
    report["exact_separation"] = exact(d.separation);
  }
  return print(std::move(report), warnings, options);
}

int run_width(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const Polytope p =
      polytope_of(read_polytope(options.inputs[0], options, warnings, context), options.inputs[0], context);
  const PolytopeWidth w = polytope_width(p, context);
  const PolytopeDiameter diameter = polytope_diameter(p, context);
  const SmallestBall ball = ball_of(p, context);
  const auto points_of = [&](std::span<const std::uint32_t> vertices) {
    Json points = Json::array();
    for (const std::uint32_t v : vertices) points.push_back({p.vertex(v).x, p.vertex(v).y, p.vertex(v).z});
    return points;
  };
  return print({{"width", std::sqrt(w.squared_width.to_double())},
                {"squared_width", w.squared_width.to_double()},
                {"exact_squared_width", w.squared_width.to_string()},
                {"direction", rounded(w.direction)},
                {"exact_direction", exact(w.direction)},
                {"witness", {points_of(w.faces[0]), points_of(w.faces[1])}},
                {"diameter", std::sqrt(diameter.squared_diameter.to_double())},
                {"exact_squared_diameter", diameter.squared_diameter.to_string()},
                {"diameter_witness", points_of(diameter.vertices)},
                {"ball",
                 {{"radius", std::sqrt(ball.squared_radius.to_double())},
                  {"squared_radius", ball.squared_radius.to_double()},
                  {"exact_squared_radius", ball.squared_radius.to_string()},
                  {"center", rounded(ball.center)},
                  {"exact_center", exact(ball.center)},
                  {"witness", points_of(ball.support)}}}},
               warnings, options);
}

}  // namespace quoin::cli
