// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "quoin/assembly/motion_space.h"
#include "quoin/assembly/pair_regions.h"
#include "quoin/assembly/partition.h"

namespace quoin {

struct DisassemblyOptions {
  std::vector<SphereDirection> directions;  ///< only these; empty: all there are
  bool one_part_at_a_time = false;
  std::optional<std::uint32_t> base;                      ///< a part that never moves
  std::size_t max_alternatives = 8;                       ///< moves kept for each subassembly
  std::size_t max_states = 512;                           ///< subassemblies looked at beside those of the sequence
  std::function<void(const MotionEstimate&)> announce{};  ///< see PartitionOptions
};

/// A subassembly splits: some of its parts move away, the rest stays.
struct DisassemblyMove {
  static constexpr std::uint32_t no_state = 0xFFFFFFFFU;
  PartSet moving;
  SphereDirection direction;       ///< primitive
  std::uint32_t moved = no_state;  ///< state of the parts that moved; none of a single part
  std::uint32_t rest = no_state;
};

/// A subassembly and how it comes apart: as an alternative any of its moves.
struct DisassemblyState {
  PartSet parts;
  std::vector<DisassemblyMove> moves;  ///< fewest moving parts first, then the simplest direction
  bool is_expanded = false;            ///< its moves were sought
  bool has_all_moves = false;          ///< of those that BlockingGraph::movable_sets names, none was left out
  bool is_interlocked() const { return is_expanded && moves.empty(); }
};

/// A way to take an assembly apart, with alternatives, as a graph: a move leads to two further states.
struct Disassembly {
  struct Step {
    std::uint32_t state;
    std::uint32_t move;  ///< index into the state's moves
  };
  std::vector<DisassemblyState> states;    ///< the first is the whole
  std::vector<Step> steps;                 ///< one after the other
  std::vector<std::uint32_t> interlocked;  ///< states at which the sequence ends, of more than one part
  bool is_complete() const { return interlocked.empty(); }
};

/// Takes the assembly apart as far as it goes.
///
/// No choice is wrong: what a move of the whole leaves together, it leaves together in every subset, so that whatever
/// order is taken, the same parts stay interlocked in the end. Candidates come first: the vertices of the motion space
/// if it is given, for what can move in a cell can move at its vertices; else directions of contacts. Where no
/// candidate works, the motion space of the subassembly decides. A state's parts are taken apart once, whatever leads
/// there.
/// @throws InputError  options name a part that is not there; Cancelled
Disassembly disassemble(const PairRegions& pairs, const MotionSpace* space, const DisassemblyOptions& options,
                        const Context& context);

}  // namespace quoin
