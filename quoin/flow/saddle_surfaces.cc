// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/saddle_surfaces.h"

#include <utility>

namespace quoin {

const SurfacePieces& SaddleSurfaces::follow(CellFacet saddle, const Context& context) {
  chain().clear();
  open_.clear();
  surface_.pieces.clear();
  surface_.has_voronoi_vertex = surface_.has_solid_part = surface_.has_regular_point = false;
  flow_.entering_sides(saddle, sides_);
  const std::uint32_t centre = chain().add_centre(crosser_.entry(sides_[0]));
  for (const CellSide& side : sides_) open_.push_back({side, centre, 1});
  for (std::size_t steps = 1; !open_.empty(); ++steps) {
    if (steps % 256 == 0) context.poll();
    const Open next = open_.back();
    open_.pop_back();
    follow(next);
  }
  return surface_;
}

void SaddleSurfaces::follow(const Open& at) {
  const FlowTriangle entry = crosser_.entry(at.side);
  const CellExit exit = crosser_.backward(at.point, at.side);
  SurfacePiece piece{.edge = {entry[0], entry[1]}, .towards = at.point, .depth = at.depth};
  if (at.is_flipped) std::swap(piece.edge[0], piece.edge[1]);
  piece.is_side = exit.kind == CellExit::Kind::midpoint;
  surface_.has_regular_point |= exit.is_at_midpoint && !piece.is_side;
  if (exit.kind == CellExit::Kind::facet) {
    piece.from = exit.point;
    flow_.entering_sides(exit.facet, sides_);
    // The next triangle has the edge the other way round; its simplex is in front of it where it is above.
    for (const CellSide& side : sides_) {
      open_.push_back({side, exit.point, at.depth + 1, at.is_flipped != exit.is_above});
    }
  }
  if (exit.kind == CellExit::Kind::vertex) enter_cell(exit.cell, piece);
  surface_.pieces.push_back(piece);
}

/// Each way on begins anew, on the Voronoi edge through which it is seen.
void SaddleSurfaces::enter_cell(std::uint32_t cell, SurfacePiece& piece) {
  const auto centre = [this](const CellSide& side) {
    return chain().add_centre(crosser_.entry(side), flow_.cells()[side.facet.cell].vertices[side.facet.slot]);
  };
  surface_.has_voronoi_vertex = true;
  surface_.has_solid_part |= flow_.has_entering_polygon(cell);
  piece.from = centre({{cell, 0}, 1});
  flow_.entering_edges(cell, sides_);
  for (const CellSide& side : sides_) open_.push_back({side, centre(side), piece.depth + 1});
}

}  // namespace quoin
