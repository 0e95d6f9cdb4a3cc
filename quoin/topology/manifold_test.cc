// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/manifold.h"

#include <gtest/gtest.h>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

ManifoldReport check(const SimplexList& list) {
  return check_manifold(closure(list), Context());
}

// By the definition of homology manifolds, for every simplex, with links found by looking at all simplices. Up to
// dimension 3 these are the manifolds.
bool is_manifold_by_links(const SimplicialComplex& complex) {
  const int d = complex.dimension();
  for (int k = 0; k < d; ++k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      const SimplicialComplex around = link(complex, {k, i}, Context());
      if (around.dimension() != d - 1 - k) return false;
      const IntegerHomology homology = integer_homology(around, Context());
      std::size_t sum = 0;
      for (const std::size_t b : homology.betti) sum += b;
      for (const auto& orders : homology.torsion) sum += orders.size();
      const bool is_point = sum == 1;
      const bool is_sphere =
          sum == 2 && (d - 1 - k == 0 ? homology.betti[0] == 2 : homology.betti[0] == 1 && homology.betti.back() == 1);
      if (!is_point && !is_sphere) return false;
    }
  }
  return true;
}

TEST(Manifold, ClosedOnes) {
  for (const SimplexList& list : {seven_vertex_torus(), six_vertex_projective_plane(), glued_grid(4, 5, true),
                                  sphere(0), sphere(1), sphere(2), sphere(3), sphere(4), sphere(5)}) {
    EXPECT_TRUE(check(list).is_closed());
  }
  EXPECT_TRUE(check(join(sphere(1), sphere(1))).is_closed());
  EXPECT_TRUE(check({}).is_closed());
}

TEST(Manifold, WithBoundary) {
  const ManifoldReport ring = check(annulus());
  EXPECT_TRUE(ring.is_manifold());
  EXPECT_EQ(ring.boundary_facets, 6U);
  EXPECT_FALSE(ring.is_closed());
  const ManifoldReport block = check(cubes(2, 2, 2));
  EXPECT_TRUE(block.is_manifold());
  EXPECT_EQ(block.boundary_facets, 48U);
  EXPECT_TRUE(check(full_simplex(5)).is_manifold());
}

TEST(Manifold, WitnessesOfWhatIsNone) {
  const SimplicialComplex flag = closure({{0, 1, 2}, {2, 3}});
  ManifoldReport report = check_manifold(flag, Context());
  ASSERT_TRUE(report.impure);
  EXPECT_EQ(flag.labels(*report.impure), (Row{2, 3}));
  const SimplicialComplex book = closure({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  report = check_manifold(book, Context());
  ASSERT_TRUE(report.branching);
  EXPECT_EQ(book.labels(*report.branching), (Row{0, 1}));
  // Two tetrahedron boundaries at a vertex: every edge has two triangles, and the vertex is pinched.
  const SimplicialComplex cones = closure(triangles({123, 134, 142, 243, 156, 167, 175, 567}));
  report = check_manifold(cones, Context());
  ASSERT_TRUE(report.pinched);
  EXPECT_EQ(cones.labels(*report.pinched), (Row{1}));
  EXPECT_EQ(report.boundary_facets, 0U);
  // The cone over a torus: a pseudomanifold whose apex has a torus as link.
  const SimplicialComplex cone = closure(join(seven_vertex_torus(), SimplexList{{0}}));
  report = check_manifold(cone, Context());
  ASSERT_TRUE(report.pinched);
  EXPECT_EQ(cone.labels(*report.pinched), (Row{8}));
  // Two tetrahedra that share an edge, or a vertex.
  EXPECT_TRUE(check({{0, 1, 2, 3}, {0, 1, 4, 5}}).pinched);
  EXPECT_TRUE(check({{0, 1, 2, 3}, {0, 4, 5, 6}}).pinched);
  // In dimension 4: the suspended suspension of a projective plane.
  const SimplexList suspended = join(join(six_vertex_projective_plane(), sphere(0)), sphere(0));
  EXPECT_TRUE(check(suspended).pinched);
}

TEST(Manifold, AgreesWithLinksOfAllSimplices) {
  std::mt19937_64 random(31);
  int manifolds = 0;
  for (int round = 0; round < test_rounds(150); ++round) {
    SCOPED_TRACE(round);
    // Few simplices of one dimension, so that some are manifolds.
    const auto d = static_cast<std::uint32_t>(1 + round % 4);
    SimplexList list;
    Row all(d + 3);
    std::iota(all.begin(), all.end(), 0U);
    for (std::uint64_t i = 0; i < 1 + random() % 5; ++i) {
      std::shuffle(all.begin(), all.end(), random);
      list.add({all.data(), d + (random() % 8 == 0 ? 0U : 1U)});
    }
    const SimplicialComplex complex = closure(list);
    const bool expected = is_manifold_by_links(complex);
    ASSERT_EQ(check_manifold(complex, Context()).is_manifold(), expected);
    manifolds += expected ? 1 : 0;
  }
  EXPECT_GE(manifolds, test_cases(20));
}

// Signs times boundaries sum to zero off the boundary, or a loop of neighbours along which an odd number reverse.
void check_orientation(const SimplicialComplex& complex, const OrientationReport& report) {
  const int d = complex.dimension();
  const SimplexIncidence cofacets = complex.cofacets(d - 1);
  const auto place = [&](std::uint32_t cell, std::uint32_t facet) {
    const auto facets = complex.facets({d, cell});
    return std::find(facets.begin(), facets.end(), facet) - facets.begin();
  };
  if (report.is_orientable()) {
    for (std::uint32_t f = 0; f < complex.count(d - 1); ++f) {
      int sum = 0;
      for (const std::uint32_t cell : cofacets[f])
        sum += (report.is_reversed[cell] ? -1 : 1) * (place(cell, f) % 2 == 0 ? 1 : -1);
      if (cofacets[f].size() == 2) {
        ASSERT_EQ(sum, 0);
      }
    }
    return;
  }
  const std::vector<std::uint32_t>& loop = report.reversing_loop;
  bool is_reversed = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t next = loop[(i + 1) % loop.size()];
    std::vector<std::uint32_t> common;
    for (const std::uint32_t f : complex.facets({d, loop[i]}))
      if (place(next, f) <= d && cofacets[f].size() == 2) common.push_back(f);
    ASSERT_EQ(common.size(), 1U);
    is_reversed ^= place(loop[i], common[0]) % 2 == place(next, common[0]) % 2;
  }
  ASSERT_TRUE(is_reversed);
}

TEST(Orientation, OfSurfacesAndSpheres) {
  const auto is_orientable = [](const SimplexList& list) {
    const SimplicialComplex complex = closure(list);
    const OrientationReport report = orient(complex, Context());
    check_orientation(complex, report);
    return report.is_orientable();
  };
  EXPECT_TRUE(is_orientable(seven_vertex_torus()));
  EXPECT_TRUE(is_orientable(sphere(3)));
  EXPECT_TRUE(is_orientable(annulus()));
  EXPECT_TRUE(is_orientable(cubes(2, 1, 3)));
  EXPECT_FALSE(is_orientable(six_vertex_projective_plane()));
  EXPECT_FALSE(is_orientable(glued_grid(9, 7, true)));
  EXPECT_FALSE(is_orientable(triangles({125, 235, 346, 356, 461, 612, 413}))) << "a Moebius strip";
  // Orientable in the sense of homology: the highest integer homology of a closed one has rank 1.
  for (const SimplexList& list : {seven_vertex_torus(), six_vertex_projective_plane(), glued_grid(5, 4, true)})
    EXPECT_EQ(is_orientable(list), integer_homology(closure(list), Context()).betti[2] == 1);
}

TEST(Surface, Classes) {
  const auto classes = [](const SimplexList& list) {
    const SimplicialComplex complex = closure(list);
    const std::vector<SurfaceClass> found = classify_surface(complex, Context());
    EXPECT_EQ(classify_surface(complex, check_manifold(complex, Context()), Context()), found);
    return found;
  };
  EXPECT_EQ(classes(seven_vertex_torus()), (std::vector<SurfaceClass>{{true, 0, 0, 1}}));
  EXPECT_EQ(classes(sphere(2)), (std::vector<SurfaceClass>{{true, 2, 0, 0}}));
  EXPECT_EQ(classes(six_vertex_projective_plane()), (std::vector<SurfaceClass>{{false, 1, 0, 1}}));
  EXPECT_EQ(classes(glued_grid(4, 4, true)), (std::vector<SurfaceClass>{{false, 0, 0, 2}}));
  EXPECT_EQ(classes(annulus()), (std::vector<SurfaceClass>{{true, 0, 2, 0}}));
  EXPECT_EQ(classes({{0, 1, 2}, {7, 8, 9}}), (std::vector<SurfaceClass>{{true, 1, 1, 0}, {true, 1, 1, 0}}));
  EXPECT_THROW(classes({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}), InputError);
  EXPECT_THROW(classes({{0, 1}}), InputError);
}

}  // namespace
}  // namespace quoin
