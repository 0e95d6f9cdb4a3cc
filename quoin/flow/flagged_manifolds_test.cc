// SPDX-License-Identifier: Apache-2.0
// Manifolds that are not what they are in general position: all of them are listed, and nothing else is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/flow/flow_chains.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"
#include "quoin/flow/unstable_arcs.h"
#include "quoin/flow/unstable_sheet.h"

namespace quoin {
namespace {

using testing::Random;
using Counts = std::array<std::size_t, 4>;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

struct Seen {
  std::size_t ordinary = 0;  // sets of points
  std::size_t surfaces = 0;  // that are flagged, and so
  std::size_t arcs = 0;
  std::size_t sheets = 0;
  std::size_t no_complexes = 0;  // sets of points whose chains are none
};

/// What single manifolds say of themselves.
struct Flags {
  std::vector<std::uint32_t> surfaces;  ///< by places among the saddles
  std::vector<std::uint32_t> arcs;
  std::size_t with_voronoi_vertex = 0;
  std::size_t with_solid_part = 0;
  std::size_t with_regular_point = 0;
  std::size_t passed_regular = 0;
  std::size_t in_saddles = 0;
};

Flags flags_of(const FlowComplex& flow, const std::vector<std::uint32_t>& saddles) {
  Flags flags;
  ArcTracer tracer(flow);
  for (std::uint32_t i = 0; i < saddles.size(); ++i) {
    const StableSurface surface = stable_surface(flow, saddles[i], context());
    if (!surface.is_ordinary()) flags.surfaces.push_back(i);
    flags.with_voronoi_vertex += surface.has_voronoi_vertex ? 1 : 0;
    flags.with_solid_part += surface.has_solid_part ? 1 : 0;
    flags.with_regular_point += surface.has_regular_point ? 1 : 0;
    bool is_ordinary = true;
    for (const UnstableArc& arc : tracer.trace(saddles[i], context()).arcs) {
      const bool ends_well = arc.is_infinite || (arc.end.dimension == 3 && flow.is_critical(arc.end));
      is_ordinary &= ends_well && !arc.has_passed_regular;
      flags.passed_regular += arc.has_passed_regular ? 1 : 0;
      flags.in_saddles += ends_well ? 0 : 1;
    }
    if (!is_ordinary) flags.arcs.push_back(i);
  }
  return flags;
}

std::size_t union_size(const ManifoldList& a, const ManifoldList& b) {
  std::set<std::uint32_t> all(a.begin(), a.end());
  all.insert(b.begin(), b.end());
  return all.size();
}

void check_surveys(const Delaunay3& triangulation, const FlowComplex& flow, const Flags& flags, Seen& seen) {
  const FlowCells cells(triangulation, context());
  const StableSurvey stable = survey_stable(cells, context());
  ASSERT_EQ(stable.with_voronoi_vertex.size(), flags.with_voronoi_vertex);
  ASSERT_EQ(stable.with_solid_part.size(), flags.with_solid_part);
  ASSERT_EQ(stable.with_regular_point.size(), flags.with_regular_point);
  const UnstableSurvey unstable = survey_unstable(cells, context());
  ASSERT_EQ(unstable.passed_regular.size(), flags.passed_regular);
  ASSERT_EQ(unstable.in_saddles.size(), flags.in_saddles);
  std::size_t sheets = 0;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    if (face.dimension == 1) sheets += unstable_sheet(flow, face.index, context()).is_ordinary ? 0 : 1;
  }
  const SheetSurvey survey = survey_sheets(cells, context());
  ASSERT_EQ(union_size(survey.with_regular_point, survey.with_stationary_end), sheets);
  seen.sheets += sheets;
}

// Lists are those of the manifolds that say so. A surface that does not has a cycle of critical edges as boundary;
// where none does, and no arc, the chains are a complex with the homology of a point.
void check(const std::vector<Point3>& points, Seen& seen) {
  const Delaunay3 triangulation(points, context());
  const FlowComplex flow(triangulation, context());
  const FlowChains chains = flow_chains(flow, context());
  const Flags flags = flags_of(flow, chains.cells[2]);
  ASSERT_EQ(chains.surfaces_not_ordinary, flags.surfaces);
  ASSERT_EQ(chains.arcs_not_ordinary, flags.arcs);
  for (std::uint32_t i = 0; i < chains.cells[2].size(); ++i) {
    if (std::binary_search(flags.surfaces.begin(), flags.surfaces.end(), i)) continue;
    std::set<std::uint32_t> ends;
    for (const std::uint32_t edge : chains.boundaries[2][i]) {
      for (const std::uint32_t vertex : chains.boundaries[1][edge]) {
        if (!ends.erase(vertex)) ends.insert(vertex);
      }
    }
    ASSERT_TRUE(ends.empty());
  }
  ASSERT_EQ(chains.is_ordinary(), flags.surfaces.empty() && flags.arcs.empty());
  const bool is_complex = is_chain_complex(chains);
  if (chains.is_ordinary()) {
    ASSERT_TRUE(is_complex);
    ASSERT_EQ(flow_betti_numbers(flow, chains), (Counts{1, 0, 0, 0}));
  }
  seen.ordinary += chains.is_ordinary() ? 1 : 0;
  seen.surfaces += flags.surfaces.size();
  seen.arcs += flags.arcs.size();
  seen.no_complexes += is_complex ? 0 : 1;
  if (triangulation.dimension() == 3) {
    ASSERT_NO_FATAL_FAILURE(check_surveys(triangulation, flow, flags, seen));
  }
}

TEST(FlaggedManifolds, AreListedAndNothingElseIsWrong) {
  Random random(181);
  Seen seen;
  for (const testing::Cloud& cloud : testing::flow_clouds(random, 8)) {
    SCOPED_TRACE(cloud.name);
    ASSERT_NO_FATAL_FAILURE(check(cloud.points, seen));
  }
  for (int round = 0; round < test_rounds(40); ++round) {
    SCOPED_TRACE(round);
    std::vector<Point3> points(10);
    for (Point3& p : points) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = testing::small_integer(random, 1 + round % 4);
    }
    ASSERT_NO_FATAL_FAILURE(check(points, seen));
  }
  EXPECT_GT(seen.ordinary, test_cases(10U));
  EXPECT_GT(seen.surfaces, test_cases(50U));
  EXPECT_GT(seen.arcs, test_cases(20U));
  EXPECT_GT(seen.sheets, test_cases(100U));
  EXPECT_GT(seen.no_complexes, test_cases(2U));
}

TEST(FlaggedManifolds, OfRoundedScans) {
  Random random(182);
  Seen seen;
  for (const std::size_t count : {6U, 7U, 8U, 15U, 40U, 70U}) {
    for (const testing::Cloud& scan : testing::rounded_scans(random, count)) {
      SCOPED_TRACE(scan.name + " of " + std::to_string(count));
      ASSERT_NO_FATAL_FAILURE(check(scan.points, seen));
    }
  }
  EXPECT_GT(seen.ordinary, 3U);
  EXPECT_GT(seen.surfaces, 50U);
  EXPECT_GT(seen.arcs, 3U);
  EXPECT_GT(seen.sheets, 100U);
}

}  // namespace
}  // namespace quoin
