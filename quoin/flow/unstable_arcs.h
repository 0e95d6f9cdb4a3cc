// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_orbit.h"

namespace quoin {

/// One of the two ways from a critical point of index 2.
struct UnstableArc {
  bool is_infinite = false;
  DeloneFace end{};  ///< whose centre it ends in, otherwise
  std::size_t segments = 0;
  std::size_t longest_cascade = 0;  ///< most consecutive constructed points on Voronoi edges
  bool has_passed_regular = false;
};

/// What became of both ways; the first goes to the side of the polygon's first cell.
struct UnstableArcs {
  std::array<UnstableArc, 2> arcs;
};

/// Traces ways from critical points of index 2 to maxima and infinity. Remembers where each Voronoi vertex flows to,
/// so the work for all of them is at most that for all vertices.
class ArcTracer {
 public:
  /// The complex must outlive it. O(n) memory for n cells.
  explicit ArcTracer(const FlowComplex& flow, AtRegularPoint at_regular = AtRegularPoint::pass,
                     FlowNumbers numbers = FlowNumbers::filtered);

  /// Ends are maxima for points in general position; else also other stationary points, `end` says which.
  /// @throws InputError if the polygon is not critical; Cancelled
  UnstableArcs trace(std::uint32_t polygon, const Context& context);
  /// The way of the centre of a cell. @throws Cancelled
  UnstableArc trace_cell(std::uint32_t cell, const Context& context);

  /// How many points were constructed on Voronoi edges, and evaluated exactly.
  std::size_t crossing_count() const { return crossing_count_; }
  std::size_t exact_count() const { return points_.exact_count(); }

 private:
  /// From a Voronoi vertex to the next one, or to the end.
  struct Leg {
    bool is_last = false;
    UnstableArc arc{};  ///< of the leg alone; `end` is the next vertex where it is not the last
  };
  Leg leg(std::uint32_t cell, const Context& context);

  const FlowComplex& flow_;
  AtRegularPoint at_regular_;
  FlowPoints points_;
  std::vector<UnstableArc> known_;
  std::vector<bool> is_known_;
  std::size_t crossing_count_ = 0;
};

}  // namespace quoin
