// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/partition.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "quoin/assembly/stopwatch.h"

namespace quoin {

Partition partition(const MotionSpace& space, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context) {
  Stopwatch watch;
  Partition result;
  result.cells = space.counts();
  PartSet everything;
  space.walk(
      [&](MotionCell cell, const BlockingGraph& graph) {
        if (everything.words().empty()) everything = PartSet::all(graph.part_count());
        if (graph.is_strongly_connected(everything)) return;
        ++result.solution_cells;
        if (!result.has_all) return;
        std::vector<PartSet> movable = graph.movable_sets(everything);
        result.has_all = result.solution_count + movable.size() <= options.max_solutions;
        if (!result.has_all) return;
        result.solution_count += movable.size();
        result.solutions.push_back({cell, space.direction_in(cell), std::move(movable)});
      },
      context);
  std::ranges::sort(result.solutions, [](const Solution& a, const Solution& b) {
    return std::tie(a.cell.kind, a.cell.id) < std::tie(b.cell.kind, b.cell.id);
  });
  times.processing += watch.lap();
  return result;
}

Partition partition(const PairRegions& pairs, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context) {
  const std::vector<RegionGroup> groups = unite_pairs(pairs, options.kind, times, context);
  if (options.announce) options.announce(estimate(groups));
  Stopwatch watch;
  const MotionSpace space(pairs.part_count, groups, context);
  times.motion_space += watch.lap();
  return partition(space, options, times, context);
}

}  // namespace quoin
