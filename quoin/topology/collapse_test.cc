// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/collapse.h"

#include <gtest/gtest.h>

#include <set>

#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

std::set<Row> simplices_of(const SimplicialComplex& complex) {
  std::set<Row> all;
  for (int k = 0; k <= complex.dimension(); ++k)
    for (std::uint32_t i = 0; i < complex.count(k); ++i) all.insert(complex.labels({k, i}));
  return all;
}

// Takes the steps one by one, by the definition: the free face is a proper face of one simplex that is left. Of a
// complex, or of a part of it from which all steps are.
void take_steps(const SimplicialComplex& complex, const CollapseResult& result, std::set<Row>& left) {
  for (const ElementaryCollapse& step : result.steps) {
    const Row face = complex.labels({step.dimension - 1, step.free_face});
    const Row coface = complex.labels({step.dimension, step.coface});
    std::vector<Row> cofaces;
    for (const Row& other : left)
      if (other != face && std::includes(other.begin(), other.end(), face.begin(), face.end()))
        cofaces.push_back(other);
    ASSERT_EQ(cofaces, std::vector<Row>{coface});
    ASSERT_EQ(left.erase(face) + left.erase(coface), 2U);
  }
}

void check_steps(const SimplicialComplex& complex, const CollapseResult& result) {
  std::set<Row> left = simplices_of(complex);
  ASSERT_NO_FATAL_FAILURE(take_steps(complex, result, left));
  std::set<Row> rest;
  for (const SimplexId s : result.rest) rest.insert(complex.labels(s));
  ASSERT_EQ(rest, left);
}

// Collapses a complex onto a graph in it. While that is done, each edge of the graph is one of the boundary of a
// tetrahedron, so that nothing of the graph is ever free.
CollapseResult check_collapse_onto(const SimplexList& list, const SimplexList& graph) {
  SimplexList held = list;
  std::uint32_t next = vertices_of(list);
  for (std::size_t i = 0; i < graph.size(); ++i, next += 2) {
    const Row tetrahedron{graph[i][0], graph[i][1], next, next + 1};
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      Row triangle = tetrahedron;
      triangle.erase(triangle.begin() + static_cast<std::ptrdiff_t>(left_out));
      held.add(triangle);
    }
  }
  const SimplicialComplex whole = closure(held);
  const CollapseResult result = collapse(whole, Context());
  check_steps(whole, result);
  std::set<Row> left = simplices_of(closure(list));
  take_steps(whole, result, left);
  EXPECT_EQ(left, simplices_of(closure(graph)));
  return result;
}

TEST(Collapse, EachStepIsElementaryAndHomologyStays) {  // H16
  std::mt19937_64 random(5);
  for (int round = 0; round < test_rounds(60); ++round) {
    SCOPED_TRACE(round);
    const SimplicialComplex complex = closure(random_simplices(random, 8, 3, 4 + round % 10));
    const CollapseResult result = collapse(complex, Context());
    check_steps(complex, result);
    const SimplicialComplex rest = rest_of_collapse(complex, result, Context());
    ASSERT_EQ(rest.size(), result.rest.size());
    ASSERT_EQ(rest.euler_characteristic(), complex.euler_characteristic());
    Betti betti = integer_homology(rest, Context()).betti;
    betti.resize(complex.dimension() + 1, 0);
    ASSERT_EQ(betti, integer_homology(complex, Context()).betti);
  }
}

TEST(Collapse, TheTorusWithoutAnyTriangleIsAGraph) {  // H8
  const SimplexList torus = seven_vertex_torus();
  const SimplexList graph{{1, 2}, {2, 3}, {3, 1}, {1, 4}, {4, 5}, {5, 1}};
  EXPECT_EQ(integer_homology(closure(graph), Context()).betti, (Betti{1, 2}));
  for (std::size_t left_out = 0; left_out < torus.size(); ++left_out) {
    SimplexList list;
    for (std::size_t i = 0; i < torus.size(); ++i)
      if (i != left_out) list.add(torus[i]);
    const SimplicialComplex complex = closure(list);
    EXPECT_EQ(integer_homology(complex, Context()).betti, (Betti{1, 2, 0}));
    const CollapseResult result = collapse(complex, Context());
    check_steps(complex, result);
    const SimplicialComplex rest = rest_of_collapse(complex, result, Context());
    EXPECT_EQ(rest.dimension(), 1);
    EXPECT_EQ(static_cast<std::int64_t>(rest.count(1)) - static_cast<std::int64_t>(rest.count(0)), 1);
    ASSERT_NO_FATAL_FAILURE(check_collapse_onto(list, graph)) << left_out;
  }
  // With all its triangles nothing is free.
  EXPECT_TRUE(collapse(closure(torus), Context()).steps.empty());
}

TEST(Collapse, TheProjectivePlaneWithoutATriangleIsALoop) {  // H4
  const SimplexList list = triangles({412, 423, 531, 512, 623, 631, 453, 562, 641});
  const SimplicialComplex complex = closure(list);
  const CollapseResult result = collapse(complex, Context());
  const SimplicialComplex rest = rest_of_collapse(complex, result, Context());
  EXPECT_EQ(rest.dimension(), 1);
  EXPECT_EQ(rest.count(0), rest.count(1));
  EXPECT_EQ(connected_components(rest).count, 1U);
  check_collapse_onto(list, {{1, 2}, {2, 3}, {1, 3}});
}

TEST(Collapse, ConesAreAPointAndSpheresAreNotFree) {
  const SimplicialComplex ball = closure(cubes(3, 2, 2));
  EXPECT_EQ(collapse(ball, Context()).rest.size(), 1U);
  EXPECT_TRUE(collapse(closure(sphere(3)), Context()).steps.empty());
  EXPECT_TRUE(collapse(closure({}), Context()).rest.empty());
  // Down to a graph: no vertex goes.
  const CollapseResult graph = collapse(ball, Context(), 1);
  check_steps(ball, graph);
  for (const ElementaryCollapse& step : graph.steps) EXPECT_GE(step.dimension, 2);
}

TEST(CollapseOrder, EveryPrefixIsAComplexAndCriticalCountsHaveTheCharacteristic) {
  std::mt19937_64 random(6);
  for (int round = 0; round < test_rounds(60); ++round) {
    const SimplicialComplex complex = closure(random_simplices(random, 9, 3, 4 + round % 14));
    const CollapseOrder order = collapse_order(complex, Context());
    const Betti betti = betti_numbers(complex, 2, Context());
    std::int64_t sum = 0;
    for (int k = 0; k <= complex.dimension(); ++k) {
      Row sorted = order.simplices[k];
      std::sort(sorted.begin(), sorted.end());
      Row all(complex.count(k));
      std::iota(all.begin(), all.end(), 0U);
      ASSERT_EQ(sorted, all);
      ASSERT_GE(order.critical[k], betti[k]);
      sum += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(order.critical[k]);
    }
    ASSERT_EQ(sum, complex.euler_characteristic());
  }
}

TEST(CollapseOrder, IsPerfectOnSurfaces) {
  EXPECT_EQ(collapse_order(closure(seven_vertex_torus()), Context()).critical, (Betti{1, 2, 1}));
  EXPECT_EQ(collapse_order(closure(glued_grid(12, 9, true)), Context()).critical, (Betti{1, 2, 1}));
  EXPECT_EQ(collapse_order(closure(six_vertex_projective_plane()), Context()).critical, (Betti{1, 1, 1}));
}

}  // namespace
}  // namespace quoin
