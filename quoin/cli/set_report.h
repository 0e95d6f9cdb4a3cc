// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/base/context.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

/// What a command says of a set that it made.
struct SetReport {
  nlohmann::ordered_json json;
  std::string text;
  std::vector<std::string> warnings;
};

/// Adds `area`, and `exact_area` where it is short, or a bound `area_error`.
void add_area(const LinearPolygonSet& set, nlohmann::ordered_json& json);
void add_area(const CircularPolygonSet& set, nlohmann::ordered_json& json);

/// Adds counts and the area to the report.
template <class F>
void describe_set(const PolygonSet<F>& set, SetReport& report);
extern template void describe_set(const LinearPolygonSet&, SetReport&);
extern template void describe_set(const CircularPolygonSet&, SetReport&);

/// Writes the set to the outputs that hold polygons (not to pictures); `rounding` and notes go to the report.
template <class F>
void write_set(const PolygonSet<F>& set, SetReport& report, const Options& options, const Context& context);
extern template void write_set(const LinearPolygonSet&, SetReport&, const Options&, const Context&);
extern template void write_set(const CircularPolygonSet&, SetReport&, const Options&, const Context&);

}  // namespace quoin::cli
