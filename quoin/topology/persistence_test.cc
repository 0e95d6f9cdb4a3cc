// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/persistence.h"

#include <gtest/gtest.h>

#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/incremental_betti.h"
#include "quoin/topology/ordered_boundaries.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

// Degree, grade of birth, grade of death or -1; sorted.
using Diagram = std::vector<std::tuple<int, std::int64_t, std::int64_t>>;

Diagram diagram_of(const Filtration& filtration, const std::vector<PersistencePair>& pairs) {
  Diagram diagram;
  for (const PersistencePair& p : pairs) {
    const bool dies = p.death != PersistencePair::never;
    diagram.emplace_back(p.degree, filtration.grade[p.degree][p.birth],
                         dies ? std::int64_t{filtration.grade[p.degree + 1][p.death]} : -1);
  }
  std::sort(diagram.begin(), diagram.end());
  return diagram;
}

// All simplices in one matrix, each column reduced by any earlier one with the same last row.
Diagram naive_diagram(const Filtration& filtration, std::int64_t p) {
  std::vector<std::pair<std::uint32_t, SimplexId>> all;
  for (int k = 0; k <= filtration.complex.dimension(); ++k)
    for (std::uint32_t i = 0; i < filtration.complex.count(k); ++i)
      all.emplace_back(filtration.grade[k][i], SimplexId{k, i});
  std::sort(all.begin(), all.end());
  std::map<SimplexId, std::size_t> place;
  for (std::size_t i = 0; i < all.size(); ++i) place[all[i].second] = i;
  std::vector<std::map<std::size_t, std::int64_t>> columns(all.size());
  std::map<std::size_t, std::size_t> column_of;
  Diagram diagram;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SimplexId s = all[i].second;
    auto& column = columns[i];
    for (std::uint32_t j = 0; s.dimension > 0 && j < filtration.complex.facets(s).size(); ++j)
      column[place.at({s.dimension - 1, filtration.complex.facets(s)[j]})] = j % 2 == 0 ? 1 : p - 1;
    while (!column.empty() && column_of.count(column.rbegin()->first) != 0) {
      const auto& other = columns[column_of[column.rbegin()->first]];
      const std::int64_t f = (p - column.rbegin()->second) * inverse_modulo(other.rbegin()->second, p) % p;
      for (const auto& entry : other) {
        std::int64_t& x = column[entry.first];
        x = (x + f * entry.second) % p;
        if (x == 0) column.erase(entry.first);
      }
    }
    if (!column.empty()) column_of[column.rbegin()->first] = i;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!columns[i].empty()) continue;
    const auto death = column_of.find(i);
    const std::int64_t born = all[i].first;
    const std::int64_t dies = death == column_of.end() ? -1 : std::int64_t{all[death->second].first};
    if (born != dies) diagram.emplace_back(all[i].second.dimension, born, dies);
  }
  std::sort(diagram.begin(), diagram.end());
  return diagram;
}

constexpr std::array methods{PersistenceMethod::automatic, PersistenceMethod::homology, PersistenceMethod::cohomology};

void check_diagrams(const Filtration& filtration) {
  for (const std::uint32_t p : {2U, 3U, 5U}) {
    const Diagram expected = naive_diagram(filtration, p);
    for (const PersistenceMethod method : methods)
      ASSERT_EQ(diagram_of(filtration, persistence(filtration, {.prime = p, .method = method}, Context())), expected)
          << p << " by method " << static_cast<int>(method);
  }
}

Filtration random_filtration(SimplicialComplex complex, std::mt19937_64& random, std::uint32_t grades) {
  Filtration filtration{std::move(complex), {}};
  for (int k = 0; k <= filtration.complex.dimension(); ++k) {
    filtration.grade.emplace_back();
    for (std::uint32_t i = 0; i < filtration.complex.count(k); ++i) {
      auto grade = static_cast<std::uint32_t>(random() % grades);
      if (k > 0)
        for (const std::uint32_t f : filtration.complex.facets({k, i}))
          grade = std::max(grade, filtration.grade[k - 1][f]);
      filtration.grade[k].push_back(grade);
    }
  }
  return filtration;
}

std::vector<SimplexList> special_complexes() {
  return {seven_vertex_torus(),
          six_vertex_projective_plane(),
          glued_grid(4, 4, true),
          sphere(1),
          sphere(3),
          sphere(4),
          moore_space(3),
          annulus(),
          cubes(2, 1, 1),
          join(six_vertex_projective_plane(), sphere(0)),
          join(sphere(1), sphere(1)),
          full_simplex(5),
          SimplexList{{0}, {1}}};
}

TEST(Persistence, AgreesWithNaiveReductionOnRandomComplexes) {
  std::mt19937_64 random(41);
  for (int round = 0; round < test_rounds(60); ++round) {
    SCOPED_TRACE(round);
    check_diagrams(random_filtration(closure(random_simplices(random, 8, 1 + round % 4, 4 + round % 9)), random,
                                     round % 2 == 0 ? 4 : 1000));
  }
}

TEST(Persistence, AgreesWithNaiveReductionOnManifoldsAndTorsion) {
  std::mt19937_64 random(42);
  for (const SimplexList& list : special_complexes())
    for (const std::uint32_t grades : {1U, 3U, 10000U})
      for (int round = 0; round < test_rounds(2); ++round)
        check_diagrams(random_filtration(closure(list), random, grades));
}

// Cycles of a subcomplex as rows over the simplices of dimension k of the whole: a basis, by elimination of a unit
// matrix beside the boundaries.
Dense cycles(const Filtration& filtration, int k, std::uint32_t grade, std::int64_t p) {
  const SimplicialComplex& complex = filtration.complex;
  const std::size_t n = complex.count(k);
  const std::size_t m = k == 0 ? 0 : complex.count(k - 1);
  const Dense boundary = k == 0 ? Dense(n) : dense_boundary(complex, k);
  Dense rows;
  for (std::size_t i = 0; i < n; ++i) {
    if (filtration.grade[k][i] > grade) continue;
    std::vector<std::int64_t> row(m + n, 0);
    for (std::size_t j = 0; j < m; ++j) row[j] = (boundary[i][j] + p) % p;
    row[m + i] = 1;
    rows.push_back(row);
  }
  std::size_t rank = 0;
  for (std::size_t j = 0; j < m; ++j) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][j] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    const std::int64_t inverse = inverse_modulo(rows[rank][j], p);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const std::int64_t f = rows[i][j] * inverse % p;
      for (std::size_t l = 0; l < m + n; ++l) rows[i][l] = ((rows[i][l] - f * rows[rank][l]) % p + p) % p;
    }
    ++rank;
  }
  Dense result;
  for (std::size_t i = rank; i < rows.size(); ++i)
    result.emplace_back(rows[i].begin() + static_cast<std::ptrdiff_t>(m), rows[i].end());
  return result;
}

Dense boundaries(const Filtration& filtration, int k, std::uint32_t grade) {
  Dense result;
  if (k >= filtration.complex.dimension()) return result;
  const Dense all = dense_boundary(filtration.complex, k + 1);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (filtration.grade[k + 1][i] <= grade) result.push_back(all[i]);
  return result;
}

TEST(Persistence, CountsAreRanksOfMapsThatInclusionsInduce) {
  std::mt19937_64 random(43);
  for (int round = 0; round < test_rounds(12); ++round) {
    SCOPED_TRACE(round);
    const std::uint32_t grades = 5;
    const SimplexList list = round % 4 == 0 ? six_vertex_projective_plane() : random_simplices(random, 7, 3, 7);
    const Filtration filtration = random_filtration(closure(list), random, grades);
    const std::uint32_t p = round % 2 == 0 ? 2 : 3;
    const auto pairs = persistence(filtration, {.prime = p}, Context());
    const Diagram diagram = diagram_of(filtration, pairs);
    for (int k = 0; k <= filtration.complex.dimension(); ++k) {
      for (std::uint32_t from = 0; from < grades; ++from) {
        for (std::uint32_t to = from; to < grades; ++to) {
          Dense sum = boundaries(filtration, k, to);
          const std::size_t dead = rank_modulo(sum, p);
          for (const auto& cycle : cycles(filtration, k, from, p)) sum.push_back(cycle);
          const std::size_t rank = rank_modulo(sum, p) - dead;
          const auto alive = std::count_if(diagram.begin(), diagram.end(), [&](const auto& entry) {
            const auto& [degree, birth, death] = entry;
            return degree == k && birth <= from && (death < 0 || death > to);
          });
          ASSERT_EQ(static_cast<std::size_t>(alive), rank) << k << " " << from << " " << to;
        }
      }
      ASSERT_EQ(betti_numbers_at(filtration, pairs, grades), betti_numbers(filtration.complex, p, Context()));
    }
  }
}

TEST(Persistence, TheOrderWithinAGradeDoesNotMatter) {
  std::mt19937_64 random(44);
  for (int round = 0; round < test_rounds(20); ++round) {
    const SimplexList list = random_simplices(random, 9, 3, 10);
    const SimplicialComplex complex = closure(list);
    const Filtration filtration = random_filtration(complex, random, 4);
    // The same with vertices renamed: another order of simplices of equal grade.
    Row names(9);
    std::iota(names.begin(), names.end(), 0U);
    std::shuffle(names.begin(), names.end(), random);
    SimplexList renamed;
    std::vector<std::uint32_t> grades;
    for (int k = 0; k <= complex.dimension(); ++k)
      for (std::uint32_t i = 0; i < complex.count(k); ++i) {
        Row row = complex.labels({k, i});
        for (std::uint32_t& v : row) v = names[v];
        renamed.add(row);
        grades.push_back(filtration.grade[k][i]);
      }
    const Filtration other = filtration_of(renamed, grades, Context());
    ASSERT_EQ(diagram_of(filtration, persistence(filtration, {}, Context())),
              diagram_of(other, persistence(other, {}, Context())));
  }
}

TEST(Persistence, ATriangleByHand) {
  // Three vertices at 0, edges at 1, 2, 3, the inside at 5: two components die, the loop lives from 3 to 5.
  const Filtration filtration = filtration_of({{0}, {1}, {2}, {0, 1}, {1, 2}, {0, 2}, {0, 1, 2}},
                                              std::vector<std::uint32_t>{0, 0, 0, 1, 2, 3, 5}, Context());
  EXPECT_EQ(filtration.added_faces, 0U);
  const auto pairs = persistence(filtration, {}, Context());
  EXPECT_EQ(diagram_of(filtration, pairs), (Diagram{{0, 0, -1}, {0, 0, 1}, {0, 0, 2}, {1, 3, 5}}));
  EXPECT_EQ(betti_numbers_at(filtration, pairs, 1), (Betti{2, 0, 0}));
  EXPECT_EQ(betti_numbers_at(filtration, pairs, 4), (Betti{1, 1, 0}));
  // All of it at once: one class, and three empty pairs on request.
  const Filtration at_once = filtration_of({{0, 1, 2}}, std::vector<std::uint32_t>{7}, Context());
  EXPECT_EQ(at_once.added_faces, 6U);
  EXPECT_EQ(persistence(at_once, {}, Context()).size(), 1U);
  EXPECT_EQ(persistence(at_once, {.keeps_empty = true}, Context()).size(), 4U);
}

TEST(Persistence, LowerStarsOfAHeightOnATorus) {
  // The height of vertices of a glued grid, wrapped twice around: minimum, two saddles, maximum.
  const SimplicialComplex torus = closure(glued_grid(8, 8, false));
  std::vector<std::uint32_t> heights;
  for (std::uint32_t v = 0; v < 64; ++v) {
    const std::uint32_t i = v / 8;
    const std::uint32_t j = v % 8;
    heights.push_back(10 * std::min(i, 8 - i) + std::min(j, 8 - j));
  }
  const Filtration filtration = lower_star_filtration(torus, heights);
  const Diagram diagram = diagram_of(filtration, persistence(filtration, {}, Context()));
  EXPECT_EQ(diagram, (Diagram{{0, 0, -1}, {1, 4, -1}, {1, 40, -1}, {2, 44, -1}}));
}

/// Edges of a cycle, in reverse order: every step takes them all.
Filtration cycle_of_edges(std::uint32_t count) {
  SimplexList edges;
  for (std::uint32_t i = 0; i < count; ++i) edges.add(std::array{i, (i + 1) % count});
  Filtration filtration{SimplicialComplex::closure_of(edges, Context()), {}};
  filtration.grade.emplace_back(count, 0);
  filtration.grade.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) filtration.grade[1].push_back(count - i);
  return filtration;
}

TEST(Persistence, PollsAtEveryStepOfItsSimplices) {
  constexpr std::uint64_t unlimited = 1'000'000'000;
  constexpr std::uint64_t interval = 4096;
  const Filtration filtration = cycle_of_edges(100'000);
  const std::uint64_t size = filtration.complex.size();
  const Context ordering({.threads = 1, .most_polls = unlimited});
  const auto order = filtration_order(filtration, ordering);
  EXPECT_GT(ordering.polls(), 2 * size / interval);  // grades are counted, and simplices put in their places
  const Context listing({.threads = 1, .most_polls = unlimited});
  const OrderedBoundaries boundaries(filtration.complex, order, listing);
  EXPECT_GT(listing.polls(), size / interval);
  const Context turning({.threads = 1, .most_polls = unlimited});
  const CoboundaryColumns columns(boundaries, 0, turning);
  EXPECT_GT(turning.polls(), 2 * size / interval);
  const Context all({.threads = 1, .most_polls = unlimited});
  const std::size_t pairs = persistence(filtration, {}, all).size();
  for (std::uint64_t sixteenths = 0; sixteenths < 16; ++sixteenths) {
    const Context some({.threads = 1, .most_polls = all.polls() * sixteenths / 16});
    EXPECT_THROW(persistence(filtration, {}, some), Cancelled);
  }
  EXPECT_EQ(persistence(filtration, {}, Context()).size(), pairs);
}

TEST(Filtration, RefusesWhatIsNone) {
  const std::vector<std::uint32_t> grades{1, 1, 0};
  EXPECT_THROW(filtration_of({{0}, {1}, {0, 1}}, grades, Context()), InputError);
  EXPECT_THROW(filtration_of({{0}, {1}, {0}}, grades, Context()), InputError);
  EXPECT_THROW(filtration_of({{0}, {1}}, grades, Context()), InputError);
  EXPECT_THROW(lower_star_filtration(closure({{0, 1}}), grades), InputError);
  const SimplicialComplex edge = closure({{0, 1}});
  EXPECT_THROW(filtration_by_order(edge, std::vector<SimplexId>{{0, 0}, {1, 0}, {0, 1}}), InputError);
  EXPECT_THROW(filtration_by_order(edge, std::vector<SimplexId>{{0, 0}, {0, 0}, {1, 0}}), InputError);
  EXPECT_THROW(filtration_by_order(edge, std::vector<SimplexId>{{0, 0}, {0, 1}}), InputError);
  EXPECT_THROW(filtration_by_order(edge, std::vector<SimplexId>{{0, 0}, {0, 7}, {1, 0}}), InputError);
  EXPECT_THROW(
      persistence(filtration_by_order(edge, std::vector<SimplexId>{{0, 0}, {0, 1}, {1, 0}}), {.prime = 6}, Context()),
      InputError);
}

TEST(Filtration, GradesOfValues) {
  const std::vector<double> values{3, -1, 3, 0.5};
  const Grades<double> grades = grades_of<double>(values);
  EXPECT_EQ(grades.values, (std::vector<double>{-1, 0.5, 3}));
  EXPECT_EQ(grades.grade, (std::vector<std::uint32_t>{2, 0, 2, 1}));
}

// H17: three ways, after each insertion, which changes one Betti number by one.
void check_steps(const SimplicialComplex& complex, std::mt19937_64& random, bool is_ball) {
  const std::vector<SimplexId> order = random_order(complex, random);
  for (const std::uint32_t p : {2U, 3U}) {
    const BettiSteps births = incremental_betti(complex, order, p, Context());
    const auto betti = betti_numbers_by_step(order, births, complex.dimension());
    if (is_ball) {
      ASSERT_EQ(incremental_betti_in_space(complex, order, Context()), births);
    }
    ASSERT_EQ(betti.size(), order.size());
    SimplexList list;
    Betti before(complex.dimension() + 1, 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      list.add(complex.labels(order[i]));
      Betti expected = betti_by_ranks(closure(list), [&](const Dense& d) { return rank_modulo(d, p); });
      expected.resize(complex.dimension() + 1, 0);
      ASSERT_EQ(betti[i], expected) << p << " after " << i;
      const int k = order[i].dimension;
      ASSERT_TRUE(births[i] || k > 0);
      if (births[i]) {
        ++before[k];
      } else {
        --before[k - 1];
      }
      ASSERT_EQ(before, expected) << p << " after " << i;
    }
  }
}

TEST(IncrementalBetti, AgreesWithRanksAfterEveryStep) {
  std::mt19937_64 random(51);
  for (int round = 0; round < test_rounds(6); ++round) {
    SCOPED_TRACE(round);
    check_steps(closure(cubes(1, 1, 1 + round % 2)), random, true);
    check_steps(closure(six_vertex_projective_plane()), random, false);
    check_steps(closure(random_simplices(random, 7, 3, 6)), random, false);
  }
}

TEST(IncrementalBetti, DualSetsOnLargerBalls) {
  std::mt19937_64 random(52);
  const SimplicialComplex ball = closure(cubes(4, 3, 4));
  for (int round = 0; round < test_rounds(10); ++round) {
    const std::vector<SimplexId> order = random_order(ball, random);
    ASSERT_EQ(incremental_betti_in_space(ball, order, Context()), incremental_betti(ball, order, 2, Context()));
  }
}

TEST(IncrementalBetti, SpaceIsRefusedWhereItsRuleIsWrong) {
  std::mt19937_64 random(53);
  for (const SimplexList& list :
       {sphere(3), sphere(2), SimplexList{{0, 1, 2, 3}, {0, 4, 5, 6}}, SimplexList{{0, 1, 2, 3}, {4, 5, 6, 7}},
        join(six_vertex_projective_plane(), SimplexList{{0}})}) {
    const SimplicialComplex complex = closure(list);
    EXPECT_THROW(incremental_betti_in_space(complex, random_order(complex, random), Context()), InputError);
  }
}

}  // namespace
}  // namespace quoin
