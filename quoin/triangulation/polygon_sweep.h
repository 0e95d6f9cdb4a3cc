// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "quoin/base/sign.h"
#include "quoin/triangulation/polygon.h"
#include "quoin/triangulation/polygon_points.h"

namespace quoin {

/// Triangulates one polygon in a sweep from left to right (Hertel and Mehlhorn 1983).
///
/// Between a lower and an upper edge lies a gap, an open part of the interior, bounded on the left by a chain of
/// vertices that nowhere bends towards the part still to come. Each vertex is joined to the chain vertices that it
/// sees, which cuts off triangles. Any number of edges may end and begin at a vertex, so touching loops are ordinary.
/// Vertices are named by their rank in sweep order. Edges are checked for crossings when they become neighbours (Shamos
/// and Hoey 1976). A slit is one edge with the interior on both sides; a vertex without edges splits a gap and mends
/// it. `Points` knows the geometry: `PlainPoints` or `ProjectedPoints`.
template <class Points>
class PolygonSweep {
 public:
  PolygonSweep(const Points& points, std::span<const std::uint32_t> loop_points,
               std::span<const std::uint32_t> loop_begin, std::vector<PolygonTriangle>& triangles)
      : points_(points),
        loop_points_(loop_points),
        loop_begin_(loop_begin),
        triangles_(triangles),
        status_(Below{this}) {}

  /// False when the loops do not bound a polygon; triangles appended by then are for the caller to remove.
  bool run();

 private:
  struct Edge {
    std::uint32_t left;
    std::uint32_t right;
    bool inside_above;
    bool inside_below;
  };
  // The interior above an edge, up to the next: its chain from bottom to top, and the link of the vertex met last.
  struct Gap {
    std::uint32_t bottom;
    std::uint32_t top;
    std::uint32_t recent;
  };
  struct Link {
    std::uint32_t vertex;
    std::uint32_t below;
    std::uint32_t above;
  };
  struct Probe {
    std::uint32_t vertex;
  };
  // Edges through or ending at a probed vertex are equivalent to it.
  struct Below {
    using is_transparent = void;
    const PolygonSweep* sweep;
    bool operator()(std::uint32_t e, std::uint32_t f) const { return sweep->is_below(e, f); }
    bool operator()(std::uint32_t e, Probe p) const { return sweep->side(e, p.vertex) == Sign::positive; }
    bool operator()(Probe p, std::uint32_t e) const { return sweep->side(e, p.vertex) == Sign::negative; }
  };
  using Status = std::set<std::uint32_t, Below>;

  bool sort_vertices();
  bool make_edges();
  bool join_slits();
  bool visit(std::uint32_t vertex, std::span<std::uint32_t> starting);
  bool close_gaps(std::uint32_t vertex, typename Status::iterator first, typename Status::iterator end);
  bool insert_edges(std::span<const std::uint32_t> starting, typename Status::iterator above);
  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  Sign side(std::uint32_t edge, std::uint32_t vertex) const;
  bool is_below(std::uint32_t e, std::uint32_t f) const;
  bool are_apart(std::uint32_t lower, std::uint32_t upper) const;

  std::uint32_t new_link(std::uint32_t vertex);
  Gap fresh_gap(std::uint32_t vertex);
  void add_at_top(Gap& gap, std::uint32_t vertex);
  void add_at_bottom(Gap& gap, std::uint32_t vertex);
  std::pair<Gap, Gap> split(const Gap& gap, std::uint32_t vertex);
  Gap merge(const Gap& lower, const Gap& upper);
  bool close(const Gap& gap, std::uint32_t vertex);
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  Points points_;
  std::span<const std::uint32_t> loop_points_;
  std::span<const std::uint32_t> loop_begin_;
  std::vector<PolygonTriangle>& triangles_;
  Status status_;
  std::vector<std::uint32_t> vertices_;  // by rank
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> by_left_;  // edges by left end
  std::vector<std::uint32_t> ending_;   // per vertex: how many edges end there
  std::vector<Gap> gaps_;               // per edge with the interior above it
  std::vector<Link> links_;
};

extern template class PolygonSweep<PlainPoints>;
extern template class PolygonSweep<ProjectedPoints>;

}  // namespace quoin
