// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/vtk_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "quoin/base/error.h"

namespace quoin {
namespace {

const Context context;

VtkGrid sample() {
  VtkGrid grid;
  grid.points = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e300}};
  grid.add_cell(VtkCell::tetrahedron, std::array<std::uint32_t, 4>{0, 1, 2, 3});
  grid.add_cell(VtkCell::line, std::array<std::uint32_t, 2>{0, 3});
  return grid;
}

std::string written(const VtkGrid& grid, const std::string& title) {
  std::ostringstream out;
  write_vtk(out, grid, title, context);
  return out.str();
}

TEST(VtkGrid, TextOfTheFormat) {
  VtkGrid grid = sample();
  EXPECT_EQ(written(grid, "a\nb"),
            "# vtk DataFile Version 3.0\na b\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0.1 0 0\n1 0 0\n0 1 "
            "0\n0 0 1e+300\nCELLS 2 8\n4 0 1 2 3\n2 0 3\nCELL_TYPES 2\n10\n3\n");
  grid.point_integers.push_back({"input", {4, 3, VtkGrid::none, 1}});
  grid.colors.assign(4, {255, 0, 0, 255});
  grid.normals.assign(4, {0, 0, 1});
  grid.cell_doubles.push_back({"volume", {0.5, 0}});
  const std::string text = written(grid, "");
  EXPECT_NE(
      text.find("POINT_DATA 4\nSCALARS input int 1\nLOOKUP_TABLE default\n4\n3\n-1\n1\nCOLOR_SCALARS color 4\n1 0 "
                "0 1\n"),
      std::string::npos);
  EXPECT_NE(text.find("NORMALS normal double\n0 0 1\n"), std::string::npos);
  EXPECT_NE(text.find("CELL_DATA 2\nSCALARS volume double 1\nLOOKUP_TABLE default\n0.5\n0\n"), std::string::npos);
}

TEST(VtkGrid, RefusesWhatIsNotFiniteAndIsCancelled) {
  VtkGrid grid = sample();
  grid.points[1].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(written(grid, "a"), InputError);
  grid.points[1].y = 0;
  grid.cell_doubles.emplace_back("size", std::vector<double>(grid.types.size(), 1));
  EXPECT_NO_THROW(written(grid, "a"));
  grid.cell_doubles.back().second[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(written(grid, "a"), InputError);
  Context cancelled;
  cancelled.cancel();
  VtkGrid large = sample();
  large.points.resize(100'000);
  std::ostringstream out;
  EXPECT_THROW(write_vtk(out, large, "a", cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
