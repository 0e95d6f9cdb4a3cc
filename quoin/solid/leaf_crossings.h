// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/kernel/constructions.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// Sets `crosses_itself` and notes pairs of faces that meet outside their shared vertices and edges. `points` holds the
/// leaf's vertices. Exact; O(n log n + pairs of tiles whose boxes meet).
void find_self_crossings(Leaf& leaf, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
                         const Context& context);

/// Notes a face of each edge-connected component in front of which the winding number is not 0, or behind which it is
/// not 1. For leaves that do not cross themselves. `points` holds the leaf's vertices. O(n + log n per component).
void find_inverted_components(const std::shared_ptr<const Leaf>& leaf, Constructions points, std::size_t max_listed,
                              MeshDiagnosis& diagnosis, const Context& context);

}  // namespace quoin
