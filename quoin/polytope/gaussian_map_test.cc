// SPDX-License-Identifier: Apache-2.0
//
// Counts of published maps, and the way back from a map to its polytope.
#include "quoin/polytope/gaussian_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

/// Vertices, halfedges, faces.
std::array<std::size_t, 3> counts_of_map(const Points& points) {
  const Polytope p = Polytope::hull_of(points, one_thread);
  const GaussianMap map = gaussian_map(p, one_thread);
  dcel::check_links(map.arrangement.cells());
  // Every vertex is extreme in one face's directions.
  std::vector<std::uint32_t> labels = map.vertex_of_face;
  std::sort(labels.begin(), labels.end());
  EXPECT_TRUE(std::adjacent_find(labels.begin(), labels.end()) == labels.end());
  EXPECT_EQ(labels.size(), p.vertex_count());
  EXPECT_EQ(rings_of(facets_of_map(map)), rings_of(p));
  const dcel::Counts counts = map.arrangement.counts();
  return {counts.vertices, 2 * counts.edges, counts.faces};
}

// Minkowski thesis, tables of basic solids.
TEST(GaussianMap, PublishedCounts) {
  using Counts = std::array<std::size_t, 3>;
  EXPECT_EQ(counts_of_map({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}), (Counts{10, 28, 6}));
  EXPECT_EQ(counts_of_map({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}), (Counts{7, 18, 4}));
  EXPECT_EQ(counts_of_map({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), (Counts{4, 12, 4}));
  EXPECT_EQ(counts_of_map(icosahedron()), (Counts{23, 66, 12}));
  EXPECT_EQ(counts_of_map(icosahedron_on_its_pole()), (Counts{21, 62, 12}));
  EXPECT_EQ(counts_of_map(pyramid()), (Counts{25, 80, 17}));
}

TEST(GaussianMap, OfASumOfEqualsIsThatOfOne) {
  const Polytope p = Polytope::hull_of(icosahedron_on_its_pole(), one_thread);
  const PolytopeSum sum = minkowski_sum(p, p, one_thread);
  const GaussianMap map = gaussian_map(map_arcs(sum, p, p), one_thread);
  const dcel::Counts counts = map.arrangement.counts();
  EXPECT_EQ(counts.vertices, 21U);
  EXPECT_EQ(counts.edges, 31U);
  EXPECT_EQ(counts.faces, 12U);
}

TEST(GaussianMap, OfFlatOnes) {
  counts_of_map({{0, 0, 0}, {4, 0, 1}, {0, 4, 2}, {4, 4, 3}});
  counts_of_map({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  counts_of_map({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

// Of what is no solid: lunes, two half spheres, all of the sphere. Facets that are cut arcs are none.
TEST(GaussianMap, OfEveryDimension) {
  using Counts = std::array<std::size_t, 3>;
  EXPECT_EQ(counts_of_map({{1, 2, 3}}), (Counts{0, 0, 1}));
  EXPECT_EQ(counts_of_map({{1, 2, 3}, {0, 0, 0}})[2], 2U);
  EXPECT_EQ(counts_of_map({{0, 0, 0}, {0, 0, 2}})[2], 2U);
  EXPECT_EQ(counts_of_map({{0, 0, 0}, {3, 0, 0}})[2], 2U);
  EXPECT_EQ(counts_of_map({{0, 0, 0}, {1, 1, 0}, {0, 1, 2}})[2], 3U);
}

TEST(GaussianMap, OfRandomPolytopesAndBack) {
  for (std::uint64_t seed = 0; seed < test_rounds(400U); ++seed) {
    std::mt19937_64 random(seed);
    const int size = 2 + static_cast<int>(random() % 30);
    Points points;
    for (std::uint64_t i = 4 + random() % 20; i > 0; --i) {
      const auto draw = [&] { return double(static_cast<int>(random() % static_cast<std::uint64_t>(size))); };
      points.push_back({draw(), draw(), draw()});
    }
    if (convex_hull(points, one_thread).dimension < 3) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    counts_of_map(points);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace quoin
