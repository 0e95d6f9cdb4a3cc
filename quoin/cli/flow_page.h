// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/cli/options.h"
#include "quoin/flow/critical_separation.h"
#include "quoin/flow/flow_cells.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/number/rational.h"

namespace quoin::cli {

/// What a page of the flow shows beside points and critical points.
struct FlowPage {
  bool edges = false;                              ///< what flows to saddles of index 1
  bool surfaces = false;                           ///< what flows to those of index 2
  bool ways = false;                               ///< where it flows from those; in a plane, from those of index 1
  bool sheets = false;                             ///< what flows from saddles of index 1
  bool tunnels = false;                            ///< in the persistence diagram
  std::string wall_name{};                         ///< empty, or a layer with the surfaces of
  std::vector<WallSaddle> walls{};                 ///< these
  std::string chosen_name{};                       ///< where walls are, of maxima in a layer by themselves,
  std::vector<bool> chosen{};                      ///< these
  std::string other_name{};                        ///< of the other maxima
  std::optional<CriticalSeparation> separation{};  ///< of critical points, in layers of their own
  std::optional<Rational> distance{};  ///< squared, that is shown first; else the page chooses, or all where walls are
  std::string left_out{};              ///< what is not in the page and why
};

/// A layer of a page holds no more of them, those of the least distances.
inline constexpr std::size_t most_flow_triangles = std::size_t{1} << 23;
inline constexpr std::size_t most_flow_segments = std::size_t{1} << 21;
/// Of sheets that are there each by itself, as much as they share.
inline constexpr std::size_t most_picked_triangles = std::size_t{1} << 21;

/// What the command line asks for; where it asks for nothing, all that the number of points allows. Walls and chosen
/// maxima are to be filled in.
FlowPage flow_page_of(const Options& options, std::size_t points);

/// The same of points of one plane, line or place: `ways` are those of index 1, and there are no walls.
FlowPage flat_page_of(const Options& options, std::size_t points);

/// Bytes that the page will take beside the cells, the graph included. Measured on noisy surfaces and in cubes.
std::uint64_t memory_of_flow_page(const FlowPage& page, const FlowCells& flow);
/// The same of points of one plane or line, of which so many are different.
std::uint64_t memory_of_flat_page(std::size_t points);

}  // namespace quoin::cli
