// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/cell_crossing.h"
#include "quoin/flow/compact_counts.h"
#include "quoin/flow/histogram.h"

namespace quoin {

/// Where one of the two ways from a saddle ends.
struct SaddleEnd {
  enum class Kind : std::uint8_t {
    maximum,
    infinity,
    saddle  ///< in another critical point of index 2; not in general position
  };
  Kind kind = Kind::infinity;
  /// That names the maximum; for a saddle, a cell on one side of it, from which its own way goes on.
  std::uint32_t cell = 0;
  bool has_passed_regular = false;
  std::uint32_t segments = 0;
};

/// A part of a way, between Voronoi vertices.
struct ArcLeg {
  std::vector<Point3> points;         ///< constructed ones, as CrossingChain::near_point tells them
  std::optional<std::uint32_t> next;  ///< the Delone cell whose centre it leads to, where it does
};

/// The same with exact points.
struct ExactArcLeg {
  std::vector<RationalPoint3> points;
  std::optional<std::uint32_t> next;
};

/// The ways from saddles to maxima and infinity, for all of them: what ArcTracer tells, in the time of a few
/// triangulations at most. Each Voronoi vertex is advanced once; 6 bytes per simplex, 8 where a way has more than
/// 65,535 segments. Ways go on behind stationary points that are not critical.
class SaddleArcs {
 public:
  /// The cells must outlive it.
  explicit SaddleArcs(const FlowCells& flow);

  /// The first is on the side of the facet's simplex. @throws Cancelled
  std::array<SaddleEnd, 2> ends(CellFacet saddle, const Context& context);
  /// The way of the circumcentre of a simplex; a ghost is at infinity. @throws Cancelled
  SaddleEnd end(std::uint32_t cell, const Context& context);

  /// The way of a Delone cell's centre to the next Voronoi vertex or to the end. Nothing for cells that are on no way
  /// that was asked for, and for those where ways end. @throws Cancelled
  std::optional<ArcLeg> way_on(std::uint32_t first, const Context& context, double part = 0x1p-30);
  /// Points constructed in a row take the more bits the longer it is.
  std::optional<ExactArcLeg> exact_way_on(std::uint32_t first, const Context& context);

  /// Constructed points between consecutive Voronoi vertices, for each vertex from which orbits cross facets.
  const Histogram& cascades() const { return cascades_; }
  const CellCrosser& crosser() const { return crosser_; }

 private:
  /// From a Voronoi vertex to the next one, or to the end.
  struct Leg {
    std::uint32_t next = 0;
    std::uint32_t segments = 0;
  };
  Leg leg(std::uint32_t first, const Context& context);
  /// The leg whose points the chain has then, as `way_on` tells it: calls `visit(node)` for each; false if there is
  /// none.
  template <class Visit>
  bool visit_way(std::uint32_t first, const Context& context, std::optional<std::uint32_t>& next, const Visit& visit);
  void cross(const CellWay& way, Leg& leg, const Context& context);
  std::uint32_t along(CellFacet facet, bool is_above) const;
  void trace(std::uint32_t first, const Context& context);

  const FlowCells& flow_;
  CellCrosser crosser_;
  std::vector<std::uint32_t> end_;
  CompactCounts segments_;
  std::vector<std::pair<std::uint32_t, Leg>> open_;
  std::vector<std::uint32_t> in_saddles_;  ///< cells at saddles in which ways end
  Histogram cascades_;
};

}  // namespace quoin
