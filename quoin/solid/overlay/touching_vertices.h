// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/solid/overlay/emission.h"

namespace quoin::overlay {

/// Gives each composed face a loop of one vertex for each of its inner vertices that is a vertex of other faces, which
/// touch it there from one side.
///
/// `is_corner`, per point: a corner of a tile that is a face of its own; the vertices of composed faces are added.
/// O(loops and inner vertices).
void add_touching_vertices(FaceParts& parts, std::vector<std::uint8_t>& is_corner);

}  // namespace quoin::overlay
