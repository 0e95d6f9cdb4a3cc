// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/assembly/partition.h"

namespace quoin {

/// A set that can start to move but not go on: in this direction these of its parts would meet these others.
struct StoppedMotion {
  std::size_t solution = 0;                         ///< index into InfinitesimalFreedom::partition.solutions
  std::size_t movable = 0;                          ///< index into its movable sets
  std::vector<std::array<std::uint32_t, 2>> stops;  ///< a part that moves, and the one it would meet; ascending
};

/// The cheaper question: in which directions a set of parts can begin to move at all.
struct InfinitesimalFreedom {
  Partition partition;
  std::vector<StoppedMotion> stopped;  ///< all solutions kept whose motion does not go on to infinity
};

/// Of translations, by the pieces that touch alone: where the origin lies on the boundary of a sum, what is in front of
/// its facets there. Sums that are apart from the origin do not matter, so that the regions are hemispheres, lunes and
/// cones. Exact. Whether a motion goes on is decided in the direction that stands for the cell.
/// @throws Cancelled
InfinitesimalFreedom infinitesimal_freedom(const PairRegions& pairs, PartitionOptions options, const Context& context);

/// What stops the set from leaving the others of `within` in a direction. O(pairs).
std::vector<std::array<std::uint32_t, 2>> stops_of(const PairRegions& pairs, const PartSet& moving,
                                                   const PartSet& within, const RegionDirection& direction);

}  // namespace quoin
