// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/solid/brep.h"

namespace quoin::overlay {

/// Drops every vertex at which, over the whole boundary, just two edges meet that lie on one line. Point ids are those
/// of `table`. `is_corner`, per point: a corner of a triangle that is not among the faces; such a vertex stays.
/// O(loops of the faces and points of the table).
void dissolve_vertices(const Constructions& table, const std::vector<std::uint8_t>& is_corner, Brep& faces);

}  // namespace quoin::overlay
