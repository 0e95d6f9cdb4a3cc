// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/unstable_sheet.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/test_flow.h"
#include "quoin/flow/test_scans.h"

namespace quoin {
namespace {

using testing::flow_complex;
using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

std::vector<std::uint32_t> critical(const FlowComplex& flow, unsigned dimension) {
  std::vector<std::uint32_t> found;
  for (const DeloneFace& face : flow.faces_of_kind(FlowKind::critical)) {
    if (face.dimension == dimension) found.push_back(face.index);
  }
  return found;
}

TEST(UnstableSheet, OfTwoPointsIsAPlane) {
  const FlowComplex flow = flow_complex({{0, 0, 0}, {2, 0, 0}});
  const UnstableSheet sheet = unstable_sheet(flow, 0, context());
  EXPECT_EQ(sheet.pieces.size(), 1U);
  EXPECT_TRUE(sheet.is_infinite);
  EXPECT_TRUE(sheet.saddles.empty());
}

TEST(UnstableSheet, OfACubeIsAQuarterPlane) {
  const FlowComplex flow = flow_complex(testing::lattice(2, 2, 2));
  for (const std::uint32_t e : critical(flow, 1)) {
    const UnstableSheet sheet = unstable_sheet(flow, e, context());
    EXPECT_EQ(sheet.pieces.size(), 1U);
    EXPECT_EQ(sheet.along.size(), 2U);
    EXPECT_EQ(sheet.saddles.size(), 2U);
    EXPECT_EQ(sheet.cells, (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(sheet.is_infinite);
  }
}

// The edge between the upper two points is no critical one: sheets of the sides go through its facet.
TEST(UnstableSheet, OfAKiteGoesThroughAFacet) {
  const FlowComplex flow = flow_complex({{-4, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, -10, 0}});
  std::multiset<std::size_t> pieces;
  for (const std::uint32_t e : critical(flow, 1)) {
    const UnstableSheet sheet = unstable_sheet(flow, e, context());
    pieces.insert(sheet.pieces.size());
    EXPECT_EQ(sheet.saddles.size(), 1U);
  }
  EXPECT_EQ(pieces, (std::multiset<std::size_t>{1, 1, 2, 2}));
  EXPECT_THROW(unstable_sheet(flow, 99, context()), InputError);
}

/// Sides of stable surfaces, found backwards, and saddles of sheets, found forwards: the same pairs.
void check_pairs(const FlowComplex& flow) {
  std::map<std::uint32_t, std::set<std::uint32_t>> backwards;
  std::set<std::uint32_t> doubtful;
  for (const std::uint32_t f : critical(flow, 2)) {
    const StableSurface surface = stable_surface(flow, f, context());
    if (!surface.is_ordinary()) doubtful.insert(f);
    for (const StableSide& side : surface.sides) backwards[side.edge].insert(f);
  }
  for (const std::uint32_t e : critical(flow, 1)) {
    const UnstableSheet sheet = unstable_sheet(flow, e, context());
    std::set<std::uint32_t> saddles(sheet.saddles.begin(), sheet.saddles.end());
    std::set<std::uint32_t> expected = backwards[e];
    for (const std::uint32_t f : doubtful) {
      saddles.erase(f);
      expected.erase(f);
    }
    ASSERT_EQ(saddles, expected);
  }
}

TEST(UnstableSheet, ReachesTheSaddlesWhoseSurfacesItBounds) {
  Random random(85);
  for (int round = 0; round < test_rounds(8); ++round) {
    check_pairs(flow_complex(testing::random_points(random, 10 + random() % 30, testing::unit)));
  }
  for (int round = 0; round < test_rounds(30); ++round) {
    check_pairs(
        flow_complex(testing::random_points(random, 12, [](Random& r) { return testing::small_integer(r, 6); })));
  }
  for (const testing::Cloud& scan : testing::rounded_scans(random, 25)) {
    SCOPED_TRACE(scan.name);
    check_pairs(flow_complex(scan.points));
  }
}

}  // namespace
}  // namespace quoin
