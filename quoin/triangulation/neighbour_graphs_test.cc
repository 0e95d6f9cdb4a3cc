// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/neighbour_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/regular3.h"
#include "quoin/triangulation/test_clouds.h"

namespace quoin {
namespace {

using testing::Cloud;
using testing::Random;

const Context& context() {
  static const Context one({.threads = 1});
  return one;
}

/// By their definitions, from all squared distances.
struct SlowGraphs {
  VertexPairs gabriel;
  VertexPairs relative;
  VertexPairs tree;

  explicit SlowGraphs(const AlphaComplex& alpha) {
    const auto n = static_cast<std::uint32_t>(alpha.spheres().size());
    std::vector<std::vector<Rational>> square(n, std::vector<Rational>(n));
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        const RationalPoint3 d = exact_point(alpha.spheres().point(i)) - exact_point(alpha.spheres().point(j));
        square[i][j] = dot(d, d);
      }
    }
    std::vector<std::tuple<Rational, std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t p = 0; p < n; ++p) {
      for (std::uint32_t q = p + 1; q < n; ++q) {
        bool is_gabriel = true;
        bool is_relative = true;
        for (std::uint32_t r = 0; r < n; ++r) {
          if (r == p || r == q) continue;
          is_gabriel = is_gabriel && square[p][r] + square[q][r] > square[p][q];
          is_relative = is_relative && (square[p][r] >= square[p][q] || square[q][r] >= square[p][q]);
        }
        if (is_gabriel) gabriel.push_back({p, q});
        if (is_relative) relative.push_back({p, q});
        pairs.emplace_back(square[p][q], p, q);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    DisjointSets trees(n);
    for (const auto& [length, p, q] : pairs) {
      if (trees.find(p) == trees.find(q)) continue;
      trees.unite(p, q);
      tree.push_back({p, q});
    }
    std::sort(tree.begin(), tree.end());
  }
};

void expect_by_definition(const AlphaComplex& alpha) {
  const SlowGraphs slow(alpha);
  const VertexPairs gabriel = gabriel_edges(alpha);
  const VertexPairs relative = relative_neighbours(alpha, context());
  const VertexPairs tree = minimum_spanning_tree(alpha, context());
  ASSERT_EQ(gabriel, slow.gabriel);
  ASSERT_EQ(relative, slow.relative);
  ASSERT_EQ(tree, slow.tree);
  ASSERT_TRUE(std::includes(gabriel.begin(), gabriel.end(), relative.begin(), relative.end()));
  ASSERT_TRUE(std::includes(relative.begin(), relative.end(), tree.begin(), tree.end()));
}

TEST(NeighbourGraphs, AreThoseOfTheirDefinitions) {
  Random random(1);
  for (int round = 0; round < test_rounds(3); ++round) {
    for (const Cloud& cloud : testing::clouds(random, 25)) {
      SCOPED_TRACE(cloud.name);
      expect_by_definition(AlphaComplex(Delaunay3(cloud.points, context()), context()));
      std::vector<Point2> plane;
      for (const Point3& p : cloud.points) plane.push_back({p.x, p.y});
      expect_by_definition(AlphaComplex(Delaunay2(plane, {}, context()), context()));
    }
  }
}

TEST(NeighbourGraphs, OfLattices) {
  const AlphaComplex cube(Delaunay3(testing::lattice(4, 4, 4), context()), context());
  EXPECT_EQ(gabriel_edges(cube).size(), 144U);
  EXPECT_EQ(relative_neighbours(cube, context()).size(), 144U);
  EXPECT_EQ(minimum_spanning_tree(cube, context()).size(), 63U);
}

/// Relative neighbours may be far from all common neighbours.
TEST(NeighbourGraphs, ManyPointsAboutOneEdge) {
  Random random(2);
  std::vector<Point3> points{{-1, 0, 0}, {1, 0, 0}};
  for (int i = 0; i < 60; ++i) {
    const Point3 direction = testing::near_sphere(random, 1)[0];
    const double size = 1.05 + 0.6 * testing::unit(random) * testing::unit(random);
    points.push_back({direction.x * size, direction.y * size, direction.z * size});
  }
  expect_by_definition(AlphaComplex(Delaunay3(points, context()), context()));
}

TEST(NeighbourGraphs, RefuseWeights) {
  const AlphaComplex weighted(Regular3(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}}, std::vector<double>{1, 2}, context()),
                              context());
  EXPECT_THROW(gabriel_edges(weighted), InputError);
  EXPECT_THROW(relative_neighbours(weighted, context()), InputError);
  EXPECT_THROW(minimum_spanning_tree(weighted, context()), InputError);
}

}  // namespace
}  // namespace quoin
