// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// The keys of a report that tell how many cells of each kind a polytope has.
nlohmann::ordered_json cell_counts(std::size_t vertices, std::size_t edges, std::size_t facets);

/// What bounds no solid is reported, and nothing else. `what` lies in one place, line or plane.
/// @throws InputError where an output was to be written
int report_flat(int dimension, const std::string& what, nlohmann::ordered_json details,
                std::vector<std::string> warnings, const Options& options);

}  // namespace quoin::cli
