// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/flow/crossing_chain.h"
#include "quoin/flow/facet_spokes.h"
#include "quoin/flow/flow_cells.h"

namespace quoin {

/// Where a line in a Voronoi facet leaves it, as facets of simplices.
struct CellExit {
  enum class Kind : std::uint8_t {
    facet,     ///< in an open Voronoi edge
    vertex,    ///< in a Voronoi vertex
    infinity,  ///< nowhere
    midpoint   ///< it ends in the midpoint of the edge, a critical point
  };
  Kind kind = Kind::infinity;
  bool is_at_midpoint = false;                ///< in the midpoint of the edge, on the boundary of the facet
  CellFacet facet{};                          ///< of the Voronoi edge
  bool is_above = false;                      ///< its simplex is where the normal of the point's triangle points
  std::uint32_t cell = 0;                     ///< of the Voronoi vertex
  std::uint32_t point = CrossingChain::none;  ///< on the Voronoi edge
};

/// How often a question was asked in doubles, and how often they did not answer it.
struct FilterCount {
  std::size_t calls = 0;
  std::size_t undecided = 0;
};

/// The questions of crossings.
struct CrossingFilters {
  FilterCount starts{};       ///< whether the place of the point is known well enough to go on from
  FilterCount comparisons{};  ///< which of two Voronoi edges is met first
  FilterCount exits{};        ///< whether the first one is met at all
  FilterCount landings{};     ///< where it is met; computed exactly only if somebody asks
};

/// cross_forward and cross_backward of facet_crossing.h on the simplices of a triangulation: the same exits. Doubles
/// with bounds decide; where they cannot, rationals do. O(k) for k simplices around the edge.
class CellCrosser {
 public:
  /// The cells must outlive it.
  explicit CellCrosser(const FlowCells& flow);

  CrossingChain& chain() { return chain_; }
  const CrossingChain& chain() const { return chain_; }

  /// Corners of the facet's triangle: those of the side, then the one opposite. The normal points to the simplex.
  FlowTriangle entry(const CellSide& side) const;

  /// With the flow, away from the midpoint of the side, from a point on the Voronoi edge of the side's facet.
  CellExit forward(std::uint32_t point, const CellSide& side);
  /// Against the flow.
  CellExit backward(std::uint32_t point, const CellSide& side);

  const CrossingFilters& filters() const { return filters_; }
  /// How many crossings doubles left undecided.
  std::size_t undecided_count() const { return undecided_; }

 private:
  bool is_usable(const flow::RoundedRay& ray);
  CellExit exit(const FacetSpoke& spoke, std::uint32_t point, const FlowTriangle& entry);
  CellExit at_midpoint(const CellSide& side, const FlowTriangle& entry);
  /// Among the spokes of the ring, that may be met where `may_be` says so.
  CellExit exact_exit(const CellSide& side, std::uint32_t point, bool is_forward);
  CellExit vertex_exit(const std::vector<FacetSpoke>& ring, const std::vector<bool>& is_met) const;

  const FlowCells& flow_;
  std::span<const TriangulationCell> cells_;
  std::span<const Point3> points_;
  CrossingChain chain_;
  CrossingFilters filters_;
  std::size_t undecided_ = 0;
};

}  // namespace quoin
