// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/homology.h"

#include <gtest/gtest.h>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/number/rational.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

std::size_t rational_rank(const Dense& dense) {
  std::vector<std::vector<Rational>> rows;
  for (const auto& row : dense) rows.emplace_back(row.begin(), row.end());
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t j = 0; j < columns; ++j) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][j].sign() == Sign::zero) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      if (rows[i][j].sign() == Sign::zero) continue;
      const Rational f = rows[i][j] / rows[rank][j];
      for (std::size_t l = j; l < columns; ++l) rows[i][l] -= f * rows[rank][l];
    }
    ++rank;
  }
  return rank;
}

Betti over(const SimplicialComplex& complex, std::uint32_t p) {
  return betti_numbers(complex, p, Context());
}
IntegerHomology integers(const SimplicialComplex& complex) {
  return integer_homology(complex, Context());
}

// Every answer by two ways, and those of different coefficients against each other.
void check_all(const SimplicialComplex& complex) {
  const IntegerHomology homology = integers(complex);
  ASSERT_EQ(homology.betti, betti_by_ranks(complex, rational_rank));
  std::int64_t alternating = 0;
  for (std::size_t k = 0; k < homology.betti.size(); ++k)
    alternating += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(homology.betti[k]);
  ASSERT_EQ(alternating, complex.euler_characteristic());
  if (complex.dimension() >= 0) {
    ASSERT_EQ(homology.betti[0], connected_components(complex).count);
  }
  const OrderedBoundaries boundaries = collapsed(complex, Context());
  ASSERT_EQ(integer_homology(boundaries, Context()).torsion, homology.torsion);
  for (const std::uint32_t p : {2U, 3U, 5U, 7U}) {
    const Betti betti = over(complex, p);
    ASSERT_EQ(betti, betti_numbers(boundaries, p, Context())) << p;
    ASSERT_EQ(betti, betti_by_ranks(complex, [&](const Dense& d) { return rank_modulo(d, p); })) << p;
    ASSERT_EQ(betti, betti_numbers(homology, p)) << p;
  }
  for (const auto& orders : homology.torsion) {
    for (std::size_t i = 0; i < orders.size(); ++i) {
      ASSERT_GT(orders[i], Integer(1));
      if (i > 0) {
        ASSERT_NE(mpz_divisible_p(orders[i].raw(), orders[i - 1].raw()), 0);
      }
    }
  }
}

struct Known {
  const char* name;
  SimplexList list;
  std::vector<std::size_t> counts;
  Betti rational;
  Betti two;
  Betti three;
  std::vector<std::vector<Integer>> torsion;
};

std::vector<Known> known_answers() {
  const std::vector<std::vector<Integer>> none3(3);
  return {
      {"H1 torus", seven_vertex_torus(), {7, 21, 14}, {1, 2, 1}, {1, 2, 1}, {1, 2, 1}, none3},
      {"H2 boundary of a tetrahedron",
       triangles({123, 134, 142, 243}),
       {4, 6, 4},
       {1, 0, 1},
       {1, 0, 1},
       {1, 0, 1},
       none3},
      {"H3 projective plane",
       six_vertex_projective_plane(),
       {6, 15, 10},
       {1, 0, 0},
       {1, 1, 1},
       {1, 0, 0},
       {{}, {2}, {}}},
      {"H4 without a triangle",
       triangles({412, 423, 531, 512, 623, 631, 453, 562, 641}),
       {6, 15, 9},
       {1, 1, 0},
       {1, 1, 0},
       {1, 1, 0},
       none3},
      {"H5 tree", {{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 5}}, {6, 5}, {1, 0}, {1, 0}, {1, 0}, {{}, {}}},
      {"H6 annulus", annulus(), {6, 12, 6}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}, none3},
      {"H10 Klein bottle", glued_grid(4, 4, true), {16, 48, 32}, {1, 1, 0}, {1, 2, 1}, {1, 1, 0}, {{}, {2}, {}}},
      {"H12 3-sphere", sphere(3), {5, 10, 10, 5}, {1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {{}, {}, {}, {}}},
      {"H12 0-sphere", sphere(0), {2}, {2}, {2}, {2}, {{}}},
      {"H13 circle", sphere(1), {3, 3}, {1, 1}, {1, 1}, {1, 1}, {{}, {}}},
      {"Moore space of 3", moore_space(3), {13, 39, 27}, {1, 0, 0}, {1, 0, 0}, {1, 1, 1}, {{}, {3}, {}}},
      {"suspended projective plane",
       join(six_vertex_projective_plane(), sphere(0)),
       {8, 27, 40, 20},
       {1, 0, 0, 0},
       {1, 0, 1, 1},
       {1, 0, 0, 0},
       {{}, {}, {2}, {}}},
  };
}

TEST(Homology, KnownAnswers) {
  for (const Known& known : known_answers()) {
    SCOPED_TRACE(known.name);
    const SimplicialComplex complex = closure(known.list);
    for (std::size_t k = 0; k < known.counts.size(); ++k)
      EXPECT_EQ(complex.count(static_cast<int>(k)), known.counts[k]);
    const IntegerHomology homology = integers(complex);
    EXPECT_EQ(homology.betti, known.rational);
    EXPECT_EQ(homology.torsion, known.torsion);
    EXPECT_EQ(over(complex, 2), known.two);
    EXPECT_EQ(over(complex, 3), known.three);
    check_all(complex);
  }
}

TEST(Homology, RanksOfTheBook) {
  const auto ranks = [](const SimplexList& list) {
    const SimplicialComplex complex = closure(list);
    std::vector<std::size_t> result;
    for (int k = 1; k <= complex.dimension(); ++k) result.push_back(rational_rank(dense_boundary(complex, k)));
    return result;
  };
  EXPECT_EQ(ranks(seven_vertex_torus()), (std::vector<std::size_t>{6, 13}));                  // H1
  EXPECT_EQ(ranks(triangles({123, 134, 142, 243})), (std::vector<std::size_t>{3, 3}));        // H2
  EXPECT_EQ(ranks({{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 5}}), (std::vector<std::size_t>{5}));  // H5
  const Dense plane = dense_boundary(closure(six_vertex_projective_plane()), 2);              // H3
  EXPECT_EQ(rational_rank(plane), 10U);
  EXPECT_EQ(rank_modulo(plane, 2), 9U);
}

// A chain of edges or triangles given by vertex labels, as a sum of boundary columns.
std::map<Row, int> boundary_of(const std::vector<std::pair<int, Row>>& chain) {
  std::map<Row, int> sum;
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

TEST(Homology, ChainsOfTheBook) {
  // H6: the six triangles bound the difference of the two rims.
  std::vector<std::pair<int, Row>> gamma;
  const SimplexList list = annulus();
  for (std::size_t i = 0; i < list.size(); ++i) gamma.emplace_back(1, Row(list[i].begin(), list[i].end()));
  EXPECT_EQ(boundary_of(gamma),
            (std::map<Row, int>{{{4, 5}, 1}, {{5, 6}, 1}, {{4, 6}, -1}, {{1, 2}, -1}, {{2, 3}, -1}, {{1, 3}, 1}}));
  // H7: two vertices of a connected graph are homologous.
  EXPECT_EQ(boundary_of({{-1, {1, 2}}, {1, {1, 4}}, {1, {4, 6}}}), (std::map<Row, int>{{{6}, 1}, {{2}, -1}}));
  EXPECT_EQ(integers(closure({{1, 2}, {1, 4}, {4, 6}, {2, 3}, {3, 5}, {5, 6}})).betti[0], 1U);
}

TEST(Homology, TheLastTriangleOfTheProjectivePlane) {  // H4
  const SimplicialComplex before = closure(triangles({412, 423, 531, 512, 623, 631, 453, 562, 641}));
  const SimplicialComplex after = closure(six_vertex_projective_plane());
  EXPECT_EQ(integers(before).betti[1] - integers(after).betti[1], 1U);
  EXPECT_EQ(over(after, 2)[2] - over(before, 2)[2], 1U);
  EXPECT_EQ(over(after, 2)[1], over(before, 2)[1]);
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

TEST(Homology, SurfacesOfEveryGenus) {  // H9
  for (std::uint32_t g = 1; g <= 6; ++g) {
    const SimplicialComplex surface = closure(surface_of_genus(g));
    EXPECT_EQ(integers(surface).betti, (Betti{1, 2 * g, 1})) << g;
    EXPECT_EQ(over(surface, 2), (Betti{1, 2 * g, 1})) << g;
    EXPECT_EQ(surface.euler_characteristic(), 2 - 2 * static_cast<std::int64_t>(g));
  }
}

TEST(Homology, ConesBallsAndSpheres) {  // H11, H12, H15
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

TEST(Homology, TheFewestVerticesOfASurface) {  // H14: the bound, and the surfaces that attain it
  const auto bound = [](std::int64_t euler) {
    std::int64_t n = 4;
    while ((2 * n - 7) * (2 * n - 7) < 49 - 24 * euler) ++n;
    return static_cast<std::size_t>(n);
  };
  const std::vector<std::pair<std::int64_t, std::size_t>> listed{{2, 4},  {1, 6},  {0, 7},  {-1, 8},
                                                                 {-2, 9}, {-3, 9}, {-4, 10}};
  for (const auto& entry : listed) EXPECT_EQ(bound(entry.first), entry.second);
  for (const SimplexList& list : {sphere(2), six_vertex_projective_plane(), seven_vertex_torus()}) {
    const SimplicialComplex surface = closure(list);
    EXPECT_EQ(surface.count(0), bound(surface.euler_characteristic()));
  }
}

TEST(Homology, EqualBettiNumbersOfSpacesThatDiffer) {  // H13
  EXPECT_EQ(integers(closure(annulus())).betti, (Betti{1, 1, 0}));
  EXPECT_EQ(integers(closure(sphere(1))).betti, (Betti{1, 1}));
}

TEST(Homology, RandomComplexes) {
  std::mt19937_64 random(11);
  for (int round = 0; round < test_rounds(60); ++round) {
    SCOPED_TRACE(round);
    check_all(closure(random_simplices(random, 5 + round % 6, 1 + round % 4, 4 + round % 20)));
  }
}

// All edges between n vertices, and the triangles whose sum of vertices modulo n is 0, 1 or `third`.
SimplexList sum_complex(std::uint32_t n, std::uint32_t third) {
  SimplexList list;
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      list.add(std::array{a, b});
      for (std::uint32_t c = b + 1; c < n; ++c) {
        const std::uint32_t sum = (a + b + c) % n;
        if (sum <= 1 || sum == third) list.add(std::array{a, b, c});
      }
    }
  }
  return list;
}

TEST(Homology, SumComplexesHaveTorsion) {
  // For a prime n these are acyclic over the rationals (Linial, Meshulam, Rosenthal: Sum complexes, 2010).
  int with_torsion = 0;
  for (const std::uint32_t n : {5U, 7U, 11U, 13U}) {
    for (std::uint32_t third = 2; third < (test_rounds(10) == 10 && n < 13 ? n : 5); ++third) {
      SCOPED_TRACE(std::to_string(n) + " " + std::to_string(third));
      const SimplicialComplex complex = closure(sum_complex(n, third));
      check_all(complex);
      const IntegerHomology homology = integers(complex);
      ASSERT_EQ(homology.betti, (Betti{1, 0, 0}));
      with_torsion += homology.torsion[1].empty() ? 0 : 1;
    }
  }
  EXPECT_GE(with_torsion, 5);
}

TEST(Homology, TorsionOfManyDigits) {
  const SimplicialComplex complex = closure(sum_complex(31, 5));
  const IntegerHomology homology = integers(complex);
  const Integer largest = Integer::parse("822014622295315728010");
  EXPECT_EQ(homology.torsion[1], (std::vector<Integer>{2, 2, 10, 10, largest}));
  EXPECT_EQ(torsion_primes(homology), (std::vector<std::uint32_t>{2, 5, 67, 311, 1117, 6263, 10789, 52267}));
  for (const std::uint32_t p : {2U, 67U, 71U})
    EXPECT_EQ(betti_numbers(homology, p), betti_by_ranks(complex, [&](const Dense& d) { return rank_modulo(d, p); }));
  for (const std::uint32_t p : torsion_primes(homology)) EXPECT_EQ(over(complex, p), betti_numbers(homology, p));
}

TEST(Homology, JoinsAndUnionsOfMooreSpaces) {
  // The join of two has torsion of the common divisor, one degree above the sum.
  const SimplicialComplex both = closure(join(moore_space(4), moore_space(6)));
  EXPECT_EQ(integers(both).torsion, (std::vector<std::vector<Integer>>{{}, {}, {}, {2}, {2}, {}}));
  EXPECT_EQ(integers(both).betti, (Betti{1, 0, 0, 0, 0, 0}));
  SimplexList apart = moore_space(4);
  const std::uint32_t shift = vertices_of(apart);
  const SimplexList other = moore_space(6);
  for (std::size_t i = 0; i < other.size(); ++i) {
    Row row;
    for (const std::uint32_t v : other[i]) row.push_back(v + shift);
    apart.add(row);
  }
  const IntegerHomology homology = integers(closure(apart));
  EXPECT_EQ(homology.torsion[1], (std::vector<Integer>{2, 12}));
  EXPECT_EQ(torsion_primes(homology), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(betti_numbers(homology, 2), (Betti{2, 2, 2}));
}

TEST(Homology, TorsionBeyondSixtyFourBits) {
  // Disks on a chain of circles, each of which goes twice around the one before: the last is 2^70 times the first.
  const std::uint32_t stages = 70;
  SimplexList list;
  std::uint32_t next = 3 * (stages + 1);
  const auto circle = [](std::uint32_t i, std::uint32_t j) { return 3 * i + j % 3; };
  const auto disk = [&](const Row& walk) {
    const auto k = static_cast<std::uint32_t>(walk.size());
    for (std::uint32_t i = 0; i < k; ++i) {
      const std::uint32_t j = (i + 1) % k;
      list.add(std::array{walk[i], walk[j], next + i});
      list.add(std::array{walk[j], next + i, next + j});
      list.add(std::array{next + i, next + j, next + k});
    }
    next += k + 1;
  };
  for (std::uint32_t i = 0; i < stages; ++i) {
    // c[i] = 2 c[i + 1], around an edge between their first vertices.
    disk({circle(i, 0), circle(i, 1), circle(i, 2), circle(i, 0), circle(i + 1, 0), circle(i + 1, 2), circle(i + 1, 1),
          circle(i + 1, 0), circle(i + 1, 2), circle(i + 1, 1), circle(i + 1, 0)});
  }
  disk({circle(0, 0), circle(0, 1), circle(0, 2)});
  const IntegerHomology homology = integers(closure(list));
  EXPECT_EQ(homology.betti[0], 1U);
  ASSERT_EQ(homology.torsion[1].size(), 1U);
  EXPECT_EQ(homology.torsion[1][0], Integer(1) << stages);
  EXPECT_EQ(torsion_primes(homology), (std::vector<std::uint32_t>{2}));
}

TEST(Homology, RefusesFieldsThatAreNone) {
  const SimplicialComplex complex = closure(sphere(2));
  for (const std::uint32_t p : {0U, 1U, 4U, 9U, 2147483648U, 4294967291U}) EXPECT_THROW(over(complex, p), InputError);
  EXPECT_EQ(over(complex, 2147483647), (Betti{1, 0, 1}));
}

TEST(Homology, TheEmptyComplexHasNone) {
  EXPECT_TRUE(integers(closure({})).betti.empty());
  EXPECT_TRUE(over(closure({}), 2).empty());
}

TEST(Homology, CanBeCancelled) {
  const SimplicialComplex complex = closure(sphere(4));
  Context context;
  context.cancel();
  EXPECT_THROW(integer_homology(complex, context), Cancelled);
}

}  // namespace
}  // namespace quoin
