// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/cli/alpha_points.h"
#include "quoin/cli/triangulated_points.h"
#include "quoin/io/exact_cells.h"
#include "quoin/triangulation/neighbour_graphs.h"

/// Cells of points as the exact text form holds them: vertices with the numbers `input` and `multiplicity` and what the
/// file says of their first points: `weight`, `intensity`, normals as `nx ny nz`, colours as `red green blue alpha`.
namespace quoin::cli {

/// All simplices of full dimension, with the numbers of their Delone cells; or these, by their faces, if they were
/// asked for.
ExactCells exact_cells_of(const TriangulatedPoints& triangulated, const PointFile& file);

/// All simplices of the complex of so many grades, with exact values: by value, dimension and vertices.
ExactCells exact_cells_of_shape(const AlphaPoints& points, std::uint32_t grades, const PointFile& file,
                                const Context& context);

/// Edges with their squared lengths.
ExactCells exact_cells_of_graph(const AlphaPoints& points, const VertexPairs& edges, const PointFile& file);

}  // namespace quoin::cli
