// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/flow/crossing_chain.h"
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

  /// How many pairs of fractions were compared, and how many crossings doubles left undecided.
  std::size_t comparison_count() const { return comparisons_; }
  std::size_t undecided_count() const { return undecided_; }

 private:
  /// A triangle around the edge, by the vertex that is off the edge.
  struct Spoke {
    CellFacet facet;
    bool is_above;
    std::uint32_t vertex;
    unsigned corner;  ///< slot of the vertex
    bool is_joined;   ///< a simplex is between this and the next one
  };
  template <class Visit>
  void for_each_spoke(const CellSide& side, const Visit& visit) const;
  bool is_wide(const Spoke& spoke, bool is_right) const;

  CellExit exit(const Spoke& spoke, std::uint32_t point, const FlowTriangle& entry);
  CellExit at_midpoint(const CellSide& side, const FlowTriangle& entry);
  /// Among the spokes of the ring, that may be met where `may_be` says so.
  CellExit exact_exit(const CellSide& side, std::uint32_t point, bool is_forward);
  CellExit vertex_exit(const std::vector<Spoke>& ring, const std::vector<bool>& is_met) const;

  const FlowCells& flow_;
  std::span<const TriangulationCell> cells_;
  std::span<const Point3> points_;
  CrossingChain chain_;
  std::size_t comparisons_ = 0;
  std::size_t undecided_ = 0;
};

}  // namespace quoin
