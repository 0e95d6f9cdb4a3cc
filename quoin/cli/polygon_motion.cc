// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/polygon_motion.h"

#include <array>
#include <sstream>

#include "quoin/arrangement/sets/planar_minkowski.h"
#include "quoin/arrangement/sets/planar_motion.h"
#include "quoin/arrangement/sets/planar_offset.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/planar_regions.h"
#include "quoin/cli/set_report.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Refuses the first element that has arcs.
void require_straight(std::span<const PlanarInput> inputs, const std::string& what) {
  for (const PlanarInput& input : inputs) {
    for (const DrawingElement& element : input.drawing.elements) {
      if (has_arcs({{element}, {}})) {
        throw InputError(input.name + ": " + element.name + " has arcs, and " + what + " are of straight edges");
      }
    }
  }
}

Regions<LinearFamily> read_straight_regions(const Options& options, const std::string& what,
                                            std::vector<std::string>& warnings, const Context& context) {
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  require_straight(inputs, what);
  return read_regions<LinearFamily>(inputs, fill_rule(options), warnings, context);
}

Json position_of(const LinearArrangement& arrangement, dcel::VertexId v) {
  const Point2 p = arrangement.family().position(arrangement.point(v));
  return {p.x, p.y};
}

/// Where the tight places are.
Json places_of_tight(const LinearPolygonSet& tight) {
  const LinearArrangement& arrangement = tight.arrangement();
  Json places{{"segments", Json::array()}, {"points", Json::array()}};
  std::vector<bool> has_edge(arrangement.vertex_count(), false);
  for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!arrangement.cells().is_real(e) || !tight.contains(e)) continue;
    has_edge[arrangement.left(e).index()] = has_edge[arrangement.right(e).index()] = true;
    places["segments"].push_back(
        {position_of(arrangement, arrangement.left(e)), position_of(arrangement, arrangement.right(e))});
  }
  for (std::size_t i = 0; i < arrangement.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!arrangement.cells().is_real(v) || has_edge[i] || !tight.contains(v)) continue;
    places["points"].push_back(position_of(arrangement, v));
  }
  return places;
}

}  // namespace

int run_minkowski(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const Regions<LinearFamily> regions = read_straight_regions(options, "Minkowski sums", warnings, context);
  LinearPolygonSet second = set_of_operand(regions, 1);
  if (options.reflect) second = reflected(second, context);
  PlanarMinkowskiOptions how;
  how.find_tight_passages = options.tight;
  const PlanarMinkowskiSum sum = minkowski_sum(set_of_operand(regions, 0), second, how, context);
  SetReport report{{{"operation", options.operation}, {"reflected", options.reflect}}, {}, warnings};
  describe_set(sum.sum, report);
  report.json["holes"] = sum.holes;
  report.json["new_holes"] = sum.new_holes;
  report.json["vanished_holes"] = sum.vanished_holes;
  report.text += ", " + std::to_string(sum.holes) + " holes (" + std::to_string(sum.new_holes) + " new, " +
                 std::to_string(sum.vanished_holes) + " vanished)";
  if (options.tight) {
    report.json["slits"] = sum.slits;
    report.json["isolated_points"] = sum.isolated_points;
    report.json["tight"] = places_of_tight(sum.tight);
    report.text +=
        ", " + std::to_string(sum.slits) + " slits, " + std::to_string(sum.isolated_points) + " isolated points";
    if (sum.slits + sum.isolated_points > 0)
      report.warnings.emplace_back("slits and isolated points are in the report and in pictures only");
  }
  write_set(sum.sum, report, options, context);
  if (options.tight) {
    write_sum_picture(sum.sum, sum.tight, options, context);
  } else {
    write_set_picture(sum.sum, options);
  }
  print_report(std::move(report.json), report.text + "\n", report.warnings, options);
  return 0;
}

int run_offset(const Options& options, const Context& context) {
  if (!options.distance) throw UsageError("polygon offset needs --distance");
  const Rational& distance = *options.distance;
  if (distance.sign() == Sign::zero) throw UsageError("--distance must not be zero");
  PlanarOffsetOptions how;
  if (options.precision) how.bound = *options.precision;
  std::vector<std::string> warnings;
  const Regions<LinearFamily> regions = read_straight_regions(options, "offsets", warnings, context);
  const LinearPolygonSet set = set_of_operand(regions, 0);
  const bool is_inset = distance.sign() == Sign::negative;
  const PlanarOffset made = is_inset ? inset(set, abs(distance), how, context) : offset(set, distance, how, context);
  const CircularPolygonSet& written = options.inner ? made.inner : made.outer;
  SetReport report{{{"operation", options.operation}, {"distance", distance.to_double()}}, {}, warnings};
  describe_set(written, report);
  report.json["written"] = options.inner ? "inner" : "outer";
  report.json["is_exact"] = made.is_exact;
  report.json["bound"] = made.bound.to_double();
  add_area(made.inner, report.json["inner"]);
  add_area(made.outer, report.json["outer"]);
  std::ostringstream text;
  if (made.is_exact) {
    text << ", exact";
  } else {
    text << ", the " << (options.inner ? "inner" : "outer") << " bound: the radius is off by at most "
         << made.bound.to_double();
  }
  report.text += text.str();
  write_set(written, report, options, context);
  write_set_picture(written, options);
  print_report(std::move(report.json), report.text + "\n", report.warnings, options);
  return 0;
}

}  // namespace quoin::cli
