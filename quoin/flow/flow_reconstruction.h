// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_graph.h"

namespace quoin {

/// Which regions of maxima are outside: those that are entered from outside through a saddle that is not much nearer to
/// the points than the maximum.
struct PeelOptions {
  /// A region is entered where the distance at the saddle is at least this part of that at the maximum, in [0, 1].
  Rational ratio = 0.5;
};

/// A saddle between inside and outside.
struct WallSaddle {
  CellFacet facet;
  bool is_inside_first = false;  ///< the inside is on the side of the facet's simplex
};

/// A solid of regions of maxima.
struct FlowSolid {
  std::vector<bool> is_inside;   ///< for each maximum of the graph
  std::vector<WallSaddle> wall;  ///< saddles whose stable surfaces bound it
};

/// The regions that peeling from outside leaves. Does not depend on an order of peeling. Points on a closed surface,
/// densely: saddles near the surface are much nearer to the points than maxima inside are, and those on the way to
/// maxima in bays outside are not. Exact comparisons. O(n). @throws InputError if the ratio is not in [0, 1]; Cancelled
/// Source: Giesen and John 2003. Departs from it: a ratio of distances decides, not the order of their differences, so
/// that the unit of length does not matter.
FlowSolid flow_solid(const FlowGraph& graph, const PeelOptions& options, const Context& context);

/// The boundary of chosen maxima: saddles with one end among them. Infinity is outside.
std::vector<WallSaddle> wall_of(const FlowGraph& graph, const std::vector<bool>& is_inside);

/// Saddles between different regions of a simplified graph, by what each maximum becomes; infinity is the last region.
/// The one with the smaller number is inside.
std::vector<WallSaddle> walls_between(const FlowGraph& graph, std::span<const std::uint32_t> becomes);

/// Triangles with shared corners.
struct FlowMesh {
  static constexpr std::uint32_t constructed = 0xFFFFFFFF;

  std::vector<Point3> points;  ///< vertices of the triangulation that are used, midpoints, and constructed points
  std::vector<std::uint32_t> vertex_of;                 ///< by point: the vertex of the triangulation, or `constructed`
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< the first corner is a vertex of the triangulation
  std::vector<std::uint32_t> saddle_of;                 ///< of each triangle, by place in the list of saddles
  std::size_t not_ordinary = 0;  ///< surfaces that are not what they are in general position; their triangles' sides
                                 ///< and boundaries may be wrong
  std::vector<RationalPoint3> exact_points;  ///< what the points are rounded from, if asked for
};

struct FlowMeshOptions {
  bool keeps_exact_points = false;
};

/// The stable surfaces of saddles as triangles: counterclockwise seen from outside where they bound a solid.
/// Coordinates are exact ones, each rounded to the nearest double. @throws Cancelled
FlowMesh flow_mesh(const FlowCells& flow, std::span<const WallSaddle> wall, const Context& context,
                   const FlowMeshOptions& options = {});

}  // namespace quoin
