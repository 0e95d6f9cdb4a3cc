// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/partition.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "quoin/assembly/assembly.h"
#include "quoin/assembly/infinitesimal.h"
#include "quoin/assembly/overlap.h"
#include "quoin/assembly/part_pieces.h"
#include "quoin/assembly/test_assemblies.h"

namespace quoin {
namespace {

using namespace test_assemblies;

AssemblyPlan plan_of(const std::vector<Pieces>& parts, bool infinitesimal = false) {
  AssemblyQuestion question;
  question.infinitesimal = infinitesimal;
  return analyse_assembly(assembled(parts), question, one_thread);
}

std::string names(const PartSet& set) {
  std::string text;
  for (const std::uint32_t part : set.members()) text += split_star_names[part];
  std::sort(text.begin(), text.end());
  return text;
}

std::map<std::string, std::vector<std::string>> sets_by_direction(const Partition& partition) {
  std::map<std::string, std::vector<std::string>> found;
  for (const Solution& solution : partition.solutions) {
    for (const PartSet& set : solution.movable) found[text_of(solution.direction)].push_back(names(set));
  }
  return found;
}

// Table 5.1, letters sorted.
const std::map<std::string, std::vector<std::string>> table_5_1{
    {"-1 -1 -1", {"BGT"}}, {"-1 -1 1", {"BRT"}}, {"-1 1 -1", {"GPT"}}, {"-1 1 1", {"PRT"}},
    {"1 -1 -1", {"BGY"}},  {"1 -1 1", {"BRY"}},  {"1 1 -1", {"GPY"}},  {"1 1 1", {"PRY"}}};

TEST(Partition, OfTheSplitStarIsTable51) {
  for (const int pieces : {3, 5, 8}) {
    SCOPED_TRACE(pieces);
    const AssemblyPlan plan = plan_of(split_star_pieces(pieces));
    EXPECT_EQ(plan.pairs.counts.total(), 30U * static_cast<unsigned>(pieces * pieces));
    EXPECT_EQ(sets_by_direction(*plan.partition), table_5_1);
    for (const Solution& solution : plan.partition->solutions) EXPECT_EQ(solution.cell.kind, MotionCell::Kind::vertex);
    EXPECT_EQ(plan.partition->solution_count, 8U);
  }
}

/// Every part as one solid, cut into pieces again: the same answer, whatever the pieces are.
TEST(Partition, OfTheSplitStarCutAutomatically) {
  std::vector<AssemblyPart> parts;
  for (const AssemblyPart& part : assembled(split_star_pieces(8))) {
    const Solid whole = solid_of(part, one_thread);
    EXPECT_EQ(whole.boundary().component_count, 1U);
    parts.push_back(make_part(part.name, pieces_of_part(whole.boundary(), part.name, one_thread), one_thread));
    EXPECT_LE(parts.back().pieces.size(), 8U);
  }
  const AssemblyPlan plan = analyse_assembly(parts, {}, one_thread);
  EXPECT_EQ(sets_by_direction(*plan.partition), table_5_1);
  EXPECT_EQ(plan.partition->cells.vertices, 14U);
  EXPECT_EQ(plan.partition->cells.edges, 36U);
  EXPECT_EQ(plan.partition->cells.faces, 24U);
}

/// Pieces a third as large have no vertices in doubles, and the same directions.
TEST(Partition, OfPartsThatAreNoDoublesIsThatOfLargerOnes) {
  const auto by_thirds = [](const std::vector<Pieces>& parts) {
    std::vector<AssemblyPart> result;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      std::vector<Polytope> polytopes;
      for (const Points& piece : parts[p]) {
        std::vector<RationalPoint3> points;
        for (const Point3& q : piece) points.push_back(exact_point(q) * (Rational(1) / Rational(3)));
        polytopes.push_back(Polytope::hull_of(points, one_thread));
      }
      result.push_back(make_part(parts.size() == 6 ? split_star_names[p] : "part " + std::to_string(p),
                                 std::move(polytopes), one_thread));
    }
    return result;
  };
  const AssemblyPlan plan = analyse_assembly(by_thirds(split_star_pieces(3)), {}, one_thread);
  EXPECT_EQ(sets_by_direction(*plan.partition), table_5_1);
  EXPECT_EQ(plan.pairs.counts.facet, 48U);
  EXPECT_EQ(plan.pairs.counts.vertex, 66U);
  Random random(3);
  for (int round = 0; round < 5; ++round) {
    const std::vector<Pieces> parts = dealt_tetrahedra(random, 2, 4);
    const AssemblyPlan large = plan_of(parts);
    const AssemblyPlan small = analyse_assembly(by_thirds(parts), {}, one_thread);
    EXPECT_EQ(small.partition->cells.vertices, large.partition->cells.vertices);
    EXPECT_EQ(small.partition->cells.faces, large.partition->cells.faces);
    EXPECT_EQ(small.partition->solution_count, large.partition->solution_count);
  }
}

// Section 3.4: where the origin is in the 270 sums.
TEST(Partition, PlacesOfTheOriginInTheSplitStar) {
  const SumCounts counts = plan_of(split_star_pieces(3)).pairs.counts;
  EXPECT_EQ(counts.facet, 48U);
  EXPECT_EQ(counts.edge, 48U);
  EXPECT_EQ(counts.vertex, 66U);
  EXPECT_EQ(counts.separated, 108U);
}

// All 48 ways to turn and reflect along axes: poles and the cut of the parameter rectangle fall elsewhere.
TEST(Partition, OfTheSplitStarInEveryAxisOrientation) {
  std::array<unsigned, 3> axes{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      std::vector<Pieces> parts = split_star_pieces(3);
      const auto turn = [&](const Point3& p) {
        Point3 q;
        for (unsigned axis = 0; axis < 3; ++axis)
          q[axis] = ((signs >> axis) & 1U) != 0 ? -p[axes[axis]] : p[axes[axis]];
        return q;
      };
      for (Pieces& pieces : parts) {
        for (Points& piece : pieces) {
          for (Point3& p : piece) p = turn(p);
        }
      }
      const AssemblyPlan plan = plan_of(parts);
      EXPECT_EQ(plan.partition->cells.vertices, 14U);
      EXPECT_EQ(plan.partition->cells.edges, 36U);
      EXPECT_EQ(plan.partition->cells.faces, 24U);
      ASSERT_EQ(plan.partition->solutions.size(), 8U);
      const auto found = sets_by_direction(*plan.partition);
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
          for (const double z : {-1.0, 1.0}) {
            const auto text = [](const Point3& p) { return text_of(SphereDirection(Vector3{p.x, p.y, p.z})); };
            EXPECT_EQ(found.at(text(turn({x, y, z}))), table_5_1.at(text({x, y, z})));
          }
        }
      }
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
}

// Turned by a rational rotation and not along axes: the same solutions, turned.
TEST(Partition, OfTheSplitStarTurnedByARationalRotation) {
  // Columns 1/3 (1, 2, 2), 1/3 (2, 1, -2), 1/3 (2, -2, 1), times 3.
  const auto turn = [](const Point3& p) {
    return Point3{p.x + 2 * p.y + 2 * p.z, 2 * p.x + p.y - 2 * p.z, 2 * p.x - 2 * p.y + p.z};
  };
  std::vector<Pieces> parts = split_star_pieces(3);
  for (Pieces& pieces : parts) {
    for (Points& piece : pieces) std::transform(piece.begin(), piece.end(), piece.begin(), turn);
  }
  const AssemblyPlan plan = plan_of(parts);
  EXPECT_EQ(plan.partition->cells.vertices, 14U);
  EXPECT_EQ(plan.partition->cells.edges, 36U);
  const auto found = sets_by_direction(*plan.partition);
  EXPECT_EQ(found.at(text_of(direction(5, 1, 1))), table_5_1.at("1 1 1"));
  EXPECT_EQ(found.size(), 8U);
}

// Section 3.5: a blind hole leaves (0, 0, 1), a through hole +-(0, 0, 1).
TEST(Partition, OfAPegInAHole) {
  const Partition blind = *plan_of(peg(true)).partition;
  // The block leaves the peg the opposite way.
  ASSERT_EQ(blind.solutions.size(), 2U);
  for (const Solution& solution : blind.solutions) {
    EXPECT_EQ(solution.cell.kind, MotionCell::Kind::vertex);
    ASSERT_EQ(solution.movable.size(), 1U);
    const bool is_peg = solution.movable[0].contains(0);
    EXPECT_EQ(text_of(solution.direction), is_peg ? "0 0 1" : "0 0 -1");
  }
  const Partition through = *plan_of(peg(false)).partition;
  ASSERT_EQ(through.solutions.size(), 2U);
  for (const Solution& solution : through.solutions) EXPECT_EQ(solution.movable.size(), 2U);
}

// Every direction is a solution; upward, each upper part of the stack moves.
TEST(Partition, OfAStackOfBoxes) {
  const int n = 6;
  const AssemblyPlan plan = plan_of(stack(n));
  const Partition& partition = *plan.partition;
  EXPECT_EQ(partition.solution_cells, partition.cells.vertices + partition.cells.edges + partition.cells.faces);
  for (const Solution& solution : partition.solutions) {
    if (text_of(solution.direction) != "0 0 1") continue;
    ASSERT_EQ(solution.movable.size(), static_cast<std::size_t>(n - 1));
    for (std::size_t k = 0; k < solution.movable.size(); ++k) {
      EXPECT_EQ(solution.movable[k].count(), k + 1);
      EXPECT_TRUE(solution.movable[k].contains(static_cast<std::size_t>(n - 1)));
    }
    return;
  }
  FAIL() << "no cell was represented by (0, 0, 1)";
}

// The difference between beginning to move and going on: trap 45.
TEST(Infinitesimal, HooksCanBeginToMoveButNotPart) {
  const AssemblyPlan plan = plan_of(hooks(), true);
  EXPECT_TRUE(plan.partition->is_interlocked());
  EXPECT_GT(plan.infinitesimal->partition.solution_count, 0U);
  EXPECT_EQ(plan.infinitesimal->stopped.size(), plan.infinitesimal->partition.solution_count);
  for (const StoppedMotion& stop : plan.infinitesimal->stopped) EXPECT_FALSE(stop.stops.empty());
}

TEST(Infinitesimal, OfTheSplitStarEverythingGoesOn) {
  const AssemblyPlan plan = plan_of(split_star_pieces(3), true);
  EXPECT_EQ(sets_by_direction(plan.infinitesimal->partition), table_5_1);
  EXPECT_TRUE(plan.infinitesimal->stopped.empty());
}

TEST(Infinitesimal, WhatMovesToInfinityBeginsToMove) {
  const AssemblyPlan plan = plan_of(peg(true), true);
  EXPECT_EQ(plan.infinitesimal->partition.solution_count, 2U);
  EXPECT_TRUE(plan.infinitesimal->stopped.empty());
}

TEST(Partition, KeepsNoMoreSolutionsThanAsked) {
  AssemblyQuestion question;
  question.partition.max_solutions = 10;
  const AssemblyPlan plan = analyse_assembly(assembled(stack(5)), question, one_thread);
  std::size_t kept = 0;
  for (const Solution& solution : plan.partition->solutions) kept += solution.movable.size();
  EXPECT_LE(kept, 10U);
  EXPECT_GT(kept, 0U);
  EXPECT_EQ(plan.partition->solution_count, kept);
  EXPECT_FALSE(plan.partition->has_all);
  EXPECT_EQ(plan.partition->solution_cells, plan_of(stack(5)).partition->solution_cells);
}

TEST(Partition, KeepsOnlySetsThatCount) {
  AssemblyQuestion question;
  const AssemblyPlan all = analyse_assembly(assembled(stack(4)), question, one_thread);
  question.partition.counts = [](const PartSet& set) { return set.count() == 1 && !set.contains(0); };
  for (const std::size_t most : {std::size_t{100'000}, std::size_t{1}}) {
    question.partition.max_solutions = most;
    const AssemblyPlan some = analyse_assembly(assembled(stack(4)), question, one_thread);
    std::size_t cells = 0;
    std::size_t sets = 0;
    for (const Solution& solution : all.partition->solutions) {
      const auto here = static_cast<std::size_t>(std::ranges::count_if(solution.movable, question.partition.counts));
      cells += here > 0 ? 1 : 0;
      sets += here;
    }
    EXPECT_GT(cells, 1U);
    EXPECT_LT(cells, all.partition->solution_cells);
    EXPECT_EQ(some.partition->solution_cells, cells);
    EXPECT_EQ(some.partition->has_all, most > 1);
    EXPECT_EQ(some.partition->solution_count == sets, most > 1);
    EXPECT_LE(some.partition->solution_count, most);
    for (const Solution& solution : some.partition->solutions) {
      EXPECT_TRUE(std::ranges::all_of(solution.movable, question.partition.counts));
    }
  }
  question.partition.counts = [](const PartSet& set) { return set.count() > 3; };
  EXPECT_TRUE(analyse_assembly(assembled(stack(4)), question, one_thread).partition->is_interlocked());
}

TEST(Partition, AnnouncesWhatItWillCost) {
  AssemblyQuestion question;
  MotionEstimate told;
  question.partition.announce = [&](const MotionEstimate& estimate) { told = estimate; };
  analyse_assembly(assembled(split_star_pieces(3)), question, one_thread);
  EXPECT_GT(told.regions, 0U);
  EXPECT_GT(told.arcs, told.regions);
  EXPECT_GT(told.seconds, 0);
  question.partition.announce = [](const MotionEstimate&) { throw InputError("too much"); };
  EXPECT_THROW(analyse_assembly(assembled(split_star_pieces(3)), question, one_thread), InputError);
}

TEST(Partition, SameForAnyNumberOfThreads) {
  const std::vector<AssemblyPart> parts = assembled(split_star_pieces(3));
  const Context two({.threads = 2});
  const AssemblyPlan a = analyse_assembly(parts, {}, one_thread);
  const AssemblyPlan b = analyse_assembly(parts, {}, two);
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) EXPECT_TRUE(a.groups[g].region == b.groups[g].region);
  EXPECT_EQ(sets_by_direction(*a.partition), sets_by_direction(*b.partition));
}

}  // namespace
}  // namespace quoin
