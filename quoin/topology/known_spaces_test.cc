// SPDX-License-Identifier: Apache-2.0
// Homology of spaces whose answer is known without computing it.
#include <gtest/gtest.h>

#include <map>

#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/persistence.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

using Chain = std::map<Row, int>;

// A chain of edges or triangles given by vertex labels, as a sum of boundary columns.
Chain boundary_of(const std::vector<std::pair<int, Row>>& chain) {
  Chain sum;
  for (const auto& [times, simplex] : chain) {
    for (std::size_t j = 0; j < simplex.size(); ++j) {
      Row facet = simplex;
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
      Row sorted = facet;
      std::sort(sorted.begin(), sorted.end());
      int sign = j % 2 == 0 ? 1 : -1;
      if (facet.size() == 2 && facet != sorted) sign = -sign;
      sum[sorted] += times * sign;
    }
  }
  std::erase_if(sum, [](const auto& entry) { return entry.second == 0; });
  return sum;
}

Chain sum_of(const Chain& a, const Chain& b, int times) {
  Chain sum = a;
  for (const auto& [simplex, value] : b) sum[simplex] += times * value;
  std::erase_if(sum, [](const auto& entry) { return entry.second == 0; });
  return sum;
}

// Whether a chain of edges bounds, over the rationals or modulo a prime.
template <class Rank>
bool bounds(const SimplicialComplex& complex, const Chain& edges, const Rank& rank) {
  Dense rows = dense_boundary(complex, 2);
  const std::size_t before = rank(rows);
  rows.emplace_back(complex.count(1), 0);
  for (const auto& [edge, value] : edges) rows.back()[complex.find_labels(edge)->index] = value;
  return rank(rows) == before;
}

TEST(KnownSpaces, ChainsOfAnAnnulus) {  // H6
  const SimplexList list = annulus();
  std::vector<std::pair<int, Row>> gamma;
  for (std::size_t i = 0; i < list.size(); ++i) gamma.emplace_back(1, Row(list[i].begin(), list[i].end()));
  const Chain alpha{{{4, 5}, 1}, {{5, 6}, 1}, {{4, 6}, -1}};
  const Chain beta{{{1, 2}, 1}, {{2, 3}, 1}, {{1, 3}, -1}};
  const auto boundary_of_edges = [](const Chain& chain) {
    std::vector<std::pair<int, Row>> edges;
    for (const auto& [edge, times] : chain) edges.emplace_back(times, edge);
    return boundary_of(edges);
  };
  // The rims are cycles that do not bound, and the six triangles bound their difference.
  EXPECT_EQ(boundary_of_edges(alpha), Chain{});
  EXPECT_EQ(boundary_of_edges(beta), Chain{});
  EXPECT_EQ(boundary_of(gamma), sum_of(alpha, beta, -1));
  const SimplicialComplex complex = closure(list);
  EXPECT_FALSE(bounds(complex, alpha, rational_rank));
  EXPECT_FALSE(bounds(complex, beta, rational_rank));
  EXPECT_TRUE(bounds(complex, sum_of(alpha, beta, -1), rational_rank));
  // One sign wrong, and the rim is no cycle.
  EXPECT_EQ(boundary_of_edges({{{4, 5}, 1}, {{5, 6}, 1}, {{4, 6}, 1}}), (Chain{{{4}, -2}, {{6}, 2}}));
}

TEST(KnownSpaces, VerticesOfAConnectedGraphAreHomologous) {  // H7
  EXPECT_EQ(boundary_of({{-1, {1, 2}}, {1, {1, 4}}, {1, {4, 6}}}), (Chain{{{6}, 1}, {{2}, -1}}));
  EXPECT_EQ(integers(closure({{1, 2}, {1, 4}, {4, 6}, {2, 3}, {3, 5}, {5, 6}})).betti[0], 1U);
}

TEST(KnownSpaces, TheLastTriangleOfTheProjectivePlane) {  // H4
  const SimplicialComplex before = closure(triangles({412, 423, 531, 512, 623, 631, 453, 562, 641}));
  const SimplicialComplex after = closure(six_vertex_projective_plane());
  EXPECT_EQ(integers(before).betti[1] - integers(after).betti[1], 1U);
  EXPECT_EQ(over(after, 2)[2] - over(before, 2)[2], 1U);
  EXPECT_EQ(over(after, 2)[1], over(before, 2)[1]);
  // Its rim goes twice around the loop 12, 23, 13, one way or the other: no boundary over the rationals, one modulo 2.
  const Chain rim = boundary_of({{1, {4, 5, 6}}});
  const Chain loop{{{1, 2}, 1}, {{2, 3}, 1}, {{1, 3}, -1}};
  const auto modulo_2 = [](const Dense& d) { return rank_modulo(d, 2); };
  EXPECT_NE(bounds(before, sum_of(rim, loop, 2), rational_rank), bounds(before, sum_of(rim, loop, -2), rational_rank));
  EXPECT_FALSE(bounds(before, rim, rational_rank));
  EXPECT_TRUE(bounds(before, rim, modulo_2));
  EXPECT_FALSE(bounds(before, loop, modulo_2));
}

// Tori in a row, each joined to the next along a triangle.
SimplexList surface_of_genus(std::uint32_t g) {
  SimplexList list;
  for (std::uint32_t i = 0; i < g; ++i) {
    const SimplexList torus = glued_grid(4, 4, false);
    for (std::size_t t = 0; t < torus.size(); ++t) {
      Row row;
      for (const std::uint32_t v : torus[t]) row.push_back(16 * i + v);
      // Triangle 0 of each goes, and that at the far corner, whose vertices become those of the next one's triangle 0.
      if ((t == 0 && i > 0) || (t == 20 && i + 1 < g)) continue;
      list.add(row);
    }
  }
  const SimplexList torus = glued_grid(4, 4, false);
  SimplexList glued;
  for (std::size_t t = 0; t < list.size(); ++t) {
    Row row(list[t].begin(), list[t].end());
    for (std::uint32_t& v : row) {
      const std::uint32_t i = v / 16;
      if (i == 0) continue;
      for (std::size_t j = 0; j < 3; ++j)
        if (v % 16 == torus[0][j]) {
          v = 16 * (i - 1) + torus[20][j];
          break;
        }
    }
    glued.add(row);
  }
  return glued;
}

TEST(KnownSpaces, SurfacesOfEveryGenus) {  // H9
  for (std::uint32_t g = 1; g <= 6; ++g) {
    const SimplicialComplex surface = closure(surface_of_genus(g));
    EXPECT_EQ(integers(surface).betti, (Betti{1, 2 * g, 1})) << g;
    EXPECT_EQ(over(surface, 2), (Betti{1, 2 * g, 1})) << g;
    EXPECT_EQ(surface.euler_characteristic(), 2 - 2 * static_cast<std::int64_t>(g));
  }
}

TEST(KnownSpaces, ConesBallsAndSpheres) {  // H11, H12, H15
  std::mt19937_64 random(3);
  for (int round = 0; round < test_rounds(20); ++round) {
    const SimplicialComplex cone = closure(join(random_simplices(random, 9, 3, 8), SimplexList{{0}}));
    Betti point(cone.dimension() + 1, 0);
    point[0] = 1;
    ASSERT_EQ(integers(cone).betti, point);
  }
  for (std::uint32_t d = 1; d < 8; ++d) {
    Betti ball(d + 1, 0);
    ball[0] = 1;
    EXPECT_EQ(integers(closure(full_simplex(d))).betti, ball);
    ball[d] = 1;
    EXPECT_EQ(integers(closure(sphere(d))).betti, ball);
    EXPECT_EQ(over(closure(sphere(d)), 2), ball);
  }
  // A solid torus: a ring of cubes, the first and last of which share a side.
  SimplexList ring;
  const SimplexList row = cubes(5, 1, 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    Row simplex;
    for (const std::uint32_t v : row[i]) simplex.push_back(v % 20);
    ring.add(simplex);
  }
  EXPECT_EQ(integers(closure(ring)).betti, (Betti{1, 1, 0, 0}));
}

// A grid of three cubes in each direction of a space of dimension d, each cut into d! simplices around a diagonal.
SimplexList cubes_of_dimension(std::uint32_t d) {
  SimplexList list;
  for (std::uint32_t cube = 0; cube < 1U << 2 * d; ++cube) {
    std::uint32_t corner = 0;  // two bits for each coordinate
    bool is_inside = true;
    for (std::uint32_t axis = 0; axis < d; ++axis) is_inside &= (cube >> 2 * axis & 3) < 3;
    if (!is_inside) continue;
    Row axes(d);
    std::iota(axes.begin(), axes.end(), 0U);
    do {
      corner = cube;
      Row row{corner};
      for (const std::uint32_t axis : axes) row.push_back(corner += 1U << 2 * axis);
      list.add(row);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return list;
}

/// Space without a point, as all cubes but the middle one: a sphere around the gap or on the outside at grade 0, all
/// but the gap at 1, the gap at 2.
Filtration space_without_a_point(std::uint32_t d, bool is_outer) {
  Filtration filtration{closure(cubes_of_dimension(d)), {}};
  for (int k = 0; k <= filtration.complex.dimension(); ++k) {
    filtration.grade.emplace_back();
    for (std::uint32_t i = 0; i < filtration.complex.count(k); ++i) {
      std::array<bool, 4> is_flat{};  // whether some coordinate is the same for all vertices, and which
      bool is_in_middle = true;
      const Row vertices = filtration.complex.labels({k, i});
      for (std::uint32_t axis = 0; axis < d; ++axis) {
        std::array<bool, 4> has{};
        for (const std::uint32_t v : vertices) has[v >> 2 * axis & 3] = true;
        is_in_middle &= !has[0] && !has[3];
        for (std::size_t x = 0; x < 4; ++x) is_flat[x] |= has[x] && std::count(has.begin(), has.end(), true) == 1;
      }
      const bool is_gap = is_in_middle && !is_flat[1] && !is_flat[2];
      const bool is_sphere = is_outer ? is_flat[0] || is_flat[3] : is_in_middle && !is_gap;
      filtration.grade.back().push_back(is_gap ? 2 : is_sphere ? 0 : 1);
    }
  }
  return filtration;
}

// Both spheres have the homology of all but the gap, by inclusion: classes of theirs and no others, until it is filled.
TEST(KnownSpaces, SpaceWithoutAPointIsASphere) {  // H15
  for (std::uint32_t d = 1; d <= 4; ++d) {
    for (const bool is_outer : {false, true}) {
      const Filtration filtration = space_without_a_point(d, is_outer);
      for (const std::uint32_t p : {2U, 3U}) {
        const std::vector<PersistencePair> pairs = persistence(filtration, {.prime = p}, Context());
        ASSERT_EQ(pairs.size(), 2U) << d;
        for (const PersistencePair& pair : pairs) {
          EXPECT_EQ(filtration.grade[pair.degree][pair.birth], 0U);
          if (pair.death == PersistencePair::never) {
            EXPECT_EQ(pair.degree, 0);
          } else {
            EXPECT_EQ(pair.degree, static_cast<int>(d) - 1);
            EXPECT_EQ(filtration.grade[d][pair.death], 2U);
          }
        }
        Betti sphere_of_d(d + 1, 0);
        ++sphere_of_d[0];
        ++sphere_of_d[d - 1];
        EXPECT_EQ(betti_numbers_at(filtration, pairs, 1), sphere_of_d);
      }
    }
    // The same over the integers, without the gap.
    SimplexList shell;
    const SimplexList all = cubes_of_dimension(d);
    std::uint32_t middle = 0;
    for (std::uint32_t axis = 0; axis < d; ++axis) middle |= 1U << 2 * axis;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i][0] != middle) shell.add(all[i]);
    const IntegerHomology homology = integers(closure(shell));
    Betti expected(d + 1, 0);
    ++expected[0];
    ++expected[d - 1];
    EXPECT_EQ(homology.betti, expected);
    EXPECT_TRUE(torsion_primes(homology).empty());
  }
}

TEST(KnownSpaces, EqualBettiNumbersOfSpacesThatDiffer) {  // H13
  EXPECT_EQ(integers(closure(annulus())).betti, (Betti{1, 1, 0}));
  EXPECT_EQ(integers(closure(sphere(1))).betti, (Betti{1, 1}));
}

}  // namespace
}  // namespace quoin
