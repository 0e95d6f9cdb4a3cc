// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/simplicial_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/topology/simplex_list_check.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

// All faces of all listed simplices by the definition: subsets.
std::set<Row> faces_of(const SimplexList& list) {
  std::set<Row> faces;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::uint32_t mask = 1; mask < 1U << list[i].size(); ++mask) {
      Row face;
      for (std::size_t j = 0; j < list[i].size(); ++j)
        if ((mask >> j & 1) != 0) face.push_back(list[i][j]);
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  return faces;
}

std::set<Row> simplices_of(const SimplicialComplex& complex) {
  std::set<Row> all;
  for (int k = 0; k <= complex.dimension(); ++k)
    for (std::uint32_t i = 0; i < complex.count(k); ++i) all.insert(complex.labels({k, i}));
  return all;
}

TEST(SimplicialComplex, HoldsEveryFaceOnceWhateverTheLabels) {
  std::mt19937_64 random(7);
  for (int round = 0; round < test_rounds(200); ++round) {
    SCOPED_TRACE(round);
    const SimplexList plain = random_simplices(random, 1 + round % 9 + 6, 5, 1 + round % 12);
    const std::uint32_t stretch = round % 3 == 0 ? 1 : round % 3 == 1 ? 1000003 : 3;
    SimplexList list;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      Row row;
      for (const std::uint32_t v : plain[i]) row.push_back(v * stretch + 5);
      list.add(row);
    }
    const SimplicialComplex complex = closure(list);
    ASSERT_EQ(simplices_of(complex), faces_of(list));
    ASSERT_EQ(complex.size(), faces_of(list).size());
    for (std::size_t i = 0; i < list.size(); ++i) ASSERT_TRUE(complex.find_labels(list[i]));
    for (int k = 1; k <= complex.dimension(); ++k) {
      const SimplexIncidence cofacets = complex.cofacets(k - 1);
      for (std::uint32_t i = 0; i < complex.count(k); ++i) {
        const Row whole = complex.labels({k, i});
        for (std::size_t j = 0; j < whole.size(); ++j) {
          Row facet = whole;
          facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
          const std::uint32_t at = complex.facets({k, i})[j];
          ASSERT_EQ(complex.labels({k - 1, at}), facet);
          ASSERT_TRUE(std::binary_search(cofacets[at].begin(), cofacets[at].end(), i));
        }
      }
    }
  }
}

void expect_equal(const SimplicialComplex& a, const SimplicialComplex& b) {
  ASSERT_EQ(a.dimension(), b.dimension());
  for (int k = 0; k <= a.dimension(); ++k) {
    ASSERT_EQ(a.count(k), b.count(k));
    for (std::uint32_t i = 0; i < a.count(k); ++i) {
      ASSERT_EQ(a.labels({k, i}), b.labels({k, i}));
      ASSERT_EQ(a.find(a.vertices({k, i})), (SimplexId{k, i}));
      if (k == 0) continue;
      ASSERT_TRUE(std::equal(a.facets({k, i}).begin(), a.facets({k, i}).end(), b.facets({k, i}).begin()));
    }
  }
}

TEST(SimplicialComplex, OfCellsIsThatOfAnyList) {
  std::mt19937_64 random(4);
  for (int round = 0; round < test_rounds(300); ++round) {
    const std::size_t width = 1 + random() % 4;
    const std::uint64_t labels = round % 5 == 0 ? 0xFFFFFFFFU : 4 + random() % 20;
    SimplexList list;
    Row cells;
    for (std::size_t i = random() % 60; i > 0; --i) {
      std::set<std::uint32_t> cell;
      while (cell.size() < width) cell.insert(static_cast<std::uint32_t>(random() % labels));
      Row row(cell.begin(), cell.end());
      std::shuffle(row.begin(), row.end(), random);
      list.add(row);
      cells.insert(cells.end(), row.begin(), row.end());
    }
    expect_equal(SimplicialComplex::closure_of_cells(cells, width, Context()), closure(list));
  }
  EXPECT_THROW(SimplicialComplex::closure_of_cells(Row{1, 2, 3}, 2, Context()), InputError);
  EXPECT_THROW(SimplicialComplex::closure_of_cells(Row{1, 2, 3, 2}, 4, Context()), InputError);
  EXPECT_THROW(SimplicialComplex::closure_of_cells(Row{1, 2, 3, 4, 5}, 5, Context()), InputError);
  EXPECT_THROW(SimplicialComplex::closure_of_cells(Row{}, 0, Context()), InputError);
  Context context;
  context.cancel();
  EXPECT_THROW(SimplicialComplex::closure_of_cells(Row{1, 2, 3, 4}, 4, context), Cancelled);
}

TEST(SimplicialComplex, BoundaryOfABoundaryIsZero) {
  std::mt19937_64 random(8);
  for (int round = 0; round < test_rounds(50); ++round) {
    const SimplicialComplex complex = closure(random_simplices(random, 9, 4, 9));
    for (int k = 2; k <= complex.dimension(); ++k) {
      const BoundaryMatrix upper = boundary_matrix(complex, k);
      const BoundaryMatrix lower = boundary_matrix(complex, k - 1);
      ASSERT_EQ(upper.rows, lower.columns);
      for (std::size_t j = 0; j < upper.columns; ++j) {
        std::vector<int> sum(lower.rows, 0);
        for (const auto& outer : upper.column(j))
          for (const auto& inner : lower.column(outer.row)) sum[inner.row] += outer.value * inner.value;
        ASSERT_EQ(sum, std::vector<int>(lower.rows, 0));
      }
    }
  }
}

TEST(SimplicialComplex, TheEmptyComplexAndAPoint) {
  const SimplicialComplex empty = closure({});
  EXPECT_EQ(empty.dimension(), -1);
  EXPECT_EQ(empty.size(), 0U);
  EXPECT_EQ(empty.euler_characteristic(), 0);
  EXPECT_EQ(connected_components(empty).count, 0U);
  const SimplicialComplex point = closure({{0xFFFFFFFFU}});
  EXPECT_EQ(point.dimension(), 0);
  EXPECT_EQ(point.label(0), 0xFFFFFFFFU);
  EXPECT_FALSE(point.find_labels(Row{3}));
  EXPECT_FALSE(point.find_labels(Row{}));
}

TEST(SimplicialComplex, RefusesWhatIsNoSimplexAndNamesIt) {
  const auto message = [](const SimplexList& list) -> std::string {
    try {
      closure(list);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(message({{0, 1}, {2, 3, 2}}).find("simplex 1 (2 3 2) has vertex 2 twice"), std::string::npos);
  EXPECT_NE(message({{}}).find("simplex 0 has no vertex"), std::string::npos);
  EXPECT_NE(message(full_simplex(SimplicialComplex::most_vertices)).find("21 vertices"), std::string::npos);
  EXPECT_EQ(closure(full_simplex(11)).size(), 4095U);
}

TEST(SimplicialComplex, CanBeCancelled) {
  Context context;
  context.cancel();
  EXPECT_THROW(SimplicialComplex::closure_of(sphere(2), context), Cancelled);
}

TEST(SimplexListCheck, FindsWhatIsMissingTwiceAndInvalid) {
  const SimplexList list{{1, 2, 3}, {2, 3, 1}, {1, 1}, {2}, {}, {3, 2}};
  const SimplexListFindings found = check_simplices(list, Context());
  EXPECT_EQ(found.invalid, (std::vector<std::uint32_t>{2, 4}));
  EXPECT_EQ(found.duplicates, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}}));
  EXPECT_EQ(found.missing_faces, (std::vector<Row>{{1}, {3}, {1, 2}, {1, 3}}));
  EXPECT_FALSE(found.is_complex());
  EXPECT_TRUE(check_simplices({{1}, {2}, {2, 1}}, Context()).is_complex());
  EXPECT_TRUE(check_simplices({}, Context()).is_complex());
}

TEST(SimplexListCheck, TheTorusOfTheBookIsOrientedCoherently) {  // H1; H2 with triangles as printed
  EXPECT_TRUE(check_simplices(seven_vertex_torus(), Context()).incoherent.empty());
  EXPECT_TRUE(check_simplices(triangles({123, 134, 142, 243}), Context()).incoherent.empty());
  EXPECT_EQ(check_simplices(triangles({123, 134, 142, 234}), Context()).incoherent.size(), 3U);
  EXPECT_FALSE(check_simplices(six_vertex_projective_plane(), Context()).incoherent.empty());
}

}  // namespace
}  // namespace quoin
