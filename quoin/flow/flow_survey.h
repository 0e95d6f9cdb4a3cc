// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/cell_crossing.h"
#include "quoin/flow/flow_cells.h"
#include "quoin/flow/histogram.h"

namespace quoin {

/// Manifolds by the number of their critical point among those of its index, ascending.
using ManifoldList = std::vector<std::uint32_t>;

/// How crossings of Voronoi facets were decided.
struct CrossingStatistics {
  CrossingFilters filters{};
  std::size_t undecided = 0;  ///< crossings that doubles did not decide
  std::size_t depth = 0;      ///< of the longest row of points that were constructed one from another
  std::size_t exact_points = 0;
  std::size_t most_bits = 0;  ///< of a numerator or denominator among them
  Histogram bytes{};          ///< of numerator and denominator together
};

/// All stable surfaces together.
struct StableSurvey {
  std::size_t triangles = 0;
  Histogram depths;  ///< flow segments from each critical edge on a surface's boundary to its saddle
  // Surfaces that are not what they are in general position.
  ManifoldList with_voronoi_vertex;
  ManifoldList with_solid_part;
  ManifoldList with_regular_point;
  CrossingStatistics crossings;
};

/// All ways from saddles of index 2 together.
struct UnstableSurvey {
  Histogram segments;  ///< of each way
  Histogram
      cascades;  ///< consecutive constructed points, for each Voronoi vertex on a way from which facets are crossed
  std::size_t to_infinity = 0;
  // Ways that are not what they are in general position, by their saddles: twice where both are.
  ManifoldList passed_regular;
  ManifoldList in_saddles;
  CrossingStatistics crossings;
};

/// All unstable sheets of saddles of index 1 together.
struct SheetSurvey {
  std::size_t pieces = 0;  ///< of Voronoi facets
  Histogram parts;         ///< of Voronoi edges, for each sheet
  Histogram saddles;       ///< of index 2, at the edges of each sheet
  Histogram vertices;      ///< Voronoi vertices of each sheet
  std::size_t to_infinity = 0;
  // Sheets that are not what they are in general position.
  ManifoldList with_regular_point;
  ManifoldList with_stationary_end;
  CrossingStatistics crossings;
};

/// Follows all stable surfaces and keeps what is counted. @throws Cancelled
StableSurvey survey_stable(const FlowCells& flow, const Context& context);
/// Follows all ways from saddles. @throws Cancelled
UnstableSurvey survey_unstable(const FlowCells& flow, const Context& context);
/// Follows all unstable sheets. @throws Cancelled
SheetSurvey survey_sheets(const FlowCells& flow, const Context& context);

}  // namespace quoin
