// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <span>

#include "quoin/base/context.h"
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

  ExactCells take();

 private:
  /// The point of the cells that is there, a new one if there is none.
  std::uint32_t place(const RationalPoint3& p);
  /// The ends of an edge of a simplex.
  std::array<std::uint32_t, 2> ends(std::uint32_t cell, unsigned edge);
  void add(std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number, const Rational& square);

  const FlowCells& flow_;
  const Context& context_;
  CriticalValues values_;
  ExactCells cells_;
  std::multimap<std::array<double, 3>, std::uint32_t> places_;  ///< points by their nearest doubles
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> numbers_;
  ExactNumbers squares_;
};

}  // namespace quoin::cli
