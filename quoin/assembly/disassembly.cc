// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/disassembly.h"

#include <algorithm>
#include <map>
#include <utility>

#include "quoin/assembly/candidates.h"
#include "quoin/assembly/move_list.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::size_t most_vertex_graphs = 20'000;
constexpr std::size_t most_contact_directions = 512;
/// Graphs of a subassembly whose larger sets are looked at once there are moves enough to choose from.
constexpr std::size_t most_graphs_tried = 64;

/// The pairs of some parts, numbered anew in ascending order.
PairRegions pairs_within(const PairRegions& all, const std::vector<std::uint32_t>& parts) {
  PairRegions result;
  result.part_count = parts.size();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) {
      const PartPair& pair = all.pair(parts[i], parts[j]);
      result.pairs.push_back({i, j, pair.pieces, pair.contacts, pair.bounds});
    }
  }
  return result;
}

class Disassembler {
 public:
  Disassembler(const PairRegions& pairs, const MotionSpace* space, const DisassemblyOptions& options,
               const Context& context)
      : pairs_(pairs), options_(options), context_(context) {
    if (!options.directions.empty()) {
      candidates_ = candidates_in(pairs, options.directions, context);
      candidates_.are_all = true;
      return;
    }
    if (space != nullptr) candidates_ = vertex_candidates(*space, most_vertex_graphs, context);
    if (!candidates_.are_all) candidates_ = contact_candidates(pairs, most_contact_directions, context);
  }

  Disassembly run() {
    const PartSet everything = PartSet::all(pairs_.part_count);
    if (everything.count() > 1) {
      add_state(everything);
      follow();
      expand_alternatives();
    }
    return std::move(result_);
  }

 private:
  std::uint32_t add_state(const PartSet& parts) {
    if (parts.count() < 2) return DisassemblyMove::no_state;
    const auto [at, is_new] = number_.try_emplace(parts, static_cast<std::uint32_t>(result_.states.size()));
    if (is_new) result_.states.push_back({parts, {}, false, false});
    return at->second;
  }

  /// The sequence: always the first move, then the rest, then what was moved.
  void follow() {
    std::vector<std::uint32_t> pending{0};
    while (!pending.empty()) {
      const std::uint32_t state = pending.back();
      pending.pop_back();
      context_.progress("sequence", static_cast<double>(result_.steps.size()) / static_cast<double>(pairs_.part_count));
      expand(state);
      if (result_.states[state].moves.empty()) {
        result_.interlocked.push_back(state);
        continue;
      }
      result_.steps.push_back({state, 0});
      const DisassemblyMove& move = result_.states[state].moves[0];
      if (move.moved != DisassemblyMove::no_state) pending.push_back(move.moved);
      if (move.rest != DisassemblyMove::no_state) pending.push_back(move.rest);
    }
  }
  void expand_alternatives() {
    std::size_t expanded = 0;
    for (std::uint32_t state = 0; state < result_.states.size() && expanded < options_.max_states; ++state) {
      if (result_.states[state].is_expanded) continue;
      ++expanded;
      expand(state);
    }
  }

  void expand(std::uint32_t state) {
    if (result_.states[state].is_expanded) return;
    const PartSet parts = result_.states[state].parts;
    bool has_all = true;
    std::vector<DisassemblyMove> moves = moves_among(candidates_, parts, has_all);
    if (moves.empty() && !candidates_.are_all) moves = moves_in_motion_space(parts, has_all);
    for (DisassemblyMove& move : moves) {
      move.moved = add_state(move.moving);
      move.rest = add_state(parts.without(move.moving));
    }
    DisassemblyState& expanded = result_.states[state];
    expanded.moves = std::move(moves);
    expanded.has_all_moves = has_all && candidates_.are_all;
    expanded.is_expanded = true;
  }

  bool is_allowed(const PartSet& moving) const {
    if (options_.base && moving.contains(*options_.base)) return false;
    return !options_.one_part_at_a_time || moving.count() == 1;
  }
  /// Single parts first, which are quickly found; larger sets only while there is room for alternatives.
  std::vector<DisassemblyMove> moves_among(const Candidates& candidates, const PartSet& parts, bool& has_all) const {
    MoveList moves(parts, options_.max_alternatives);
    for (const Candidate& candidate : candidates.list) {
      context_.poll();
      for (const std::uint32_t part : parts.members()) {
        if (candidate.graph.is_held(part, parts)) continue;
        PartSet moving(pairs_.part_count);
        moving.insert(part);
        if (is_allowed(moving)) moves.add(std::move(moving), candidate.direction);
      }
    }
    std::size_t tried = 0;
    for (const Candidate& candidate : candidates.list) {
      if (options_.one_part_at_a_time) break;
      if (moves.is_full() || (tried >= most_graphs_tried && !moves.is_empty())) {
        has_all = false;
        break;
      }
      context_.poll();
      std::vector<PartSet> sets = candidate.graph.movable_sets(parts);
      if (!sets.empty()) ++tried;
      for (PartSet& moving : sets) {
        if (is_allowed(moving)) moves.add(std::move(moving), candidate.direction);
      }
    }
    return moves.take(has_all);
  }
  std::vector<DisassemblyMove> moves_in_motion_space(const PartSet& parts, bool& has_all) const {
    const std::vector<std::uint32_t> members = parts.members();
    const PairRegions pairs = pairs_within(pairs_, members);
    PartitionOptions options;
    options.prune = true;
    options.announce = options_.announce;
    const auto in_assembly = [&](const PartSet& movable) {
      PartSet moving(pairs_.part_count);
      for (const std::uint32_t member : movable.members()) moving.insert(members[member]);
      return moving;
    };
    // Before they are counted: what is kept of very many must hold one if there is one.
    options.counts = [&](const PartSet& movable) { return is_allowed(in_assembly(movable)); };
    PhaseTimes times;
    const Partition found = partition(pairs, options, times, context_);
    has_all = has_all && found.has_all;
    MoveList moves(parts, options_.max_alternatives);
    for (const Solution& solution : found.solutions) {
      for (const PartSet& movable : solution.movable) moves.add(in_assembly(movable), solution.direction);
    }
    return moves.take(has_all);
  }

  const PairRegions& pairs_;
  const DisassemblyOptions& options_;
  const Context& context_;
  Candidates candidates_;
  Disassembly result_;
  std::map<PartSet, std::uint32_t> number_;
};

}  // namespace

Disassembly disassemble(const PairRegions& pairs, const MotionSpace* space, const DisassemblyOptions& options,
                        const Context& context) {
  if (options.base && *options.base >= pairs.part_count) throw InputError("the base is no part of the assembly");
  for (const SphereDirection& direction : options.directions) {
    if (!direction.is_valid()) throw InputError("the zero vector is no direction");
  }
  return Disassembler(pairs, space, options, context).run();
}

}  // namespace quoin
