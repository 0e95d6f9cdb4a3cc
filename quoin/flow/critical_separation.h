// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_graph.h"
#include "quoin/flow/flow_reconstruction.h"

namespace quoin {

/// Which critical points are near the medial axis of the surface that the points sample; the others are near the
/// surface itself, as points are.
struct CriticalSeparation {
  std::vector<bool> edges;                ///< in the order of FlowCells::for_each_critical_edge
  std::vector<bool> saddles;              ///< of the graph
  std::vector<bool> maxima;               ///< of the graph
  std::array<std::size_t, 4> medial{};    ///< how many are, by index
  std::array<std::size_t, 4> disputed{};  ///< nearest points of how many do not agree
};

/// Separates critical points by the angle between the ways from a nearest point to the critical point and to the
/// point's pole: medial where it is below 45 degrees, or above 135. The majority of the nearest points decides, and
/// where there is none the point is of the surface. Exact. O(n). Of dense samples of a smooth surface nearest points
/// agree; edges and noise are not such. @throws Cancelled
/// Source: Dey, Giesen, Ramos and Sadri 2008.
CriticalSeparation separate(const FlowGraph& graph, const Context& context);

/// A solid between sheets of a surface.
struct SeparatedSolid {
  FlowSolid solid;
  std::size_t parts = 0;    ///< of space without the surface, the one at infinity among them
  std::size_t unclear = 0;  ///< saddles between parts that are on the same side: the surface is not sampled densely
};

/// The regions of maxima, joined through medial saddles; a maximum of the surface goes with what is behind its highest
/// saddle. What is an odd number of surfaces away from infinity is inside, so hollows of hollow solids are outside.
/// O(n). Source: Dey, Giesen, Ramos and Sadri 2008, who take what is not joined to infinity. @throws Cancelled
SeparatedSolid separated_solid(const FlowGraph& graph, const CriticalSeparation& separation, const Context& context);

}  // namespace quoin
