// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "quoin/arrangement/family_suite.h"
#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/arrangement/geodesic/test_geodesics.h"

namespace quoin {
namespace {

using test_geodesics::all_draws;
using test_geodesics::Directions;
using test_geodesics::Draw;
using test_geodesics::is_zero;
using test_geodesics::Triple;

using Pieces = PieceList<GeodesicFamily>;

/// An arc that is given both ways; equal ends mean a circle.
struct Arc {
  Triple source;
  Triple target;
  Triple normal;
};

/// Arcs that share ends and planes often: a few directions and normals in all combinations that fit.
std::vector<Arc> draw_arcs(Directions& directions, std::size_t count) {
  std::vector<Triple> few;
  for (int i = 0; i < 6; ++i) few.push_back(directions.next());
  std::vector<Arc> arcs;
  while (arcs.size() < count) {
    const Triple& s = few[directions.below(few.size())];
    const Triple& t = few[directions.below(few.size())];
    const Triple normal = test_geodesics::cross_product(s, t);
    if (is_zero(normal)) continue;
    switch (directions.below(5)) {
      case 0:
        arcs.push_back({s, s, normal});
        break;
      case 1:
        arcs.push_back({s, test_geodesics::opposite(s), normal});
        break;
      case 2:
        arcs.push_back({s, t, test_geodesics::opposite(normal)});
        break;
      default:
        arcs.push_back({s, t, normal});
    }
  }
  return arcs;
}

TEST(GeodesicSuite, LawsOfCurveFamilies) {
  testing::FamilyCases cases;
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE("draw " + std::to_string(static_cast<int>(draw)) + " seed " + std::to_string(seed));
      Directions directions(draw, seed);
      GeodesicFamily family;
      Pieces list;
      Pieces backwards;
      for (const Arc& arc : draw_arcs(directions, 8)) {
        family.add_arc(list, arc.source, arc.target, arc.normal);
        family.add_arc(backwards, arc.target, arc.source, test_geodesics::opposite(arc.normal));
      }
      testing::check_reversed(family, list, backwards);
      if (HasFatalFailure()) return;
      const Triple normal = directions.next();
      family.add_great_circle(list, normal);
      family.add_great_circle(backwards, test_geodesics::opposite(normal));
      testing::check_reversed(family, list, backwards);
      if (HasFatalFailure()) return;
      family.add_point(list, directions.next());
      testing::check_family_laws(family, list, &cases);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(cases.vertical, 100U);
  EXPECT_GT(cases.overlapping, 100U);
  EXPECT_GT(cases.common_end, 100U);
  EXPECT_EQ(cases.touching, 0U);
  EXPECT_GT(cases.crossing, 100U);
  EXPECT_GT(cases.multiple, 100U);
  EXPECT_GT(cases.reversed, 100U);
  EXPECT_GT(cases.repeated, 100U);
  EXPECT_GT(cases.met_by_sweep, 100U);
}

}  // namespace
}  // namespace quoin
