// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/delone2.h"

/// Delone cells by their faces, for outputs: cells without points, whose numbers are those of the vertices of the
/// triangulation.
namespace quoin::cli {

/// Of dimension 3 facets as polygons, then cells as polyhedra; of dimension 2 cells as polygons; of lower dimension
/// simplices. @throws Cancelled
ExactCells delone_faces(const Delaunay3& triangulation, const Context& context);
ExactCells delone_faces(const Delaunay2& triangulation, const Delone2& delone, const Context& context);

/// Adds them to a grid with the vertices as points: cells of full dimension.
void add_to_grid(const ExactCells& faces, VtkGrid& grid);

/// Calls add(corners) for each polygon that bounds one polyhedron, counterclockwise seen from outside; where there are
/// no polyhedra, for all polygons.
template <class Add>
void for_each_outer_polygon(const ExactCells& faces, const Add& add) {
  std::vector<bool> is_used(2 * faces.cell_count(), false);
  bool has_polyhedra = false;
  for (std::size_t c = 0; c < faces.cell_count(); ++c) {
    if (faces.kinds[c] != ExactCellKind::polyhedron) continue;
    has_polyhedra = true;
    for (const std::uint32_t part : faces.cell(c)) is_used[part] = true;
  }
  std::vector<std::uint32_t> corners;
  for (std::uint32_t c = 0; c < faces.cell_count(); ++c) {
    const bool is_turned = is_used[ExactCells::part_of(c, true)];
    if (faces.kinds[c] != ExactCellKind::polygon) continue;
    if (has_polyhedra && is_turned == is_used[ExactCells::part_of(c, false)]) continue;
    corners.assign(faces.cell(c).begin(), faces.cell(c).end());
    if (is_turned) std::reverse(corners.begin(), corners.end());
    add(corners);
  }
}

}  // namespace quoin::cli
