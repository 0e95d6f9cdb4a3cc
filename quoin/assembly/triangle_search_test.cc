// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/triangle_search.h"

#include <gtest/gtest.h>

#include <set>

#include "quoin/assembly/candidates.h"
#include "quoin/assembly/partition.h"
#include "quoin/assembly/test_assemblies.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace test_assemblies;

std::set<std::pair<std::string, std::vector<std::vector<std::uint32_t>>>> solutions_of(const PairRegions& pairs,
                                                                                       bool prune) {
  PartitionOptions options;
  options.prune = prune;
  PhaseTimes times;
  std::set<std::pair<std::string, std::vector<std::vector<std::uint32_t>>>> found;
  for (const Solution& solution : partition(pairs, options, times, one_thread).solutions) {
    // Of faces and edges either may name another direction: what can move there tells them apart well enough.
    const bool is_vertex = solution.cell.kind == MotionCell::Kind::vertex;
    std::vector<std::vector<std::uint32_t>> sets;
    for (const PartSet& set : solution.movable) sets.push_back(set.members());
    found.insert({is_vertex ? text_of(solution.direction) : "", sets});
  }
  return found;
}

std::size_t cells_with_solutions(const PairRegions& pairs, bool prune) {
  PartitionOptions options;
  options.prune = prune;
  PhaseTimes times;
  return partition(pairs, options, times, one_thread).solution_cells;
}

void expect_nothing_is_lost(const std::vector<Pieces>& parts) {
  const PairRegions pairs = pairs_of(assembled(parts));
  EXPECT_EQ(solutions_of(pairs, true), solutions_of(pairs, false));
  EXPECT_EQ(cells_with_solutions(pairs, true), cells_with_solutions(pairs, false));
}

TEST(TriangleSearch, LosesNoSolution) {
  expect_nothing_is_lost(split_star_pieces(3));
  expect_nothing_is_lost(peg(true));
  expect_nothing_is_lost(peg(false));
  expect_nothing_is_lost(hooks());
  expect_nothing_is_lost(stack(3));
  Random random(9);
  for (int round = 0; round < test_rounds(3); ++round) expect_nothing_is_lost(dealt_tetrahedra(random, 2, 3));
}

// Where all is held, directions are settled; those that are left hold all solutions.
TEST(TriangleSearch, SettlesOnlyDirectionsThatHoldAllParts) {
  const PairRegions pairs = pairs_of(assembled(split_star_pieces(3)));
  const UnsettledDirections left = find_unsettled(pairs, 400, one_thread);
  Random random(1);
  int settled = 0;
  for (int k = 0; k < 200; ++k) {
    const SphereDirection d(
        Vector3{double(random() % 65) - 32, double(random() % 65) - 32, double(random() % 65) - 32});
    if (!d.is_valid() || left.contain(d)) continue;
    ++settled;
    EXPECT_TRUE(blocking_graph(pairs, d, PartSet::all(6)).is_strongly_connected(PartSet::all(6))) << text_of(d);
  }
  EXPECT_GE(settled, 100);
  for (const std::int64_t x : {1, -1}) {
    for (const std::int64_t y : {1, -1}) EXPECT_TRUE(left.contain(direction(x, y, 1)));
  }
}

TEST(TriangleSearch, ProvesThatHooksHold) {
  EXPECT_TRUE(find_unsettled(pairs_of(assembled(hooks())), 4096, one_thread).triangles.empty());
}

// The triangles of any depth cover the sphere where nothing is settled.
TEST(TriangleSearch, CoversWhatIsNotSettled) {
  const UnsettledDirections left = find_unsettled(pairs_of(assembled(stack(3))), 300, one_thread);
  Random random(6);
  for (int k = 0; k < 200; ++k) EXPECT_TRUE(left.contain(random_direction(random)));
}

}  // namespace
}  // namespace quoin
