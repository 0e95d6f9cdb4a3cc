// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/location/location.h"

namespace quoin {

struct DecompositionOptions {
  /// False: walls only where an input curve ends. Cells are then pseudo-trapezoids with chains of edges at top and
  /// bottom.
  bool walls_at_crossings = true;
};

/// A part of a face between vertical walls through vertices.
struct PseudoTrapezoid {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  dcel::EdgeId top;     ///< at the left wall; none: the cell reaches the top side, or the box
  dcel::EdgeId bottom;  ///< at the left wall; none: the cell reaches the bottom side, or the box
  dcel::VertexId left;  ///< whose wall bounds the cell; none: it reaches the left side. May be the end of a vertical
                        ///< line at infinity
  dcel::VertexId right;
  dcel::FaceId face;
  std::uint32_t upper_left = none;   ///< neighbour across the left wall that goes on below the same top
  std::uint32_t lower_left = none;   ///< neighbour across the left wall that goes on above the same bottom
  std::uint32_t upper_right = none;  ///< as `upper_left`, across the right wall
  std::uint32_t lower_right = none;  ///< as `lower_left`, across the right wall
  bool has_width = true;             ///< false: both walls have one x, the cell is part of a wall
};

/// What a vertex sees straight below and above: the first vertex or edge that is not vertical, or the face where
/// nothing is; see RayShooter.
struct VerticalView {
  Location below;
  Location above;
};

struct VerticalDecomposition {
  std::vector<PseudoTrapezoid> trapezoids;  ///< in the order of their left walls
  std::vector<VerticalView> views;          ///< by vertex; of real ones
};

/// The vertical decomposition of an arrangement, by one sweep over its edges.
///
/// Exact. O(n log n). For n segments in general position with k crossings there are 3n + 3k + 1 cells, or 3n + k + 1
/// with walls at ends of curves only, in the plane as in any box that contains all vertices. Vertices of one x follow
/// each other from bottom to top, as if walls leaned to the left: between them lie cells without width. A family
/// without `compare_x` sees only edges, and every cell has width.
/// @throws Cancelled
template <CurveFamily F>
VerticalDecomposition decompose_vertically(const Arrangement<F>& arrangement, const DecompositionOptions& options,
                                           const Context& context);

}  // namespace quoin
