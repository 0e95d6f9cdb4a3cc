// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/cells_text.h"

#include <gtest/gtest.h>

#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/test_cells.h"

namespace quoin {
namespace {

std::string text_of(const ExactCells& cells) {
  std::ostringstream out;
  write_cells_text(out, cells, Context());
  return out.str();
}

std::string refusal_of(const std::string& text) {
  try {
    read_cells_text(text, "x.qcells", Context());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

void expect_refusal(const std::string& text, const std::string& what) {
  EXPECT_NE(refusal_of(text).find(what), std::string::npos) << refusal_of(text) << "\nnot " << what << "\n" << text;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

TEST(CellsText, AKnownText) {
  const std::string text =
      "quoin-cells 1\ncoordinates 2\npoint-integers input\npoint-numbers\npoints 3\n0 0.5 7\n1/3 -2 -\n1e+300 0 0\n"
      "cell-integers\ncell-numbers value\ncells 2\nsimplex 1/7 0 2\npolygon - 2 1 0\nend\n";
  const ExactCells cells = read_cells_text(
      "\xEF\xBB\xBF" + replaced(replaced(text, "1/3", "+2/6"), "points 3\n", "points 3 # three\r\n\r\n# and\n"),
      "x.qcells", Context());
  EXPECT_EQ(cells.dimension, 2U);
  EXPECT_EQ(cells.point_count(), 3U);
  EXPECT_EQ(cells.positions.exact(2), Rational(1) / Rational(3));
  EXPECT_EQ(cells.point_data.integers[0].second, (std::vector<std::uint32_t>{7, ExactColumns::none, 0}));
  EXPECT_EQ(cells.kinds, (std::vector{ExactCellKind::simplex, ExactCellKind::polygon}));
  EXPECT_EQ(cells.parts, (std::vector<std::uint32_t>{0, 2, 2, 1, 0}));
  ASSERT_NE(cells.cell_data.find_numbers("value"), nullptr);
  EXPECT_EQ(cells.cell_data.find_numbers("value")->exact(0), Rational(1) / Rational(7));
  EXPECT_TRUE(cells.cell_data.find_numbers("value")->is_none(1));
  EXPECT_EQ(cells.cell_data.find_integers("value"), nullptr);
  EXPECT_EQ(text_of(cells), text);
}

TEST(CellsText, WrittenAndReadNothingIsLost) {
  std::mt19937 random(5);
  for (int round = 0; round < test_rounds(200); ++round) {
    const ExactCells cells = test::random_cells(random);
    const std::string text = text_of(cells);
    const ExactCells again = read_cells_text(text, "x.qcells", Context());
    ASSERT_EQ(again, cells) << text;
    ASSERT_EQ(text_of(again), text);
  }
  for (const std::uint32_t count : {0U, 1U, 5U}) {
    const ExactCells cells = test::row_of_cubes(count);
    EXPECT_EQ(read_cells_text(text_of(cells), "x.qcells", Context()), cells);
  }
  EXPECT_EQ(read_cells_text(text_of({}), "x.qcells", Context()), ExactCells());
}

TEST(CellsText, EveryCutIsRefused) {
  const std::string text = text_of(test::row_of_cubes(1));
  const std::size_t end = text.size() - 1;  // the last line break may be missing
  for (std::size_t size = 0; size < end; ++size) ASSERT_NE(refusal_of(text.substr(0, size)), "") << size;
  EXPECT_EQ(refusal_of(text.substr(0, end)), "");
}

TEST(CellsText, RefusalsNameTheLine) {
  const std::string text =
      "quoin-cells 1\ncoordinates 3\npoint-integers a b\npoint-numbers c\npoints 3\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 "
      "2 "
      "3\ncell-integers\ncell-numbers\ncells 2\nsimplex 0 1\npolygon 0 1 2\nend\n";
  ASSERT_EQ(refusal_of(text), "");
  expect_refusal(replaced(text, "cells 1", "cells 2"), "x.qcells:1: this version");
  expect_refusal(replaced(text, "coordinates 3", "coordinates 4"), "x.qcells:2: '4'");
  expect_refusal(replaced(text, "integers a b", "integers a a"), "x.qcells:3: 'a' names two");
  expect_refusal(replaced(text, "numbers c", "numbers b"), "x.qcells:4: 'b' names two");
  expect_refusal(replaced(text, "points 3", "points 99999"), "x.qcells:5: this count");
  expect_refusal(replaced(text, "points 3", "points -1"), "x.qcells:5: this count");
  expect_refusal(replaced(text, "points 3", "points 4"), "x.qcells:9");
  expect_refusal(replaced(text, "0 0 0 1 2 3", "0 0 0 1 2"), "x.qcells:6: the line is too short");
  expect_refusal(replaced(text, "0 0 0 1 2 3", "0 0 0 1 2 3 4"), "x.qcells:6: '4' does not belong");
  expect_refusal(replaced(text, "0 0 0 1 2 3", "0 0 - 1 2 3"), "x.qcells:6");
  for (const char* bad : {"nan", "1e999", "inf", "1/0", "x", "1/2/3"})
    expect_refusal(replaced(text, "0 0 0 1 2 3", std::string("0 0 ") + bad + " 1 2 3"), "x.qcells:6: ");
  expect_refusal(replaced(text, "0 0 0 1 2 3", "0 0 0 1.5 2 3"), "x.qcells:6: ");
  expect_refusal(replaced(text, "0 0 0 1 2 3", "0 0 0 4294967295 2 3"), "x.qcells:6: index");
  expect_refusal(replaced(text, "simplex", "cube"), "x.qcells:12: 'cube' is no kind");
  expect_refusal(replaced(text, "simplex 0 1", "simplex"), "x.qcells:12: a simplex needs");
  expect_refusal(replaced(text, "simplex 0 1", "simplex 0 3"), "x.qcells:12: index 3");
  expect_refusal(replaced(text, "simplex 0 1", "simplex 1 1"), "x.qcells:12: point 1 stands here twice");
  expect_refusal(replaced(text, "polygon 0 1 2", "polygon 0 1"), "x.qcells:13: a polygon has");
  expect_refusal(replaced(text, "polygon 0 1 2", "polyhedron 0"), "x.qcells:13: '0' has no sign");
  expect_refusal(replaced(text, "polygon 0 1 2", "polyhedron +0"), "x.qcells:13: cell 0 is neither");
  expect_refusal(replaced(text, "polygon 0 1 2", "polyhedron +1"), "x.qcells:13: index 1");
  expect_refusal(replaced(text, "end", "end\nend"), "x.qcells:15: nothing should follow");
  EXPECT_FALSE(is_cells_text("quoin-solid 1"));
  EXPECT_TRUE(is_cells_text(text));
}

TEST(CellsText, PolyhedraHaveClosedSurfaces) {
  const std::string text = text_of(test::row_of_cubes(2));
  ASSERT_EQ(refusal_of(text), "");
  const std::string first = "polyhedron -0 +1 -3 -4 -5 -6";
  expect_refusal(replaced(text, first, "polyhedron -0 +1 -3 -4 -5"), "one way alone");
  expect_refusal(replaced(text, first, "polyhedron +0 +1 -3 -4 -5 -6"), "is met twice");
  expect_refusal(replaced(text, first, "polyhedron -0 +1 -3 -4 -5 -6 -6"), "on this side of face 6");
  expect_refusal(replaced(text, first, "polyhedron +0 -0"), "at least four");
  expect_refusal(replaced(text, first, "polyhedron"), "at least four");
  expect_refusal(replaced(text, first, "polyhedron +0 -0 +1 -1"), "of 2 pieces");
  expect_refusal(replaced(text, "polyhedron -1 +2", "polyhedron +1 +2"), "on this side of face 1");
  expect_refusal(replaced(text, "coordinates 3", "coordinates 2"), "x.qcells:6");
}

// Two tetrahedra with a common point, and a torus of nine squares, are no balls.
TEST(CellsText, PinchedAndPiercedSurfacesAreNoPolyhedra) {
  const auto text = [](unsigned points, const std::vector<std::string>& faces) {
    std::string all =
        "quoin-cells 1\ncoordinates 3\npoint-integers\npoint-numbers\npoints " + std::to_string(points) + "\n";
    for (unsigned i = 0; i < points; ++i) all += std::to_string(i) + " 0 0\n";
    all += "cell-integers\ncell-numbers\ncells " + std::to_string(faces.size() + 1) + "\n";
    std::string last = "polyhedron";
    for (std::size_t f = 0; f < faces.size(); ++f) {
      all += "polygon " + faces[f] + "\n";
      last += " +" + std::to_string(f);
    }
    return all + last + "\nend\n";
  };
  const std::vector<std::string> one{"0 2 1", "0 1 3", "1 2 3", "2 0 3"};
  EXPECT_EQ(refusal_of(text(4, one)), "");
  std::vector<std::string> two = one;
  for (const char* face : {"0 5 4", "0 4 6", "4 5 6", "5 0 6"}) two.emplace_back(face);
  expect_refusal(text(7, two), "of 2 pieces");
  std::vector<std::string> torus;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j) {
      const auto at = [&](unsigned a, unsigned b) { return std::to_string(3 * ((i + a) % 3) + (j + b) % 3); };
      torus.push_back(at(0, 0) + " " + at(1, 0) + " " + at(1, 1) + " " + at(0, 1));
    }
  }
  expect_refusal(text(9, torus), "handles or corners");
}

TEST(CellsText, CanBeCancelled) {
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(read_cells_text(text_of(test::row_of_cubes(3)), "x.qcells", cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
