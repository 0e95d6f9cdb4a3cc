// SPDX-License-Identifier: Apache-2.0
//
// Counts of published maps, and the way back from a map to its polytope.
#include "quoin/polytope/gaussian_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"
#include "quoin/polytope/hull.h"
#include "quoin/polytope/test_polytopes.h"

namespace quoin {
namespace {

using namespace test_polytopes;

using Facets = std::set<std::vector<std::uint32_t>>;

std::vector<std::uint32_t> rotated(std::vector<std::uint32_t> facet) {
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  return facet;
}

Facets facets_of(const Polytope& p) {
  Facets facets;
  for (std::uint32_t f = 0; f < p.facet_count(); ++f) {
    std::vector<std::uint32_t> facet;
    std::uint32_t h = p.first_halfedge(f);
    do {
      facet.push_back(p.halfedges()[h].tail);
      h = p.halfedges()[h].next;
    } while (h != p.first_halfedge(f));
    facets.insert(rotated(facet));
  }
  return facets;
}

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
  Facets back;
  for (const std::vector<std::uint32_t>& facet : facets_of_map(map)) back.insert(rotated(facet));
  EXPECT_EQ(back, facets_of(p));
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
  // With two vertices as poles; rounded, and yet its own mirror image in the plane y = 0.
  Points turned{{0, 0, 1}, {0, 0, -1}};
  const double r = 2 / std::sqrt(5.0);
  for (int i = 0; i <= 5; ++i) {
    const double angle = 3.14159265358979323846 / 5 * i;
    const double z = (i % 2 == 0 ? 1 : -1) / std::sqrt(5.0);
    const double y = i == 0 || i == 5 ? 0 : r * std::sin(angle);
    for (const int side : {-1, 1}) turned.push_back({r * std::cos(angle), side * y, z});
  }
  EXPECT_EQ(counts_of_map(turned), (Counts{21, 62, 12}));
  // The pyramid over a polygon of sixteen sides.
  Points pyramid{{0, -20, 0}};
  for (const auto& [x, z] : {std::pair{20, 0}, {18, 8}, {14, 14}, {8, 18}, {0, 20}}) {
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) pyramid.push_back({double(s * x), 0, double(t * z)});
    }
  }
  EXPECT_EQ(counts_of_map(pyramid), (Counts{25, 80, 17}));
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
