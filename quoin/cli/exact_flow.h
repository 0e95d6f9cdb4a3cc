// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
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
  /// Critical edges, up to a squared distance if there is one.
  void add_critical_edges(const std::optional<Rational>& most);
  /// Triangles of stable surfaces, of a mesh with its exact points.
  void add_surfaces(const FlowMesh& mesh, std::span<const WallSaddle> saddles);

  ExactCells take();

 private:
  template <class Point>
  std::uint32_t add_point(const Point& p) {
    cells_.add_point(p);
    return static_cast<std::uint32_t>(cells_.point_count() - 1);
  }
  void add(std::span<const std::uint32_t> corners, std::uint32_t index, std::uint32_t number, const Rational& square);

  const FlowCells& flow_;
  const Context& context_;
  CriticalValues values_;
  ExactCells cells_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> numbers_;
  ExactNumbers squares_;
};

}  // namespace quoin::cli
