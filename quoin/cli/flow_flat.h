// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/flow_report.h"
#include "quoin/cli/options.h"
#include "quoin/flow/flat_flow.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// What `flow` says of points of one plane, one line or one place: all that is defined there.
class FlowOfFlat {
 public:
  FlowOfFlat(const Delaunay3& triangulation, const Options& options, const Context& context);

  void report(nlohmann::ordered_json& report, std::vector<std::string>& warnings);
  /// Critical points, critical edges, triangles of the plane, or ways in the plane.
  VtkGrid grid(const PointFile& file);
  /// The same with exact coordinates; of --shape with all points, and critical edges in two halves, as triangles meet
  /// them.
  ExactCells exact_cells(const PointFile& file);
  /// Triangles of the plane.
  CellMesh mesh(const PointFile& file);
  LayeredScene page(const PointFile& file);
  /// @throws InputError  a page takes more memory than there is
  void announce_page() const;
  const std::vector<FlowHistogram>& histograms() const { return histograms_; }

 private:
  class Cells;

  nlohmann::ordered_json unstable();
  nlohmann::ordered_json shape();
  Cells cells();
  void add_points(Cells& cells) const;
  void add_ways(Cells& cells);
  void add_edges(Cells& cells) const;
  void add_triangles(Cells& cells) const;

  const Delaunay3& triangulation_;
  const Options& options_;
  const Context& context_;
  FlowComplex complex_;
  FlatFlow flow_;
  std::vector<std::uint32_t> edges_;     ///< critical ones that go to outputs
  std::vector<std::uint32_t> polygons_;  ///< whose surfaces do
  std::vector<FlowHistogram> histograms_;
};

}  // namespace quoin::cli
