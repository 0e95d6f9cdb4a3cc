// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_graph.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/flow/histogram.h"

namespace quoin {

/// The points that flow to a maximum: a solid, bounded by stable surfaces of saddles from which one way leads to it.
struct FlowRegion {
  std::uint32_t maximum = 0;   ///< by its place in the graph
  std::uint32_t vertices = 0;  ///< Voronoi vertices that flow to it, itself one of them
  /// Places of the saddles whose surfaces bound it, ascending; the inside is on the side of the facet's simplex or not.
  std::vector<WallSaddle> walls;
  std::vector<std::uint32_t> wall_numbers;  ///< the same saddles by their places in the graph
  std::uint32_t inner_saddles = 0;          ///< both ways lead to it: their surfaces are inside
  bool is_beside_infinity = false;          ///< behind a wall is what flows to infinity
};

/// All regions, by ascending maxima.
struct FlowRegions {
  std::vector<FlowRegion> regions;
  std::size_t vertices_to_infinity = 0;  ///< Voronoi vertices that flow there
  std::size_t vertices_to_saddles = 0;   ///< on stable surfaces; never happens in general position
};

/// The stable manifolds of all maxima. O(n) beyond the graph. @throws Cancelled
/// Source: Giesen and John 2003.
FlowRegions flow_regions(const FlowGraph& graph, const Context& context);

/// What is counted of regions.
struct RegionSurvey {
  Histogram vertices;  ///< of each region
  Histogram walls;     ///< saddles on its boundary
  std::size_t inner_saddles = 0;
  std::size_t beside_infinity = 0;
  std::size_t triangles = 0;  ///< of all walls, each counted once
  /// Regions with a wall that is not what it is in general position: their boundaries may have holes.
  std::vector<std::uint32_t> not_ordinary;
};

/// Follows the surface of each wall once. @throws Cancelled
RegionSurvey survey_regions(const FlowGraph& graph, const FlowRegions& regions, const Context& context);

}  // namespace quoin
