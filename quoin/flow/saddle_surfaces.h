// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/cell_crossing.h"

namespace quoin {

/// What one Voronoi facet contributes to a stable surface: two triangles, from either end of its edge to the segment
/// between two points.
struct SurfacePiece {
  /// Vertices of the triangulation. The triangles (edge[0], from, towards) and (edge[1], towards, from) are
  /// counterclockwise seen from the side of the simplex of the saddle's facet, along all of a surface that has no
  /// Voronoi vertex.
  std::array<std::uint32_t, 2> edge{};
  std::uint32_t towards = 0;                 ///< a point, by the chain
  std::uint32_t from = CrossingChain::none;  ///< the other; none is the midpoint of the edge
  unsigned depth = 0;                        ///< flow segments from `from` to the saddle
  bool is_side = false;                      ///< the edge is critical: it bounds the surface
};

/// What StableSurface has, as pieces.
struct SurfacePieces {
  std::vector<SurfacePiece> pieces;
  bool has_voronoi_vertex = false;
  bool has_solid_part = false;
  bool has_regular_point = false;

  bool is_ordinary() const { return !has_voronoi_vertex && !has_solid_part && !has_regular_point; }
};

/// Stable surfaces of critical points of index 2, one after another, for surveys of all of them: what stable_surface
/// tells, in about the time of the triangulation.
class SaddleSurfaces {
 public:
  /// The cells must outlive it.
  explicit SaddleSurfaces(const FlowCells& flow) : flow_(flow), crosser_(flow) {}

  /// The pieces are valid until the next call, and so is what the chain says of their points. O(k) for k pieces with
  /// rings of bounded size. @throws Cancelled
  const SurfacePieces& follow(CellFacet saddle, const Context& context);

  CrossingChain& chain() { return crosser_.chain(); }
  const CellCrosser& crosser() const { return crosser_; }

 private:
  struct Open {
    CellSide side;
    std::uint32_t point;
    unsigned depth;
    bool is_flipped = false;  ///< the surface's front is not where the side's simplex is
  };
  void follow(const Open& at);
  void enter_cell(std::uint32_t cell, SurfacePiece& piece);

  const FlowCells& flow_;
  CellCrosser crosser_;
  SurfacePieces surface_;
  std::vector<Open> open_;
  std::vector<CellSide> sides_;
};

}  // namespace quoin
