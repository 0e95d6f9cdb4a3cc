// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/cells_complex.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/mesh_complex.h"
#include "quoin/io/test_cells.h"
#include "quoin/topology/filtration.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/manifold.h"
#include "quoin/topology/persistence.h"

namespace quoin {
namespace {

using Betti = std::vector<std::size_t>;

SimplicialComplex complex_of(const ExactCells& cells) {
  return SimplicialComplex::closure_of(simplices_of_cells(cells, Context()).simplices, Context());
}

Betti betti_of(const SimplicialComplex& complex) {
  return betti_numbers(collapsed(complex, Context()), 2, Context());
}

/// Each cell with the value of its place among those of its dimension, 10 times the dimension more.
ExactNumbers values_by_dimension(const ExactCells& cells) {
  ExactNumbers values;
  std::array<int, 4> count{};
  for (std::size_t c = 0; c < cells.cell_count(); ++c) {
    const std::size_t dimension = cells.kinds[c] == ExactCellKind::polyhedron ? 3
                                  : cells.kinds[c] == ExactCellKind::polygon  ? 2
                                                                              : cells.cell(c).size() - 1;
    values.add(Rational(count[dimension]++) / Rational(7) + Rational(static_cast<int>(10 * dimension)));
  }
  return values;
}

TEST(CellsComplex, CubesInARowAreABall) {
  for (const std::uint32_t count : {1U, 2U, 6U}) {
    const SimplicialComplex complex = complex_of(test::row_of_cubes(count));
    EXPECT_EQ(complex.dimension(), 3);
    EXPECT_EQ(betti_of(complex), (Betti{1, 0, 0, 0}));
    const ManifoldReport manifold = check_manifold(complex, Context());
    EXPECT_TRUE(manifold.is_manifold());
    EXPECT_FALSE(manifold.is_closed());
    // A new vertex for each square and each cube; a cube has 24 triangles around it, each a simplex with its middle.
    EXPECT_EQ(complex.count(0), 4 * (count + 1) + (5 * count + 1) + count);
    EXPECT_EQ(complex.count(3), 24 * count);
  }
}

TEST(CellsComplex, WithoutItsCubesTheRowHasAsManyHoles) {
  ExactCells cells = test::row_of_cubes(4);
  cells.kinds.resize(cells.kinds.size() - 4);
  cells.begin.resize(cells.kinds.size() + 1);
  cells.parts.resize(cells.begin.back());
  EXPECT_EQ(betti_of(complex_of(cells)), (Betti{1, 0, 4}));
}

TEST(CellsComplex, ATetrahedronByItsFacesIsOneSimplex) {
  ExactCells cells;
  for (const Point3& p : {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) cells.add_point(p);
  for (const auto& t : std::array<std::array<std::uint32_t, 3>, 4>{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})
    cells.add_cell(cells.cell_count() % 2 == 0 ? ExactCellKind::polygon : ExactCellKind::simplex, t);
  cells.add_cell(ExactCellKind::polyhedron, std::array{0U, 2U, 4U, 6U});
  const CellSimplices divided = simplices_of_cells(cells, Context());
  ASSERT_EQ(divided.simplices.size(), 5U);
  EXPECT_EQ(divided.simplices[4].size(), 4U);
  EXPECT_EQ(divided.cell, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

// The same polygons as faces of a mesh, which are divided elsewhere.
TEST(CellsComplex, PolygonsAreWhatFacesOfAMeshAre) {
  std::mt19937 random(8);
  for (int round = 0; round < test_rounds(60); ++round) {
    constexpr std::uint32_t points = 8;
    ExactCells cells;
    Mesh mesh;
    for (std::uint32_t i = 0; i < points; ++i) cells.add_point(Point3{static_cast<double>(i), 0, 0});
    mesh.vertices.resize(points);
    for (int f = 0; f < 6; ++f) {
      std::vector<std::uint32_t> corners(points);
      std::iota(corners.begin(), corners.end(), 0U);
      std::ranges::shuffle(corners, random);
      corners.resize(4 + random() % (points - 4));  // three would be the same triangle twice now and then
      cells.add_cell(ExactCellKind::polygon, corners);
      mesh.add_face(corners);
    }
    const MeshComplex made = complex_of_mesh(mesh, Context());
    if (made.repeated_faces > 0) continue;
    ASSERT_EQ(betti_of(complex_of(cells)), betti_of(SimplicialComplex::closure_of(made.simplices, Context())));
  }
}

// At each value the complex is that of the cells up to there.
TEST(CellsComplex, FiltrationsHaveTheHomologyOfEachOfTheirComplexes) {
  ExactCells cells = test::row_of_cubes(3);
  cells.cell_data.numbers.emplace_back("value", values_by_dimension(cells));
  const FiltrationText text = filtration_of_cells(cells, "x.qcells", Context());
  ASSERT_EQ(text.values.size(), cells.cell_count());
  EXPECT_EQ(text.values[1], Rational(20) + Rational(1) / Rational(7));
  const Filtration filtration = filtration_of(text.simplices, text.grades, Context());
  const std::vector<PersistencePair> pairs = persistence(filtration, {}, Context());
  for (std::uint32_t grades = 1; grades <= text.values.size(); ++grades) {
    ExactCells part = cells;
    part.kinds.resize(grades);  // cells are in the order of their values
    part.begin.resize(grades + 1);
    part.parts.resize(part.begin.back());
    Betti expected = betti_of(complex_of(part));
    expected.resize(4);
    ASSERT_EQ(betti_numbers_at(filtration, pairs, grades - 1), expected) << grades;
  }
}

TEST(CellsComplex, FiltrationsNeedValues) {
  const auto refusal_of = [](const ExactCells& cells) {
    try {
      filtration_of_cells(cells, "x.qcells", Context());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  ExactCells cells = test::row_of_cubes(1);
  EXPECT_NE(refusal_of(cells).find("no numbers 'value'"), std::string::npos);
  ExactNumbers values;
  for (std::size_t c = 0; c < cells.cell_count(); ++c) {
    if (c == 2) {
      values.add_none();
    } else {
      values.add(1.0);
    }
  }
  cells.cell_data.numbers.emplace_back("value", values);
  EXPECT_NE(refusal_of(cells).find("cell 2 has no value"), std::string::npos);
  ExactCells none;
  none.cell_data.numbers.emplace_back("value", ExactNumbers());
  EXPECT_NE(refusal_of(none).find("no cell"), std::string::npos);
}

}  // namespace
}  // namespace quoin
