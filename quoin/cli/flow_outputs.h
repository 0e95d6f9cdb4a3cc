// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "quoin/base/context.h"
#include "quoin/cli/point_origins.h"
#include "quoin/flow/critical_separation.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/vtk_grid.h"

namespace quoin::cli {

/// The ends of an edge of a simplex, vertices.
std::array<std::uint32_t, 2> ends_of(const FlowCells& flow, std::uint32_t cell, unsigned edge);

/// Cells and where their points come from.
struct TracedGrid {
  VtkGrid cells;
  PointOrigins origins;  ///< of its points

  std::uint32_t add_given(const Point3& p, std::uint32_t input);
  /// A point that has the same distance from all of these vertices.
  std::uint32_t add_made(const Point3& p, std::span<const std::uint32_t> vertices, const Delaunay3& triangulation);
};

/// All critical points: vertices with `index`, `number` and `distance`, and `medial` where they are separated.
TracedGrid grid_of_critical_points(const FlowGraph& graph, const std::optional<CriticalSeparation>& separation,
                                   const Context& context);

/// Lines: critical edges, up to a squared distance if there is one, with `index` and `distance`.
void add_critical_edges(const FlowCells& flow, const std::optional<Rational>& most, TracedGrid& grid,
                        const Context& context);

/// Triangles of stable surfaces with `index`, the number of their saddle and its `distance`; numbers are places in the
/// list of saddles.
void add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles, const FlowGraph& graph, TracedGrid& grid);

/// Lines: ways of all saddles, from each Voronoi vertex to the next.
VtkGrid grid_of_arcs(const FlowCells& flow, const Context& context);

/// The triangles alone.
Mesh mesh_of_surfaces(const FlowMesh& mesh);

}  // namespace quoin::cli
