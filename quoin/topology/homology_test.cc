// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/homology.h"

#include <gtest/gtest.h>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

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
