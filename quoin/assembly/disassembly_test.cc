// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/disassembly.h"

#include <gtest/gtest.h>

#include "quoin/assembly/assembly.h"
#include "quoin/assembly/infinitesimal.h"
#include "quoin/assembly/test_assemblies.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace test_assemblies;

/// No move of any state is stopped, by rays; states of moves are what they say.
void expect_moves_are_free(const Disassembly& found, const std::vector<Pieces>& parts) {
  for (const DisassemblyState& state : found.states) {
    for (const DisassemblyMove& move : state.moves) {
      EXPECT_EQ(move.moving.without(state.parts).count(), 0U);
      EXPECT_GT(move.moving.count(), 0U);
      const PartSet rest = state.parts.without(move.moving);
      EXPECT_GT(rest.count(), 0U);
      for (const std::uint32_t i : move.moving.members()) {
        for (const std::uint32_t j : rest.members()) EXPECT_FALSE(hits(parts[i], parts[j], rational(move.direction)));
      }
      if (move.rest != DisassemblyMove::no_state) {
        EXPECT_EQ(found.states[move.rest].parts, rest);
      }
      if (move.moved != DisassemblyMove::no_state) {
        EXPECT_EQ(found.states[move.moved].parts, move.moving);
      }
    }
  }
}

Disassembly taken_apart(const std::vector<Pieces>& parts, const DisassemblyOptions& options, bool with_space) {
  AssemblyQuestion question;
  question.sequence = true;
  question.solutions = with_space;
  question.disassembly = options;
  return std::move(*analyse_assembly(assembled(parts), question, one_thread).disassembly);
}

TEST(Disassembly, OfTheSplitStarGoesHalfByHalf) {
  for (const bool with_space : {true, false}) {
    const std::vector<Pieces> parts = split_star_pieces(3);
    const Disassembly found = taken_apart(parts, {}, with_space);
    EXPECT_TRUE(found.is_complete());
    EXPECT_EQ(found.steps.size(), 5U);
    // Eight sets of three, where a set and the others count once.
    EXPECT_EQ(found.states[0].moves.size(), 4U);
    EXPECT_EQ(found.states[0].moves[0].moving.count(), 3U);
    EXPECT_EQ(found.states[0].has_all_moves, with_space);
    expect_moves_are_free(found, parts);
  }
}

TEST(Disassembly, OfAStackTakesTheTopFirst) {
  const std::vector<Pieces> parts = stack(7);
  DisassemblyOptions options;
  options.directions = {direction(0, 0, 1)};
  const Disassembly found = taken_apart(parts, options, false);
  ASSERT_EQ(found.steps.size(), 6U);
  for (std::uint32_t k = 0; k < 6; ++k) {
    const Disassembly::Step& step = found.steps[k];
    const DisassemblyMove& move = found.states[step.state].moves[step.move];
    EXPECT_EQ(move.moving.members(), std::vector<std::uint32_t>{6 - k});
    EXPECT_EQ(text_of(move.direction), "0 0 1");
  }
  expect_moves_are_free(found, parts);
}

TEST(Disassembly, NamesWhatIsInterlocked) {
  std::vector<Pieces> parts = hooks();
  parts.push_back({box({20, 0, 0}, {21, 1, 1})});
  for (const bool with_space : {true, false}) {
    const Disassembly found = taken_apart(parts, {}, with_space);
    EXPECT_FALSE(found.is_complete());
    ASSERT_EQ(found.interlocked.size(), 1U);
    EXPECT_EQ(found.states[found.interlocked[0]].parts.members(), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(found.states[found.interlocked[0]].is_interlocked());
    expect_moves_are_free(found, parts);
  }
}

TEST(Disassembly, KeepsToItsLimits) {
  const std::vector<Pieces> parts = stack(4);
  DisassemblyOptions options;
  options.base = 3;
  const Disassembly hanging = taken_apart(parts, options, true);
  EXPECT_TRUE(hanging.is_complete());
  for (const DisassemblyState& state : hanging.states) {
    for (const DisassemblyMove& move : state.moves) EXPECT_FALSE(move.moving.contains(3));
  }
  options = {};
  options.one_part_at_a_time = true;
  // One part of the Split Star alone never moves.
  EXPECT_EQ(taken_apart(split_star_pieces(3), options, true).steps.size(), 0U);
  EXPECT_TRUE(taken_apart(parts, options, true).is_complete());
  options = {};
  options.directions = {direction(1, 0, 0)};
  EXPECT_FALSE(taken_apart(peg(true), options, false).is_complete());
  options.directions = {direction(0, 0, -1)};
  const Disassembly down = taken_apart(peg(true), options, false);
  ASSERT_EQ(down.steps.size(), 1U);
  EXPECT_EQ(down.states[0].moves[0].moving.members(), std::vector<std::uint32_t>{1});
}

TEST(Disassembly, RefusesLimitsThatMeanNothing) {
  DisassemblyOptions options;
  options.base = 9;
  EXPECT_THROW(taken_apart(stack(3), options, false), InputError);
  options = {};
  options.directions = {SphereDirection(Vector3{0, 0, 0})};
  EXPECT_THROW(taken_apart(stack(3), options, false), InputError);
}

// Whatever the way, the same parts stay together: with all directions tried first, and with those of contacts.
TEST(Disassembly, EndsAtTheSamePartsWhicheverWay) {
  Random random(5);
  int interlocked = 0;
  for (int round = 0; round < test_rounds(12); ++round) {
    SCOPED_TRACE(round);
    const std::vector<Pieces> parts = dealt_tetrahedra(random, 3, 3);
    const auto ends_of = [&](bool with_space) {
      const Disassembly found = taken_apart(parts, {}, with_space);
      expect_moves_are_free(found, parts);
      std::vector<PartSet> ends;
      for (const std::uint32_t state : found.interlocked) ends.push_back(found.states[state].parts);
      std::sort(ends.begin(), ends.end());
      return ends;
    };
    const std::vector<PartSet> ends = ends_of(true);
    EXPECT_EQ(ends, ends_of(false));
    interlocked += ends.empty() ? 0 : 1;
  }
  EXPECT_GE(interlocked, test_cases(1));
}

TEST(Disassembly, OfOnePartIsNothing) {
  const Disassembly found = taken_apart(stack(1), {}, true);
  EXPECT_TRUE(found.is_complete());
  EXPECT_TRUE(found.steps.empty());
  EXPECT_TRUE(found.states.empty());
}

}  // namespace
}  // namespace quoin
