// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"

namespace quoin::cli {

/// The summary of a solid: vertices, edges, faces, triangles, shells, voids, components, closed, manifold, volume,
/// exact_volume (when short), area, bounds, origins. Keys are documented in docs/command.md and stable.
nlohmann::ordered_json summarize(const Brep& boundary, const Context& context);

/// The same as lines for people.
std::string as_text(const nlohmann::ordered_json& summary);

}  // namespace quoin::cli
