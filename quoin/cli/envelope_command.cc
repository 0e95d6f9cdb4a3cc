// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/targets.h"
#include "quoin/io/drawing_curves.h"
#include "quoin/io/envelope_drawing.h"
#include "quoin/view/envelope_picture.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// The curves of all inputs and their envelope.
template <class F>
struct NamedEnvelope {
  F family;
  PieceList<F> list;
  std::vector<std::string> names;
  Envelope<F> envelope;
};

template <class F>
NamedEnvelope<F> find_envelope(std::span<const PlanarInput> inputs, const Options& options, const Context& context) {
  NamedEnvelope<F> made;
  for (const PlanarInput& input : inputs) {
    const std::size_t first = made.names.size();
    try {
      add_curves(made.family, made.list, input.drawing, made.names);
    } catch (const InputError& error) {
      throw InputError(input.name + ": " + error.what());
    }
    if (inputs.size() > 1) {
      for (std::size_t i = first; i < made.names.size(); ++i) made.names[i] = input.name + ": " + made.names[i];
    }
  }
  made.envelope =
      options.upper ? upper_envelope(made.family, made.list, context) : lower_envelope(made.family, made.list, context);
  return made;
}

Json as_json(const std::optional<Point2>& point) {
  return point ? Json{point->x, point->y} : Json();
}

/// Names of the curves of some members, each once.
template <class F>
Json curves_of(const NamedEnvelope<F>& made, typename Envelope<F>::Members members) {
  std::vector<CurveId> curves;
  for (const std::uint32_t member : members) curves.push_back(curve_of_member(made.list, member));
  std::ranges::sort(curves);
  curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  Json names = Json::array();
  for (const CurveId curve : curves) names.push_back(made.names[curve.index()]);
  return names;
}

template <class F>
Json report_of(const NamedEnvelope<F>& made, const Options& options) {
  const Envelope<F>& envelope = made.envelope;
  Json json{{"envelope", options.upper ? "upper" : "lower"},
            {"curves", made.names.size()},
            {"pieces", envelope.arc_count()},
            {"intervals", Json::array()},
            {"breakpoints", Json::array()}};
  for (std::size_t i = 0; i < envelope.interval_count(); ++i) {
    Json curves = curves_of(made, envelope.over(i));
    // A gap has no heights, so that its ends are the points next to it.
    std::optional<Point2> from = left_end(made.family, envelope, i);
    std::optional<Point2> to = right_end(made.family, envelope, i);
    if (envelope.is_gap(i) && i > 0) from = made.family.position(envelope.point(i - 1));
    if (envelope.is_gap(i) && i < envelope.breakpoint_count()) to = made.family.position(envelope.point(i));
    Json first = curves.empty() ? Json() : curves.front();
    json["intervals"].push_back(
        {{"from", as_json(from)}, {"to", as_json(to)}, {"curve", std::move(first)}, {"curves", std::move(curves)}});
  }
  for (std::size_t i = 0; i < envelope.breakpoint_count(); ++i) {
    json["breakpoints"].push_back(
        {{"point", as_json(made.family.position(envelope.point(i)))}, {"curves", curves_of(made, envelope.at(i))}});
  }
  return json;
}

template <class F>
std::string text_of(const NamedEnvelope<F>& made) {
  const Envelope<F>& envelope = made.envelope;
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < envelope.breakpoint_count(); ++i) gaps += envelope.is_gap(i) ? 1 : 0;
  std::ostringstream out;
  out << envelope.arc_count() << " pieces, " << envelope.breakpoint_count() << " breakpoints, " << gaps << " gaps\n";
  return out.str();
}

template <class F>
void write_envelope(const NamedEnvelope<F>& made, const Options& options, std::vector<std::string>& warnings,
                    const Context& context) {
  const std::vector<Target> targets = targets_of(options);
  if (targets.empty()) return;
  const auto is_drawing = [](const Target& target) { return target.kind == Target::Kind::planar; };
  if (std::ranges::any_of(targets, is_drawing)) {
    const Drawing drawing = draw_envelope(made.family, made.envelope);
    warnings.insert(warnings.end(), drawing.notes.begin(), drawing.notes.end());
    write_drawings(drawing, options, warnings, context);
  }
  if (std::ranges::all_of(targets, is_drawing)) return;
  EnvelopePictureOptions how;
  how.title = planar_title(options);
  how.curve_name = [&](CurveId curve) { return made.names[curve.index()]; };
  how.has_numbers = options.labels;
  write_picture(picture_of(made.family, made.list, made.envelope, how), options);
}

template <class F>
int envelope_with(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings, const Options& options,
                  const Context& context) {
  const NamedEnvelope<F> made = find_envelope<F>(inputs, options, context);
  Json json = options.json ? report_of(made, options) : Json();
  write_envelope(made, options, warnings, context);
  print_report(std::move(json), text_of(made), warnings, options);
  return 0;
}

}  // namespace

int run_envelope(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? envelope_with<CircularFamily>(inputs, warnings, options, context)
                          : envelope_with<LinearFamily>(inputs, warnings, options, context);
}

}  // namespace quoin::cli
