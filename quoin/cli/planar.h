// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/arrangement_text.h"
#include "quoin/io/drawing.h"

namespace quoin::cli {

/// A drawing, or an arrangement that an exact text holds, and what to call it.
struct PlanarInput {
  std::string name;
  Drawing drawing;
  std::optional<AnyArrangementText> exact{};
};

/// Reads drawings of the plane and exact texts (.qarr): files, "-" for standard input, or WKT as an argument itself.
/// Notes go to `warnings`. @throws InputError for an arrangement on the sphere
std::vector<PlanarInput> read_drawings(const Options& options, std::vector<std::string>& warnings,
                                       const Context& context);

/// Adds the curves of an input to a list, with their names. The edges of an exact text keep the curves they have.
/// @throws InputError  the input is of lines, exact, and the list is of circles and lines
template <class F>
void add_input(F& family, PieceList<F>& list, const PlanarInput& input, std::vector<std::string>& names);

/// Whether one of them has arcs, so that all are taken as circular curves.
bool any_arcs(const std::vector<PlanarInput>& inputs);

/// The title of what is made of the inputs: the stem of the first one's name.
std::string planar_title(const Options& options);

/// The rule of --fill; nothing where polygons must be valid. @throws UsageError
std::optional<FillRule> fill_rule(const Options& options);

/// Writes a drawing to the outputs that take one (wkt, geojson, svg, dxf); notes of the formats go to `warnings`.
/// Returns the outputs that are not drawings.
void write_drawings(const Drawing& drawing, const Options& options, std::vector<std::string>& warnings,
                    const Context& context);

/// Prints the report of a planar command: JSON with warnings, or text.
void print_report(nlohmann::ordered_json json, const std::string& text, const std::vector<std::string>& warnings,
                  const Options& options);

}  // namespace quoin::cli
