// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/flow_outputs.h"
#include "quoin/cli/flow_report.h"
#include "quoin/cli/flow_sheets.h"
#include "quoin/cli/options.h"
#include "quoin/flow/critical_separation.h"
#include "quoin/flow/flow_graph.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/io/exact_cells.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// Bytes for the triangulation of so many points and what `flow` tells and writes of it, without pages.
std::uint64_t memory_of_flow(std::size_t points, const Options& options);

/// What `flow` asks of points of space, and what of it is to be written.
class FlowOfSpace {
 public:
  /// All must outlive it.
  FlowOfSpace(const Delaunay3& triangulation, const Options& options, const Context& context);

  void report(nlohmann::ordered_json& report);

  /// Each after the report.
  VtkGrid grid(const PointFile& file);
  ExactCells exact_cells(const PointFile& file);
  CellMesh faces(const PointFile& file);
  LayeredScene page(const PointFile& file);
  const std::vector<FlowHistogram>& histograms() const { return histograms_; }

  /// @throws InputError  a page takes more memory than there is
  void announce_page() const;
  /// Of what is written, for warnings: pieces of sheets that reach to infinity.
  std::size_t unbounded_pieces() const { return unbounded_; }

 private:
  bool has_surfaces() const;
  TracedGrid traced();
  const FlowMesh& mesh();
  const FlowGraph& graph();
  const SheetPolygons& sheets();
  void add_counts(nlohmann::ordered_json& report) const;
  template <class Survey>
  nlohmann::ordered_json told(const Survey& survey);
  nlohmann::ordered_json regions();
  nlohmann::ordered_json shape();
  nlohmann::ordered_json simplified();
  nlohmann::ordered_json solid();
  nlohmann::ordered_json peeled();
  const CriticalSeparation& separation();
  nlohmann::ordered_json separated();

  const Options& options_;
  const Context& context_;
  FlowCells flow_;
  std::unique_ptr<FlowGraph> graph_;
  std::optional<CriticalSeparation> separation_;  // where it is asked for
  std::vector<WallSaddle> walls_;
  std::vector<bool> chosen_;  // maxima inside, or that stay
  std::optional<FlowMesh> mesh_;
  std::optional<SheetPolygons> sheets_;
  std::size_t unbounded_ = 0;
  std::vector<FlowHistogram> histograms_;
};

}  // namespace quoin::cli
