// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/infinitesimal.h"

#include <utility>

namespace quoin {

std::vector<std::array<std::uint32_t, 2>> stops_of(const PairRegions& pairs, const PartSet& moving,
                                                   const PartSet& within, const RegionDirection& direction) {
  std::vector<std::array<std::uint32_t, 2>> stops;
  const std::vector<std::uint32_t> others = within.without(moving).members();
  for (const std::uint32_t part : moving.members()) {
    for (const std::uint32_t other : others) {
      if (pairs.is_blocked(part, other, direction)) stops.push_back({part, other});
    }
  }
  return stops;
}

InfinitesimalFreedom infinitesimal_freedom(const PairRegions& pairs, PartitionOptions options, const Context& context) {
  options.kind = MotionKind::infinitesimal;
  InfinitesimalFreedom result;
  PhaseTimes times;
  result.partition = partition(pairs, options, times, context);
  const PartSet everything = PartSet::all(pairs.part_count);
  for (std::size_t s = 0; s < result.partition.solutions.size(); ++s) {
    context.poll();
    const Solution& solution = result.partition.solutions[s];
    for (std::size_t m = 0; m < solution.movable.size(); ++m) {
      auto stops = stops_of(pairs, solution.movable[m], everything, solution.direction);
      if (!stops.empty()) result.stopped.push_back({s, m, std::move(stops)});
    }
  }
  return result;
}

}  // namespace quoin
