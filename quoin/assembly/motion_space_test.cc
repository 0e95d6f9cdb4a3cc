// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/motion_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "quoin/assembly/candidates.h"
#include "quoin/assembly/test_assemblies.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace test_assemblies;

struct Space {
  explicit Space(const PairRegions& pairs, MotionKind kind = MotionKind::infinite)
      : groups(unite_pairs(pairs, kind, times, one_thread)), space(pairs.part_count, groups, one_thread) {}
  PhaseTimes times;
  std::vector<RegionGroup> groups;
  MotionSpace space;
};

BlockingGraph graph_by_rays(const std::vector<Pieces>& parts, const SphereDirection& d) {
  BlockingGraph graph(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (i != j) graph.set_arc(i, j, hits(parts[i], parts[j], rational(d)));
    }
  }
  return graph;
}

/// Every cell's graph, at a direction inside it, is what rays say; and every direction's graph is that of some cell.
void expect_cells_agree_with_rays(const std::vector<Pieces>& parts, Random& random) {
  const PairRegions pairs = pairs_of(assembled(parts));
  const Space made(pairs);
  check_links(made.space.arrangement().cells());
  std::set<std::vector<std::uint64_t>> graphs;
  std::size_t cells = 0;
  made.space.walk(
      [&](MotionCell cell, const BlockingGraph& graph) {
        ++cells;
        graphs.insert(graph.rows());
        const SphereDirection d = made.space.direction_in(cell);
        ASSERT_TRUE(d.is_valid());
        if (cells % 3 != 0 && cell.kind != MotionCell::Kind::vertex) return;
        ASSERT_EQ(graph.rows(), graph_by_rays(parts, d).rows())
            << int(cell.kind) << " " << cell.id << ": " << text_of(d);
      },
      one_thread);
  const MotionCounts counts = made.space.counts();
  EXPECT_EQ(cells, counts.vertices + counts.edges + counts.faces);
  for (int k = 0; k < 10; ++k) {
    const SphereDirection d = random_direction(random);
    const BlockingGraph by_rays = graph_by_rays(parts, d);
    EXPECT_TRUE(graphs.contains(by_rays.rows())) << text_of(d);
    EXPECT_EQ(blocking_graph(pairs, d, PartSet::all(parts.size())), by_rays) << text_of(d);
  }
}

TEST(MotionSpace, CellsOfDealtTetrahedraAgreeWithRays) {
  Random random(11);
  for (int round = 0; round < test_rounds(8); ++round) {
    SCOPED_TRACE(round);
    expect_cells_agree_with_rays(dealt_tetrahedra(random, 1, 2 + random() % 2), random);
  }
}

TEST(MotionSpace, CellsOfKnownAssembliesAgreeWithRays) {
  Random random(12);
  expect_cells_agree_with_rays(peg(true), random);
  expect_cells_agree_with_rays(peg(false), random);
  expect_cells_agree_with_rays(hooks(), random);
  expect_cells_agree_with_rays(stack(4), random);
}

// Full doubles of many magnitudes: differences round, directions are longer than any fixed width.
TEST(MotionSpace, CellsOfPartsOfAnySizeAgreeWithTheirPairs) {
  Random random(13);
  for (int round = 0; round < test_rounds(6); ++round) {
    SCOPED_TRACE(round);
    const auto number = [&](unsigned exponents) {
      return std::ldexp(1 + double(random() % (std::uint64_t{1} << 52)) * 0x1p-52, int(random() % exponents));
    };
    const unsigned across = round < 3 ? 8 : 200;
    std::vector<Pieces> parts;
    double at = 0;
    for (int p = 0; p < 3; ++p) {
      const double next = at + number(8);
      parts.push_back({box({at, -number(across), -number(across)}, {next, number(across), number(across)})});
      at = random() % 2 == 0 ? next : next + number(8);
    }
    const PairRegions pairs = pairs_of(assembled(parts));
    const Space made(pairs);
    std::size_t cells = 0;
    made.space.walk(
        [&](MotionCell cell, const BlockingGraph& graph) {
          ++cells;
          const SphereDirection d = made.space.direction_in(cell);
          ASSERT_EQ(graph, blocking_graph(pairs, d, PartSet::all(3))) << int(cell.kind) << " " << cell.id;
        },
        one_thread);
    EXPECT_GT(cells, 3U);
  }
}

// Section 3.4: once simplified 14 vertices, 36 edges, 24 faces, whatever the pieces; arcs of graphs by kind of cell.
TEST(MotionSpace, OfTheSplitStar) {
  for (const int pieces : {3, 5, 8}) {
    SCOPED_TRACE(pieces);
    const Space made(pairs_of(assembled(split_star_pieces(pieces))));
    const MotionCounts counts = made.space.counts();
    EXPECT_EQ(counts.vertices, 14U);
    EXPECT_EQ(counts.edges, 36U);
    EXPECT_EQ(counts.faces, 24U);
    std::map<std::pair<MotionCell::Kind, std::size_t>, int> arcs;
    made.space.walk(
        [&](MotionCell cell, const BlockingGraph& graph) {
          ++arcs[{cell.kind, graph.arc_count()}];
        },
        one_thread);
    const std::map<std::pair<MotionCell::Kind, std::size_t>, int> expected{{{MotionCell::Kind::vertex, 12}, 8},
                                                                           {{MotionCell::Kind::vertex, 13}, 6},
                                                                           {{MotionCell::Kind::edge, 17}, 36},
                                                                           {{MotionCell::Kind::face, 17}, 12},
                                                                           {{MotionCell::Kind::face, 22}, 12}};
    EXPECT_EQ(arcs, expected);
  }
}

// Section 3.4: the graph of (1, 1, 1).
TEST(MotionSpace, GraphOfADirectionOfTheSplitStar) {
  const PairRegions pairs = pairs_of(assembled(split_star_pieces(3)));
  const BlockingGraph graph = blocking_graph(pairs, direction(1, 1, 1), PartSet::all(6));
  std::set<std::string> arcs;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      if (graph.has_arc(i, j)) arcs.insert(std::string(split_star_names[i]) + split_star_names[j]);
    }
  }
  EXPECT_EQ(arcs, (std::set<std::string>{"RP", "GP", "GY", "GT", "PY", "BR", "BG", "BY", "YR", "TR", "TP", "TB"}));
}

// Trap 35 and 36: of what a peg in a blind hole meets, a single direction is left out.
TEST(MotionSpace, RegionOfAPegInABlindHole) {
  const PairRegions pairs = pairs_of(assembled(peg(true)));
  const Space made(pairs);
  ASSERT_EQ(made.groups.size(), 2U);
  const BlockedRegion& region = made.groups[0].region;
  EXPECT_TRUE(region.arcs.empty());
  EXPECT_TRUE(region.blocks_elsewhere);
  ASSERT_EQ(region.vertices.size(), 1U);
  EXPECT_EQ(text_of(region.vertices[0].at), "0 0 1");
  EXPECT_FALSE(region.vertices[0].is_blocked);
}

TEST(MotionSpace, OfOnePartIsTheWholeSphere) {
  const Space made(pairs_of(assembled(stack(1))));
  const MotionCounts counts = made.space.counts();
  EXPECT_EQ(counts.vertices + counts.edges, 0U);
  EXPECT_EQ(counts.faces, 1U);
  EXPECT_TRUE(made.space.direction_in({MotionCell::Kind::face, 0}).is_valid());
}

TEST(MotionSpace, EqualRegionsAreDrawnOnce) {
  const PairRegions pairs = pairs_of(assembled(stack(8)));
  const Space made(pairs);
  // A hemisphere and six frustums of pyramids, and what is opposite.
  EXPECT_EQ(made.groups.size(), 14U);
  std::size_t arcs = 0;
  for (const RegionGroup& group : made.groups) arcs += group.arcs.size();
  EXPECT_EQ(arcs, 56U);
}

TEST(MotionSpace, CanBeCancelled) {
  Context cancelled({.threads = 1});
  cancelled.cancel();
  const PairRegions pairs = pairs_of(assembled(split_star_pieces(3)));
  PhaseTimes times;
  EXPECT_THROW(unite_pairs(pairs, MotionKind::infinite, times, cancelled), Cancelled);
  const Space made(pairs);
  EXPECT_THROW(MotionSpace(6, made.groups, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
