// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "quoin/kernel/constructions.h"

namespace quoin::overlay {

/// A directed boundary edge of a face, the face on its left.
struct DirectedEdge {
  PointId from;
  PointId to;
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

/// Chains the boundary edges of one face into loops that do not cross each other: where several edges leave a vertex, a
/// loop takes the first one clockwise from where it came.
///
/// `edges` must be sorted and balanced at every vertex. `axis` is one that the face's plane is not parallel to,
/// `positive` whether its outward normal points to the positive end. Appends the loops' vertices, and the offset behind
/// each loop.
void chain_loops(const Constructions& table, std::span<const DirectedEdge> edges, unsigned axis, bool positive,
                 std::vector<PointId>& vertices, std::vector<std::uint32_t>& loop_ends);

}  // namespace quoin::overlay
