// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/projection.h"

#include <gtest/gtest.h>

#include <map>

#include "quoin/assembly/test_assemblies.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace test_assemblies;

/// What the first meets when it moves and the second stays.
Projection projection_of(const Points& moving, const Points& other) {
  Points reflected;
  for (const Point3& p : moving) reflected.push_back({-p.x, -p.y, -p.z});
  const Polytope p = Polytope::hull_of(other, one_thread);
  const Polytope q = Polytope::hull_of(reflected, one_thread);
  return project(minkowski_sum(p, q, one_thread), p, q);
}

void expect_closed_on_the_left(const ConvexRegion& region) {
  const std::size_t n = region.corners.size();
  if (n == 0) {
    EXPECT_EQ(region.normals.size(), 1U);
    return;
  }
  ASSERT_EQ(region.normals.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(dot_sign(region.normals[i], region.corners[i]), Sign::zero);
    EXPECT_EQ(dot_sign(region.normals[i], region.corners[(i + 1) % n]), Sign::zero);
    if (n > 2) {
      EXPECT_EQ(dot_sign(region.normals[i], region.corners[(i + 2) % n]), Sign::positive);
    }
  }
}

// A box on another one, beside its edge, at its corner, and away from it: 1K, phase 5.
TEST(Projection, PlacesOfTheOrigin) {
  const Points low = box({0, 0, 0}, {2, 2, 2});
  const Projection facet = projection_of(box({0, 0, 2}, {2, 2, 3}), low);
  EXPECT_EQ(facet.place, OriginPlace::facet);
  ASSERT_EQ(facet.region.normals.size(), 1U);
  EXPECT_EQ(text_of(facet.region.normals[0].exact()), "0 0 -1");
  const Projection edge = projection_of(box({2, 0, 2}, {3, 2, 3}), low);
  EXPECT_EQ(edge.place, OriginPlace::edge);
  EXPECT_EQ(edge.region.corners.size(), 2U);
  const Projection vertex = projection_of(box({2, 2, 2}, {3, 3, 3}), low);
  EXPECT_EQ(vertex.place, OriginPlace::vertex);
  EXPECT_EQ(vertex.region.corners.size(), 3U);
  const Projection away = projection_of(box({0, 0, 5}, {2, 2, 6}), low);
  EXPECT_EQ(away.place, OriginPlace::separated);
  EXPECT_EQ(away.region.corners.size(), 4U);
  EXPECT_EQ(projection_of(box({1, 1, 1}, {3, 3, 3}), low).place, OriginPlace::inside);
  EXPECT_EQ(projection_of(low, low).place, OriginPlace::inside);
}

// Trap 38: planes through the origin give a near and a far chain of edges, of which one arc is kept.
TEST(Projection, EdgesSeenInOnePlaneAreOneArc) {
  // Boxes whose sums with one another have facets in planes through the origin.
  const Projection level = projection_of(box({0, 0, 0}, {1, 1, 1}), box({3, 1, 1}, {4, 2, 2}));
  EXPECT_EQ(level.place, OriginPlace::separated);
  expect_closed_on_the_left(level.region);
  EXPECT_EQ(level.region.corners.size(), 4U);
  EXPECT_FALSE(level.region.contains(direction(1, 0, 0)));
  EXPECT_TRUE(level.region.contains(direction(8, 1, 1)));
}

// Trap 25: reflection is told from none by asymmetric bodies; the two ways of moving are opposite to one another.
TEST(Projection, OppositeWhenTheOtherMoves) {
  Random random(3);
  for (int round = 0; round < test_rounds(200); ++round) {
    Points a;
    Points b;
    for (int i = 0; i < 5; ++i) {
      a.push_back({double(random() % 4), double(random() % 4), double(random() % 4)});
      b.push_back({double(random() % 4) + 3, double(random() % 4), double(random() % 5)});
    }
    if (convex_hull(a, one_thread).dimension < 3 || convex_hull(b, one_thread).dimension < 3) continue;
    const Projection there = projection_of(a, b);
    const Projection back = projection_of(b, a);
    EXPECT_EQ(there.place, back.place);
    for (int k = 0; k < 20; ++k) {
      const SphereDirection d = random_direction(random);
      EXPECT_EQ(there.region.contains(d), back.region.contains(-d)) << text_of(d);
    }
  }
}

// Against rays cut with the facets of the hull of all differences.
TEST(Projection, AgreesWithRays) {
  Random random(7);
  std::map<OriginPlace, int> seen;
  for (int round = 0; round < test_rounds(600); ++round) {
    Points a;
    Points b;
    const double apart = double(random() % 4);
    for (int i = 0; i < 6; ++i) {
      a.push_back({double(random() % 3), double(random() % 3), double(random() % 3)});
      b.push_back({double(random() % 3) + apart, double(random() % 3), double(random() % 3)});
    }
    if (convex_hull(a, one_thread).dimension < 3 || convex_hull(b, one_thread).dimension < 3) continue;
    const Projection projection = projection_of(a, b);
    ++seen[projection.place];
    if (projection.place == OriginPlace::inside) continue;
    expect_closed_on_the_left(projection.region);
    for (int k = 0; k < 12; ++k) {
      const SphereDirection d = random_direction(random);
      ASSERT_EQ(projection.region.contains(d), hits(a, b, rational(d))) << "round " << round << ": " << text_of(d);
    }
    for (const RegionDirection& corner : projection.region.corners) {
      ASSERT_FALSE(hits(a, b, rational(corner.exact()))) << "a corner is not blocked";
    }
  }
  for (const OriginPlace place : {OriginPlace::facet, OriginPlace::edge, OriginPlace::vertex, OriginPlace::separated})
    EXPECT_GE(seen[place], test_cases(5)) << int(place);
}

// Differences of such coordinates are no doubles: directions and signs are exact all the same.
TEST(Projection, ExactWhereDifferencesRound) {
  const double tiny = 0x1p-60;
  const Points low = box({0, 0, 0}, {1, 1, 1});
  // Apart by less than what doubles tell of the difference.
  const Projection apart =
      projection_of(box({0, 0, 1}, {1, 1, 2}), {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0.5, 0.5, 1}});
  EXPECT_EQ(apart.place, OriginPlace::facet);
  const Projection above = projection_of(box({tiny, tiny, 1}, {1, 1, 2}), low);
  EXPECT_EQ(above.place, OriginPlace::facet);
  const Projection beside = projection_of(box({1 + 0x1p-52, tiny, tiny}, {2, 1, 1}), low);
  EXPECT_EQ(beside.place, OriginPlace::separated);
  expect_closed_on_the_left(beside.region);
  EXPECT_TRUE(beside.region.contains(direction(-1, 0, 0)));
  // Over the gap of 2^-52 these go 1/4 and 4 up.
  EXPECT_TRUE(beside.region.contains(direction(-1, std::int64_t{1} << 50, 0)));
  EXPECT_FALSE(beside.region.contains(direction(-1, std::int64_t{1} << 54, 0)));
}

}  // namespace
}  // namespace quoin
