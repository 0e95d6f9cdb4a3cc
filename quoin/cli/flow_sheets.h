// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/flow_outputs.h"
#include "quoin/flow/critical_values.h"
#include "quoin/flow/flow_regions.h"
#include "quoin/flow/saddle_sheets.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/solid/mesh.h"

namespace quoin::cli {

/// Unstable sheets of saddles of index 1 as polygons. Voronoi vertices are exact ones, each coordinate rounded to the
/// nearest double, constructed points good to six digits of the largest coordinate, so that polygons are flat up to
/// that.
struct SheetPolygons {
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;  ///< of one polygon after the other
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> number;  ///< of each polygon: the sheet that it was made of, by its critical edge
  std::vector<double> distance;       ///< of that edge's midpoint from the points
  std::size_t unbounded = 0;          ///< pieces that are left out

  std::size_t count() const { return number.size(); }
  std::span<const std::uint32_t> polygon(std::size_t i) const {
    return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};
/// All sheets together, each part once, of the first sheet that has it; corners are shared.
SheetPolygons sheet_polygons(const FlowCells& flow, const Context& context);

/// Makes them, one sheet after another: of fresh parts, or each sheet as a whole, which is to be taken before the next.
class SheetPolygonMaker {
 public:
  /// The cells must outlive it.
  SheetPolygonMaker(const FlowCells& flow, SheetParts parts);

  /// The sheet of a critical edge, by its number in a simplex and that of the critical point. @throws Cancelled
  void add(std::uint32_t cell, unsigned edge, std::uint32_t number, const Context& context);

  SheetPolygons take() { return std::exchange(made_, {}); }

 private:
  std::uint32_t add_point(const Point3& p);
  const Point3& centre(std::uint32_t cell);
  std::uint32_t place(const SheetCorner& corner);

  SheetParts parts_;
  SaddleSheets sheets_;
  CriticalValues values_;
  double unscale_;
  SheetPolygons made_;
  std::unordered_map<std::uint32_t, std::uint32_t> centres_;  // by Delone cell, among the points
  std::vector<std::uint32_t> constructed_;                    // by point of the chain
  std::unordered_map<std::uint32_t, Point3> rounded_;         // by Delone cell
};

/// Corners of each piece that does not reach to infinity; how many do.
template <class Visit>
std::size_t for_each_bounded_piece(const CellSheet& sheet, const Visit& visit) {
  std::size_t unbounded = 0;
  for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
    const CellSheetPiece& piece = sheet.pieces[i];
    const std::size_t end = i + 1 < sheet.pieces.size() ? sheet.pieces[i + 1].first_corner : sheet.corners.size();
    if (piece.is_bounded) visit(std::span(sheet.corners).subspan(piece.first_corner, end - piece.first_corner));
    unbounded += piece.is_bounded ? 0 : 1;
  }
  return unbounded;
}

/// Polygons with `index`, `number` and `distance`.
VtkGrid grid_of_sheets(const SheetPolygons& sheets);
Mesh mesh_of_sheets(const SheetPolygons& sheets);

/// Polyhedra: regions of maxima with their walls as faces, and with `index`, `number` (of the maximum), `walls` (how
/// many saddles), `beside_infinity` and `distance` (of the maximum).
TracedGrid grid_of_regions(const FlowGraph& graph, const Context& context);

}  // namespace quoin::cli
