// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/partition.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "quoin/assembly/stopwatch.h"
#include "quoin/assembly/triangle_search.h"

namespace quoin {

namespace {

constexpr std::size_t most_triangles = 1024;

/// Of the cells whose directions count, or of all.
Partition solve(const MotionSpace& space, const PartitionOptions& options, const UnsettledDirections* within,
                PhaseTimes& times, const Context& context) {
  Stopwatch watch;
  Partition result;
  result.cells = space.counts();
  PartSet everything;
  space.walk(
      [&](MotionCell cell, const BlockingGraph& graph) {
        if (everything.words().empty()) everything = PartSet::all(graph.part_count());
        if (graph.is_strongly_connected(everything)) return;
        if (within != nullptr && !within->contain(space.direction_in(cell))) return;
        if (!result.has_all && !options.counts) {
          ++result.solution_cells;
          return;
        }
        std::vector<PartSet> movable = graph.movable_sets(everything);
        if (options.counts) std::erase_if(movable, [&](const PartSet& set) { return !options.counts(set); });
        if (movable.empty()) return;
        ++result.solution_cells;
        if (!result.has_all) return;
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

/// A cell of the overlay of mixed pairs alone that is a solution inside the unsettled triangles is a cell of the whole
/// motion space: at their border all parts are held together, so it does not reach it, and no other curve is inside.
/// What lies elsewhere does not count.
Partition partition_unsettled(const PairRegions& pairs, const PartitionOptions& options, PhaseTimes& times,
                              const Context& context) {
  const UnsettledDirections unsettled = find_unsettled(pairs, most_triangles, context);
  if (unsettled.triangles.empty()) return {};
  const std::size_t n = pairs.part_count;
  const auto state = [&](std::uint32_t i, std::uint32_t j) { return unsettled.states[i * n + j]; };
  const std::vector<RegionGroup> groups =
      unite_pairs(pairs, MotionKind::infinite, times, context,
                  [&](std::uint32_t i, std::uint32_t j) { return state(i, j) == PairState::mixed; });
  MotionSpace::Arcs fixed;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      if (state(i, j) == PairState::always_blocked) fixed.push_back({i, j});
    }
  }
  if (options.announce) options.announce(estimate(groups));
  Stopwatch watch;
  const MotionSpace space(n, groups, context, std::move(fixed));
  times.motion_space += watch.lap();
  return solve(space, options, &unsettled, times, context);
}

}  // namespace

Partition partition(const MotionSpace& space, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context) {
  return solve(space, options, nullptr, times, context);
}

Partition partition(const PairRegions& pairs, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context) {
  if (options.prune && options.kind == MotionKind::infinite) return partition_unsettled(pairs, options, times, context);
  const std::vector<RegionGroup> groups = unite_pairs(pairs, options.kind, times, context);
  if (options.announce) options.announce(estimate(groups));
  Stopwatch watch;
  const MotionSpace space(pairs.part_count, groups, context);
  times.motion_space += watch.lap();
  return partition(space, options, times, context);
}

}  // namespace quoin
