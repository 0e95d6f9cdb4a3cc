// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/planar.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/io/drawing_curves.h"

namespace quoin::cli {

namespace {

/// Whether an argument is a geometry itself: a word of WKT, then a parenthesis or EMPTY.
bool is_wkt(const std::string& text) {
  constexpr std::array words{"point",        "multipoint",         "linestring",    "multilinestring", "polygon",
                             "multipolygon", "circularstring",     "compoundcurve", "curvepolygon",    "multicurve",
                             "multisurface", "geometrycollection", "srid"};
  std::size_t end = 0;
  while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
  const std::string word = in_small_letters(text.substr(0, end));
  if (std::find(words.begin(), words.end(), word) == words.end()) return false;
  const std::string rest = in_small_letters(text.substr(end));
  return rest.find('(') != std::string::npos || rest.find("empty") != std::string::npos;
}

Drawing read_one(const std::string& input, const Context& context) {
  DrawingReadOptions options;
  if (input == standard_stream) return read_drawing(read_all(input), shown(input), options, context);
  if (!std::filesystem::exists(input) && is_wkt(input)) {
    options.format = DrawingFormat::wkt;
    return read_drawing(input, "WKT argument", options, context);
  }
  return read_drawing(std::filesystem::path(input), options, context);
}

}  // namespace

std::vector<PlanarInput> read_drawings(const Options& options, std::vector<std::string>& warnings,
                                       const Context& context) {
  std::vector<PlanarInput> inputs;
  for (const std::string& input : options.inputs) {
    context.poll();
    PlanarInput read{shown(input), read_one(input, context)};
    for (const std::string& note : read.drawing.notes) warnings.push_back(read.name + ": " + note);
    inputs.push_back(std::move(read));
  }
  return inputs;
}

bool any_arcs(const std::vector<PlanarInput>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [](const PlanarInput& input) { return has_arcs(input.drawing); });
}

std::optional<FillRule> fill_rule(const Options& options) {
  if (options.fill.empty()) return std::nullopt;
  if (options.fill == "even-odd") return FillRule::even_odd;
  if (options.fill == "nonzero") return FillRule::nonzero;
  if (options.fill == "positive") return FillRule::positive;
  throw UsageError("--fill is even-odd, nonzero or positive");
}

void write_drawings(const Drawing& drawing, const Options& options, std::vector<std::string>& warnings,
                    const Context& context) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar) continue;
    DrawingWriteOptions how;
    how.flatten_tolerance = options.flatten;
    const std::vector<std::string> notes =
        target.is_stream() ? write_drawing(data_stream(), target.planar_format, drawing, how, context)
                           : write_drawing(target.name, target.planar_format, drawing, how, context);
    for (const std::string& note : notes) warnings.push_back(shown(target.name) + ": " + note);
  }
}

void print_report(nlohmann::ordered_json json, const std::string& text, const std::vector<std::string>& warnings,
                  const Options& options) {
  if (options.json) {
    json["warnings"] = warnings;
    print_json(json, options);
    return;
  }
  print_warnings(warnings, options);
  if (!options.quiet) report_stream(options) << text;
}

}  // namespace quoin::cli
