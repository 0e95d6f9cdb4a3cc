// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/part.h"

#include <gtest/gtest.h>

#include "quoin/assembly/assembly.h"
#include "quoin/assembly/blocking_graph.h"
#include "quoin/assembly/overlap.h"
#include "quoin/assembly/part_pieces.h"
#include "quoin/assembly/test_assemblies.h"
#include "quoin/solid/test_solids.h"

namespace quoin {
namespace {

namespace known = test_assemblies;
using testing::solid;

std::string refusal_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(Part, OverlapsAreNamedWithTheirVolume) {
  const std::vector<known::Pieces> parts{{known::box({0, 0, 0}, {2, 2, 2})},
                                         {known::box({1, 1, 1}, {3, 3, 3}), known::box({1, 1, 1}, {2, 2, 3})},
                                         {known::box({3, 0, 0}, {4, 1, 1})}};
  const std::string refusal = refusal_of([&] { analyse_assembly(known::assembled(parts), {}, known::one_thread); });
  EXPECT_TRUE(says(refusal, "part 0 and part 1 overlap in a volume of 1")) << refusal;
  EXPECT_FALSE(says(refusal, "part 2")) << refusal;
}

TEST(Part, EqualPartsOverlap) {
  const known::Pieces cube{known::box({0, 0, 0}, {1, 1, 1})};
  EXPECT_TRUE(says(refusal_of([&] {
                     analyse_assembly(known::assembled({cube, cube}), {}, known::one_thread);
                   }),
                   "overlap in a volume of 1"));
}

TEST(Part, CommonVolumeIsExact) {
  const AssemblyPart a = known::part("a", {known::box({0, 0, 0}, {1, 1, 1})});
  const AssemblyPart b = known::part("b", {known::box({1 - 0x1p-40, 0, 0}, {2, 0.5, 1})});
  EXPECT_EQ(common_volume(a, b, known::one_thread), Rational(0x1p-41));
}

TEST(Part, BadPartsAreRefused) {
  EXPECT_TRUE(says(refusal_of([] { make_part("none", {}, known::one_thread); }), "'none' is empty"));
  EXPECT_TRUE(says(refusal_of([] { known::part("flat", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}); }), "flat"));
  EXPECT_TRUE(says(refusal_of([] { analyse_assembly({}, {}, known::one_thread); }), "without parts"));
  const std::vector<AssemblyPart> twins{known::part("a", {known::box({0, 0, 0}, {1, 1, 1})}),
                                        known::part("a", {known::box({1, 0, 0}, {2, 1, 1})})};
  EXPECT_TRUE(says(refusal_of([&] { analyse_assembly(twins, {}, known::one_thread); }), "two parts have the name 'a'"));
}

TEST(PartPieces, OfSolids) {
  const auto pieces_of = [](const Solid& s) { return pieces_of_part(s.boundary(), "s", known::one_thread); };
  EXPECT_EQ(pieces_of(testing::box({0, 0, 0}, {1, 1, 1})).size(), 1U);
  using testing::operator|;
  using testing::operator-;
  using testing::operator~;
  const Solid two = testing::box({0, 0, 0}, {1, 1, 1}) | testing::box({2, 0, 0}, {3, 1, 1});
  EXPECT_EQ(pieces_of(two).size(), 2U);
  // Shells that touch along an edge are convex each.
  EXPECT_EQ(pieces_of(testing::box({0, 0, 0}, {1, 1, 1}) | testing::box({1, 1, 0}, {2, 2, 1})).size(), 2U);
  const Solid bent = testing::box({0, 0, 0}, {2, 1, 1}) | testing::box({0, 0, 0}, {1, 2, 1});
  EXPECT_EQ(pieces_of(bent).size(), 2U);
  const Solid hollow = testing::box({0, 0, 0}, {3, 3, 3}) - testing::box({1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(pieces_of(hollow).size(), 6U);
  EXPECT_TRUE(says(refusal_of([&] { pieces_of(Solid()); }), "empty"));
  EXPECT_TRUE(says(refusal_of([&] { pieces_of(~two); }), "unbounded"));
}

TEST(BlockingGraph, MovableSets) {
  BlockingGraph graph(70);
  PartSet all = PartSet::all(70);
  // A path down, closed into a circle among the last three.
  for (std::size_t i = 0; i + 1 < 70; ++i) graph.set_arc(i, i + 1, true);
  graph.set_arc(69, 67, true);
  EXPECT_FALSE(graph.is_strongly_connected(all));
  std::vector<PartSet> sets = graph.movable_sets(all);
  ASSERT_EQ(sets.size(), 67U);
  EXPECT_EQ(sets[0].members(), (std::vector<std::uint32_t>{67, 68, 69}));
  EXPECT_EQ(sets.back().count(), 69U);
  graph.set_arc(69, 0, true);
  EXPECT_TRUE(graph.is_strongly_connected(all));
  EXPECT_TRUE(graph.movable_sets(all).empty());
  PartSet one(70);
  one.insert(30);
  EXPECT_FALSE(graph.is_strongly_connected(all.without(one)));
  graph.set_arc(69, 0, false);
  EXPECT_EQ(graph.arc_count(), 70U);
}

// Against closures by repeated squaring of the relation.
TEST(BlockingGraph, AgreesWithTheTransitiveClosure) {
  known::Random random(1);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + random() % 9;
    BlockingGraph graph(n);
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        reaches[i][j] = i == j || random() % 4 == 0;
        if (i != j) graph.set_arc(i, j, reaches[i][j]);
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) reaches[i][j] = reaches[i][j] || (reaches[i][k] && reaches[k][j]);
      }
    }
    bool is_strong = true;
    for (std::size_t i = 0; i < n; ++i) {
      const PartSet reached = graph.reachable(static_cast<std::uint32_t>(i), PartSet::all(n));
      for (std::size_t j = 0; j < n; ++j) {
        EXPECT_EQ(reached.contains(j), reaches[i][j]);
        is_strong = is_strong && reaches[i][j];
      }
    }
    EXPECT_EQ(graph.is_strongly_connected(PartSet::all(n)), is_strong);
  }
}

}  // namespace
}  // namespace quoin
