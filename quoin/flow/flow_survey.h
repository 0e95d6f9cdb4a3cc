// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/base/context.h"
#include "quoin/flow/flow_cells.h"
#include "quoin/flow/histogram.h"

namespace quoin {

/// How crossings of Voronoi facets were decided.
struct CrossingStatistics {
  std::size_t comparisons = 0;
  std::size_t undecided = 0;  ///< crossings that doubles did not decide
  std::size_t exact_points = 0;
  std::size_t most_bits = 0;  ///< of a numerator or denominator among them
};

/// All stable surfaces together.
struct StableSurvey {
  std::size_t triangles = 0;
  Histogram depths;  ///< flow segments from each critical edge on a surface's boundary to its saddle
  // Surfaces that are not what they are in general position.
  std::size_t with_voronoi_vertex = 0;
  std::size_t with_solid_part = 0;
  std::size_t with_regular_point = 0;
  CrossingStatistics crossings;
};

/// All ways from saddles of index 2 together.
struct UnstableSurvey {
  Histogram segments;  ///< of each way
  Histogram
      cascades;  ///< consecutive constructed points, for each Voronoi vertex on a way from which facets are crossed
  std::size_t to_infinity = 0;
  std::size_t passed_regular = 0;
  std::size_t in_saddles = 0;
  CrossingStatistics crossings;
};

/// Follows all stable surfaces and keeps what is counted. @throws Cancelled
StableSurvey survey_stable(const FlowCells& flow, const Context& context);
/// Follows all ways from saddles. @throws Cancelled
UnstableSurvey survey_unstable(const FlowCells& flow, const Context& context);

}  // namespace quoin
