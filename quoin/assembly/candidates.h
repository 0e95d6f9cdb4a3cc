// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quoin/assembly/blocking_graph.h"
#include "quoin/assembly/motion_space.h"
#include "quoin/assembly/pair_regions.h"

namespace quoin {

/// A direction to try, and what stops what in it.
struct Candidate {
  SphereDirection direction;
  BlockingGraph graph;
};

/// Directions to try, simplest first: smaller integers, then in lexicographic order.
struct Candidates {
  std::vector<Candidate> list;
  bool are_all = false;  ///< whatever can move in some direction can move in one of these
};

/// Who stops whom among some parts in one direction, by trying each pair. Exact, O(pieces of pairs).
BlockingGraph blocking_graph(const PairRegions& pairs, const RegionDirection& direction, const PartSet& within);

/// By trying each pair. O(directions * pieces of pairs). @throws Cancelled
Candidates candidates_in(const PairRegions& pairs, std::vector<SphereDirection> directions, const Context& context);

/// Boundaries of what is blocked between parts that touch, and the axes; at most `most`, the simplest. @throws
/// Cancelled
Candidates contact_candidates(const PairRegions& pairs, std::size_t most, const Context& context);

/// One for each distinct graph of a vertex, or of an edge or face that has none: all there are. At most `most` graphs;
/// of more, nothing. @throws Cancelled
Candidates vertex_candidates(const MotionSpace& space, std::size_t most, const Context& context);

}  // namespace quoin
