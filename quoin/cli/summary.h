// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/leaf.h"

namespace quoin::cli {

/// The summary of a solid: vertices, edges, faces, triangles, shells, voids, components, closed, manifold, volume,
/// exact_volume (when short), area, bounds, inputs. Keys are documented in docs/command.md and stable.
nlohmann::ordered_json summarize(const Brep& boundary, const Context& context);

/// The nearest doubles of the centroid, or null where the volume is zero.
nlohmann::ordered_json summarize_centroid(const Brep& boundary, const Context& context);

/// The same keys for what bounds no solid, with null for what only a solid has.
nlohmann::ordered_json summarize_surface(const Brep& boundary, const Context& context);
nlohmann::ordered_json summarize_surface(const Mesh& mesh, const MeshDiagnosis& diagnosis);

/// The same as lines for people.
std::string as_text(const nlohmann::ordered_json& summary);

}  // namespace quoin::cli
