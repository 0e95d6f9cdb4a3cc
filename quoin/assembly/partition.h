// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "quoin/assembly/motion_space.h"
#include "quoin/assembly/pair_regions.h"
#include "quoin/assembly/part.h"
#include "quoin/base/context.h"

namespace quoin {

/// A way to take an assembly apart in two: in all directions of a cell these sets can move, the others staying.
struct Solution {
  MotionCell cell;
  SphereDirection direction;     ///< one of the cell, primitive
  std::vector<PartSet> movable;  ///< see BlockingGraph::movable_sets: all others are unions of these
};

/// What a search is about to cost.
struct MotionEstimate {
  std::size_t regions = 0;  ///< distinct ones
  std::size_t arcs = 0;     ///< of their boundaries
  double crossings = 0;     ///< expected, by trying some pairs of arcs
  double seconds = 0;       ///< expected, on a machine of 2020
  double bytes = 0;         ///< expected
};

struct PartitionOptions {
  MotionKind kind = MotionKind::infinite;
  /// Movable sets kept, of whole cells; of cells beyond only the number is found.
  std::size_t max_solutions = 100'000;
  /// Leaves out first where nothing can move (triangle_search.h): `cells` then counts only what had to be overlaid.
  /// Solutions are the same. Of infinite motion.
  bool prune = false;
  /// Called before the overlay of all regions, which may be large; may throw to stop.
  std::function<void(const MotionEstimate&)> announce{};
  /// Movable sets that count; empty: all do. Cells that have no other are no solutions.
  std::function<bool(const PartSet&)> counts{};
};

/// All directions in which an assembly can be taken apart by one translation.
struct Partition {
  MotionCounts cells;
  std::size_t solution_cells = 0;   ///< cells with solutions
  std::size_t solution_count = 0;   ///< movable sets of those kept
  bool has_all = true;              ///< none was left out
  std::vector<Solution> solutions;  ///< vertices first, then edges, then faces, by number; see max_solutions
  bool is_interlocked() const { return solution_cells == 0; }
};

/// By the overlay of the regions: a cell is a solution if its graph is not strongly connected; a solution at a single
/// direction is one too. Exact. O((n + k) log n + c p^2 / 64) for n arcs, k crossings, c cells and p parts.
/// Source: Fogel 2009, section 5.3. @throws Cancelled
Partition partition(const MotionSpace& space, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context);

/// The same from pairs, with the overlay. @throws Cancelled
Partition partition(const PairRegions& pairs, const PartitionOptions& options, PhaseTimes& times,
                    const Context& context);

MotionEstimate estimate(std::span<const RegionGroup> groups);

}  // namespace quoin
