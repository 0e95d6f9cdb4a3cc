// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_complex.h"

namespace quoin {

/// A part of the Voronoi edge of a polygon, between two places on its line z + t n; nothing at an end: infinity.
struct VoronoiInterval {
  std::uint32_t polygon = 0;
  std::optional<Rational> low{};
  std::optional<Rational> high{};
};

/// A part of the Voronoi facet of an edge: all that flows through it from an interval of its boundary.
struct SheetPiece {
  std::uint32_t edge = 0;
  /// Where it is entered; nothing for the whole facet, which is the first piece.
  std::optional<VoronoiInterval> entry{};
};

/// The closure of what flows from the neighbourhood of a critical point of index 1: parts of Voronoi facets, Voronoi
/// edges, and the ways of Voronoi vertices on them, which are curves. Exact.
struct UnstableSheet {
  std::uint32_t edge = 0;
  std::vector<SheetPiece> pieces;
  std::vector<VoronoiInterval> along;  ///< parts of Voronoi edges that the flow follows, where the surface ends
  std::vector<std::uint32_t> cells;  ///< Voronoi vertices on the boundary of pieces and at ends of `along`, ascending;
                                     ///< follow them with an ArcTracer
  std::vector<std::uint32_t> saddles;  ///< critical polygons whose centres are inside those parts, ascending
  bool is_infinite = false;            ///< it is not bounded
  /// An end of a part is a stationary point, or one that is not critical is inside: then neighbours end elsewhere.
  bool is_ordinary = true;
};

/// The unstable sheet of a critical edge. Each part of a Voronoi edge is followed once. Rationals throughout: meant for
/// single sheets; some grow with the diameter of the input.
/// @throws InputError if the edge is not critical; Cancelled
/// Source: section 2.3 of Cazals, Parameswaran and Pion. Departs from it: the image of an interval is the upper
/// envelope of linear functions, one for each polygon around the facet.
UnstableSheet unstable_sheet(const FlowComplex& flow, std::uint32_t edge, const Context& context);

}  // namespace quoin
