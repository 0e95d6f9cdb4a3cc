// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <sstream>

#include "quoin/cli/commands.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/point_queries.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/io/svg.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/query/interference.h"
#include "quoin/solid/query/line_classification.h"
#include "quoin/solid/query/section.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Place place) {
  switch (place) {
    case Place::in:
      return "in";
    case Place::on_face:
      return "on face";
    case Place::on_edge:
      return "on edge";
    case Place::on_vertex:
      return "on vertex";
    case Place::out:
      break;
  }
  return "out";
}

const char* name_of(Interference kind) {
  switch (kind) {
    case Interference::overlapping:
      return "overlapping";
    case Interference::touching:
      return "touching";
    case Interference::apart:
      break;
  }
  return "apart";
}

Json rounded(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

RationalPoint3 point_of(const std::vector<Rational>& numbers, std::size_t first = 0) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

// The nearest doubles of a vertex stand for its exact place.
Json describe(const SolidLocation& location, const Brep& b) {
  Json json;
  json["place"] = name_of(location.place);
  if (location.face != SolidLocation::no_face) {
    json["face"] = location.face;
    const Origin& origin = b.origins[b.face_first_origin[location.face]];
    json["origin"] = {{"input", origin.leaf}, {"face", origin.face}};
  }
  if (location.place == Place::on_vertex) json["vertex"] = rounded(b.points.exact(location.a));
  if (location.place == Place::on_edge)
    json["edge"] = {rounded(b.points.exact(location.a)), rounded(b.points.exact(location.b))};
  return json;
}

std::vector<Query> line_queries(const Options& options) {
  std::vector<Query> queries;
  for (const std::string& text : options.lines) queries.push_back({text, parse_argument(text, 6, "--line", 3)});
  return queries;
}

Json classify_points(const SolidLocator& locator, const std::vector<Query>& queries, std::string& report,
                     const Context& context) {
  Json all = Json::array();
  for (const Query& query : queries) {
    context.poll();
    const RationalPoint3 point = point_of(query.numbers);
    Json one;
    one["point"] = rounded(point);
    one.update(describe(locator.locate(point), locator.boundary()));
    report += query.text + ": " + one["place"].get<std::string>() + "\n";
    all.push_back(std::move(one));
  }
  return all;
}

std::string text_of(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

Json classify_lines(const SolidLocator& locator, const std::vector<Query>& queries, std::string& report,
                    const Context& context) {
  Json all = Json::array();
  for (const Query& query : queries) {
    const std::vector<Rational>& numbers = query.numbers;
    const LineClassification cut = classify_line(locator, {point_of(numbers), point_of(numbers, 3)}, context);
    Json events = Json::array();
    for (const LineEvent& e : cut.events) {
      Json event;
      event["parameter"] = e.parameter.to_double();
      event["exact_parameter"] = e.parameter.to_string();
      event["point"] = rounded(e.point);
      event.update(describe(e.location, locator.boundary()));
      events.push_back(std::move(event));
    }
    Json pieces = Json::array();
    for (const SolidLocation& piece : cut.pieces) pieces.push_back(name_of(piece.place));
    report += query.text + ": " + name_of(cut.pieces[0].place);
    for (std::size_t i = 0; i < cut.events.size(); ++i) {
      report += " | t = " + text_of(cut.events[i].parameter.to_double()) + " " + name_of(cut.events[i].location.place) +
                " | " + name_of(cut.pieces[i + 1].place);
    }
    report += "\n";
    all.push_back({{"line", query.text}, {"events", std::move(events)}, {"pieces", std::move(pieces)}});
  }
  return all;
}

Json describe(const Section& s, double area) {
  Json json;
  json["area"] = area;
  json["unbounded"] = s.is_unbounded;
  Json loops = Json::array();
  Json exact = Json::array();
  for (const auto& loop : s.loops) {
    Json points = Json::array();
    Json exact_points = Json::array();
    for (const std::uint32_t p : loop) {
      points.push_back(rounded(s.points[p]));
      exact_points.push_back({s.points[p].x.to_string(), s.points[p].y.to_string(), s.points[p].z.to_string()});
    }
    loops.push_back(std::move(points));
    exact.push_back(std::move(exact_points));
  }
  json["loops"] = std::move(loops);
  json["exact_loops"] = std::move(exact);
  return json;
}

// What a section is, in a few numbers.
Json summarize(const Section& s, double area) {
  return {{"area", area}, {"loops", s.loops.size()}, {"corners", s.points.size()}, {"unbounded", s.is_unbounded}};
}

// Returns how far the drawing is from the section.
double draw(const Target& target, const Section& s, const SectionPlane& plane) {
  SvgReport report;
  write_target(target, [&](std::ostream& out) { report = write_svg(out, s, plane); });
  return report.largest_rounding;
}

// Prints the report of a query: its JSON or its text.
void print_answer(Json json, const std::string& text, const std::vector<std::string>& warnings,
                  const Options& options) {
  if (options.json) {
    json["warnings"] = warnings;
    print_json(json, options);
    return;
  }
  if (!options.quiet) report_stream(options) << text;
  print_warnings(warnings, options);
}

}  // namespace

int run_classify(const Options& options, const Context& context) {
  if (options.points.empty() && options.points_file.empty() && options.lines.empty())
    throw UsageError("classify needs --point, --points or --line");
  const std::vector<Query> lines = line_queries(options);
  const std::vector<Query> points = point_queries(options, 3);
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  const SolidLocator locator(*boundary, context);
  std::string report;
  Json json;
  json["file"] = options.inputs[0];
  json["points"] = classify_points(locator, points, report, context);
  json["lines"] = classify_lines(locator, lines, report, context);
  print_answer(std::move(json), report, warnings, options);
  return 0;
}

int run_section(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  const std::vector<Rational> numbers = parse_argument(options.plane, 4, "--plane", 0);
  const SectionPlane plane{point_of(numbers), numbers[3]};
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  const Section found = section(*boundary, plane, context);
  const RationalPoint3 v = area_vector(found);
  const double area = std::hypot(v.x.to_double(), v.y.to_double(), v.z.to_double());
  double displacement = 0;
  for (const Target& target : targets_of(options)) displacement = std::max(displacement, draw(target, found, plane));
  Json json;
  json["file"] = options.inputs[0];
  json["plane"] = options.plane;
  json.update(describe(found, area));
  json["outputs"] = options.outputs;
  json["rounding"] = displacement == 0 ? "exact" : "accepted";
  json["max_displacement"] = displacement;
  json["seconds"] = seconds_since(start);
  json["threads"] = context.threads();
  json["result"] = summarize(found, area);
  const std::string text = as_text({{"area", area}, {"loops", found.loops.size()}, {"corners", found.points.size()}});
  print_answer(std::move(json), text, warnings, options);
  return 0;
}

int run_interfere(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  std::vector<Solid> solids;
  for (const Solid& operand : load_operands(options.inputs, options, warnings, context))
    solids.push_back(Solid::evaluate(Expression::leaf(0), {&operand, 1}, context));
  std::string text;
  Json pairs = Json::array();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      const InterferenceReport report = interference(solids[i], solids[j], context);
      Json pair;
      pair["a"] = options.inputs[i];
      pair["b"] = options.inputs[j];
      pair["interference"] = name_of(report.kind);
      pair["common_volume"] = rounded_volume(report.common.boundary(), context);
      text += options.inputs[i] + " " + options.inputs[j] + ": " + name_of(report.kind) + "\n";
      pairs.push_back(std::move(pair));
    }
  }
  print_answer({{"pairs", std::move(pairs)}}, text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
