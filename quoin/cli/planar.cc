// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/planar.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/target_writing.h"
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

bool is_literal(const std::string& input) {
  std::error_code ignored;  // a text may be too long to be a name
  return input != standard_stream && is_wkt(input) && !std::filesystem::exists(input, ignored);
}

PlanarInput read_exact(const std::string& input, std::string_view text, const Context& context) {
  PlanarInput read{shown(input), {}, read_arrangement_text(text, shown(input), context)};
  if (std::holds_alternative<ArrangementText<GeodesicFamily>>(*read.exact)) {
    throw InputError(read.name + ": an arrangement on the sphere is none of the plane");
  }
  return read;
}

PlanarInput read_one(const std::string& input, std::size_t number, const Context& context) {
  DrawingReadOptions options;
  if (is_literal(input)) {
    options.format = DrawingFormat::wkt;
    const std::string name = "WKT argument " + std::to_string(number);
    return {name, read_drawing(input, name, options, context), {}};
  }
  const std::string text = read_all(input);
  if (ending_of(input) == ".qarr" || is_arrangement_text(text)) return read_exact(input, text, context);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return {shown(input), {}, {}};
  return {shown(input), read_drawing(text, shown(input), options, context), {}};
}

/// Every use of an edge by a curve is a piece of that curve.
template <class F>
void add_exact(F& family, PieceList<F>& list, const ArrangementText<F>& text, std::vector<std::string>& names) {
  const Arrangement<F>& a = text.arrangement;
  constexpr std::uint32_t most = std::uint32_t{1} << 24;
  if (text.names.empty() && a.curve_count() > most) throw InputError("it has too many curves without names");
  const auto shift = family.absorb(a.family());
  std::vector<std::uint32_t> points(a.vertex_count());
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    const dcel::VertexId id(v);
    if (!a.has_point(id)) continue;
    points[v] = list.add_point(F::shifted(a.point(id), shift));
    if (a.cells().is_isolated(id)) list.lone_points.push_back({points[v], CurveId(std::size_t{0})});
  }
  for (std::size_t e = 0; e < a.edge_count(); ++e) {
    const dcel::EdgeId id(e);
    if (!a.cells().is_real(id)) continue;
    for (const CurveUse use : a.curves(id)) {
      list.pieces.push_back({F::shifted(a.branch(id), shift), points[a.left(id).index()], points[a.right(id).index()],
                             CurveId(std::size_t{list.curve_count} + use.curve().index()), use.is_reversed()});
    }
  }
  for (std::uint32_t c = 0; c < a.curve_count(); ++c) {
    names.push_back(text.names.empty() ? "curve " + std::to_string(c) : text.names[c]);
  }
  list.curve_count += a.curve_count();
}

}  // namespace

std::vector<PlanarInput> read_drawings(const Options& options, std::vector<std::string>& warnings,
                                       const Context& context) {
  std::vector<PlanarInput> inputs;
  for (const std::string& input : options.inputs) {
    context.poll();
    PlanarInput read = read_one(input, inputs.size() + 1, context);
    for (const std::string& note : read.drawing.notes) warnings.push_back(read.name + ": " + note);
    if (!read.exact && read.drawing.elements.empty() && read.drawing.notes.empty())
      warnings.push_back(read.name + ": it is empty");
    inputs.push_back(std::move(read));
  }
  return inputs;
}

bool any_arcs(const std::vector<PlanarInput>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [](const PlanarInput& input) {
    return input.exact ? std::holds_alternative<ArrangementText<CircularFamily>>(*input.exact)
                       : has_arcs(input.drawing);
  });
}

std::string planar_title(const Options& options) {
  const std::string& first = options.inputs.front();
  if (is_literal(first)) return options.operation.empty() ? options.command : options.operation;
  return title_of(first);
}
template <class F>
void add_input(F& family, PieceList<F>& list, const PlanarInput& input, std::vector<std::string>& names) {
  if (!input.exact) return add_curves(family, list, input.drawing, names);
  const auto* text = std::get_if<ArrangementText<F>>(&*input.exact);
  if (text == nullptr) throw InputError("an exact text of lines does not go with arcs");
  add_exact(family, list, *text, names);
}
template void add_input(LinearFamily&, PieceList<LinearFamily>&, const PlanarInput&, std::vector<std::string>&);
template void add_input(CircularFamily&, PieceList<CircularFamily>&, const PlanarInput&, std::vector<std::string>&);

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
    how.as_one_geometry = true;
    std::vector<std::string> notes;
    write_target(target,
                 [&](std::ostream& out) { notes = write_drawing(out, target.planar_format, drawing, how, context); });
    const std::string prefix = (target.is_stream() ? "standard output" : target.name) + ": ";
    for (const std::string& note : notes) warnings.push_back(prefix + note);
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
