// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>

#include "quoin/base/context.h"
#include "quoin/cli/point_origins.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/io/exact_cells.h"

namespace quoin::cli {

/// What the command writes about the flow as exact cells: what VtkGrids of `flow_outputs.h` hold, with exact
/// coordinates and squared distances, `square_distance`, in the place of rounded ones.
class ExactFlow {
 public:
  ExactFlow(const FlowCells& flow, const Context& context);

  /// Critical points as simplices of one vertex, with `index` and `number`.
  void add_critical_points(const FlowGraph& graph);
  /// Critical edges, all of them.
  void add_critical_edges();
  /// All input points and, up to a squared distance, critical edges in two halves: as they meet stable surfaces.
  void add_graph(const Rational& most);
  /// Triangles of stable surfaces, of a mesh with its exact points. What they have in common with cells before them are
  /// the same points.
  void add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles);

  /// Ways of all saddles, from each Voronoi vertex to the next.
  void add_ways();
  /// All unstable sheets together, each part once: convex polygons. How many pieces reach to infinity and are left out.
  std::size_t add_sheets();

  /// With what the file says of points, but of ways and sheets, which are away from them.
  ExactCells take(const PointFile& file);

 private:
  /// The point of the cells that is there, or a new one, for which `add_origin()` says where it comes from.
  template <class AddOrigin>
  std::uint32_t place(const RationalPoint3& p, const AddOrigin& add_origin);
  std::uint32_t place_vertex(std::uint32_t vertex);
  /// That has the same distance from all of these vertices.
  std::uint32_t place_centre(const RationalPoint3& p, std::span<const std::uint32_t> vertices);
  /// Of a Delone cell, by its first simplex; and any other point, of ways and sheets.
  std::uint32_t place_cell(std::uint32_t cell);
  std::uint32_t place_constructed(const RationalPoint3& p) { return place_centre(p, {}); }
  void add(std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number,
           const std::optional<Rational>& square, ExactCellKind kind = ExactCellKind::simplex);

  const FlowCells& flow_;
  const Context& context_;
  CriticalValues values_;
  ExactCells cells_;
  PointOrigins origins_;
  bool is_away_ = false;                                        ///< there are ways or sheets
  std::unordered_map<std::uint32_t, std::uint32_t> centres_;    ///< of cells, by place_cell
  std::multimap<std::array<double, 3>, std::uint32_t> places_;  ///< points by their nearest doubles
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> numbers_;
  ExactNumbers squares_;
};

}  // namespace quoin::cli
