// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "quoin/base/context.h"
#include "quoin/cli/alpha_points.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/triangulation/alpha_shape.h"
#include "quoin/triangulation/neighbour_graphs.h"

namespace quoin::cli {

/// The simplices of the complex of so many grades that are faces of no others, with values; all vertices.
VtkGrid grid_of_shape(const AlphaPoints& points, const AlphaIntervals& intervals, std::uint32_t grades,
                      const PointFile& file, const Context& context);

/// Of space: the triangles of that complex that are not in the interior, those of tetrahedra counterclockwise from
/// outside. Of the plane, or of points in one: all triangles. With their vertices.
CellMesh mesh_of_shape(const AlphaPoints& points, const AlphaIntervals& intervals, std::uint32_t grades,
                       const PointFile& file, const Context& context);

/// A line for each simplex of that complex: its value, the nearest double or exactly, and the numbers of its points; by
/// value, dimension and vertices. Returns how many values are written as the ones before them.
/// @throws InputError  a value is beyond the largest double
std::size_t write_filtration(std::ostream& out, const AlphaPoints& points, std::uint32_t grades, bool is_exact,
                             const Context& context);

/// Edges with their lengths; all vertices.
VtkGrid grid_of_graph(const AlphaPoints& points, const VertexPairs& edges, const PointFile& file);

/// A line for each edge, the numbers of two points.
void write_graph(std::ostream& out, const AlphaPoints& points, const VertexPairs& edges, const Context& context);

/// The nearest double of the distance of the ends of each edge, up to a few units in the last place.
std::vector<double> lengths_of(const AlphaPoints& points, const VertexPairs& edges);

}  // namespace quoin::cli
