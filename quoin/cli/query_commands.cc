// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/summary.h"
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
Json describe(const Location& location, const Brep& b) {
  Json json;
  json["place"] = name_of(location.place);
  if (location.face != Location::no_face) {
    json["face"] = location.face;
    const Origin& origin = b.origins[b.face_first_origin[location.face]];
    json["origin"] = {{"input", origin.leaf}, {"face", origin.face}};
  }
  if (location.place == Place::on_vertex) json["vertex"] = rounded(b.points.exact(location.a));
  if (location.place == Place::on_edge)
    json["edge"] = {rounded(b.points.exact(location.a)), rounded(b.points.exact(location.b))};
  return json;
}

std::vector<std::string> point_texts(const Options& options) {
  std::vector<std::string> texts = options.points;
  if (options.points_file.empty()) return texts;
  std::ifstream file;
  if (options.points_file != "-") {
    file.open(options.points_file);
    if (!file) throw FileError(options.points_file + ": cannot be opened");
  }
  std::istream& in = options.points_file == "-" ? std::cin : file;
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#') texts.push_back(line);
  }
  if (in.bad()) throw FileError(options.points_file + ": cannot be read");
  return texts;
}

Json classify_points(const PointLocator& locator, const Options& options, const Context& context) {
  Json all = Json::array();
  for (const std::string& text : point_texts(options)) {
    context.poll();
    const RationalPoint3 point = point_of(parse_coordinates(text, 3, "point"));
    Json one;
    one["point"] = rounded(point);
    one.update(describe(locator.locate(point), locator.boundary()));
    if (!options.json) std::cout << text << ": " << one["place"].get<std::string>() << "\n";
    all.push_back(std::move(one));
  }
  return all;
}

Json classify_lines(const PointLocator& locator, const Options& options, const Context& context) {
  Json all = Json::array();
  for (const std::string& text : options.lines) {
    const std::vector<Rational> numbers = parse_coordinates(text, 6, "line");
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
    for (const Location& piece : cut.pieces) pieces.push_back(name_of(piece.place));
    if (!options.json) {
      std::cout << text << ": " << name_of(cut.pieces[0].place);
      for (std::size_t i = 0; i < cut.events.size(); ++i) {
        std::cout << " | t = " << cut.events[i].parameter.to_double() << " " << name_of(cut.events[i].location.place)
                  << " | " << name_of(cut.pieces[i + 1].place);
      }
      std::cout << "\n";
    }
    all.push_back({{"line", text}, {"events", std::move(events)}, {"pieces", std::move(pieces)}});
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

void draw(const std::string& name, const Section& s, const SectionPlane& plane, Json& json) {
  SvgReport report;
  if (name == "-") {
    report = write_svg(std::cout, s, plane);
  } else {
    if (!name.ends_with(".svg")) throw InputError(name + ": sections are written as .svg");
    std::ofstream file(name);
    if (!file) throw FileError(name + ": cannot be opened for writing");
    report = write_svg(file, s, plane);
    if (!file.flush()) throw FileError(name + ": cannot be written");
  }
  json["max_displacement"] = report.largest_rounding;
}

}  // namespace

int run_classify(const Options& options, const Context& context) {
  if (options.points.empty() && options.points_file.empty() && options.lines.empty())
    throw InputError("classify needs --point, --points or --line");
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  const PointLocator locator(*boundary, context);
  Json json;
  json["file"] = options.inputs[0];
  json["points"] = classify_points(locator, options, context);
  json["lines"] = classify_lines(locator, options, context);
  json["warnings"] = warnings;
  if (options.json) std::cout << json.dump(2) << "\n";
  if (!options.json) print_warnings(warnings, options);
  return 0;
}

int run_section(const Options& options, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Rational> numbers = parse_coordinates(options.plane, 4, "--plane");
  const SectionPlane plane{point_of(numbers), numbers[3]};
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  const Section found = section(*boundary, plane, context);
  const RationalPoint3 v = area_vector(found);
  const double area = std::hypot(v.x.to_double(), v.y.to_double(), v.z.to_double());
  Json json;
  json["file"] = options.inputs[0];
  json["plane"] = options.plane;
  json.update(describe(found, area));
  json["outputs"] = options.outputs;
  bool uses_stdout = false;
  for (const std::string& output : options.outputs) {
    uses_stdout = uses_stdout || output == "-";
    draw(output, found, plane, json);
  }
  json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  json["threads"] = context.threads();
  json["warnings"] = warnings;
  std::ostream& out = uses_stdout ? std::cerr : std::cout;
  if (options.json) {
    out << json.dump(2) << "\n";
  } else if (!options.quiet) {
    out << as_text({{"area", area}, {"loops", found.loops.size()}, {"corners", found.points.size()}});
    print_warnings(warnings, options);
  }
  return 0;
}

int run_interfere(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  std::vector<Solid> solids;
  for (const std::string& name : options.inputs) {
    const Solid operand = load_operand(name, options, warnings, context);
    solids.push_back(Solid::evaluate(Expression::leaf(0), {&operand, 1}, context));
  }
  Json pairs = Json::array();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      const InterferenceReport report = interference(solids[i], solids[j], context);
      Json pair;
      pair["a"] = options.inputs[i];
      pair["b"] = options.inputs[j];
      pair["interference"] = name_of(report.kind);
      pair["common_volume"] = rounded_volume(report.common.boundary(), context);
      if (!options.json)
        std::cout << options.inputs[i] << " " << options.inputs[j] << ": " << name_of(report.kind) << "\n";
      pairs.push_back(std::move(pair));
    }
  }
  if (options.json) {
    std::cout << Json{{"pairs", std::move(pairs)}, {"warnings", warnings}}.dump(2) << "\n";
  } else {
    print_warnings(warnings, options);
  }
  return 0;
}

}  // namespace quoin::cli
