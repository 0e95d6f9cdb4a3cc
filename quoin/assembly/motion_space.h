// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/assembly/blocking_graph.h"
#include "quoin/assembly/pair_regions.h"
#include "quoin/base/context.h"

namespace quoin {

/// A cell of a motion space. Edges that the identification or a pole alone cuts are one cell, named by one of them.
struct MotionCell {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::face;
  std::uint32_t id = 0;
  friend bool operator==(const MotionCell&, const MotionCell&) = default;
};

/// Numbers of cells, cuts not counted.
struct MotionCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
};

/// All directions of motion, divided into cells with one blocking graph each: the overlay of the regions of all pairs.
///
/// No cell stores a graph: what changes from cell to cell is what the curves and vertices of the overlay say, and a
/// walk keeps one graph up to date.
class MotionSpace {
 public:
  using Arcs = std::vector<std::array<std::uint32_t, 2>>;

  /// One sweep, each region drawn once whatever the number of its pairs; `fixed` are arcs of all graphs besides.
  /// O((n + k) log n) for n arcs and k crossings. The groups must outlive it. @throws Cancelled
  MotionSpace(std::size_t part_count, std::span<const RegionGroup> groups, const Context& context, Arcs fixed = {});

  const GeodesicArrangement& arrangement() const { return arrangement_; }
  MotionCounts counts() const;
  /// Whether nothing happens at the vertex: a cut of an edge.
  bool is_cut(dcel::VertexId v) const { return is_cut_[v.index()]; }
  /// The edge that names the cell.
  dcel::EdgeId cell_of(dcel::EdgeId e) const { return dcel::EdgeId(std::size_t{edge_cell_[e.index()]}); }

  using Visit = std::function<void(MotionCell, const BlockingGraph&)>;
  /// Calls `visit` once for each cell, with its graph: from face to face across edges, at each face also for the edges
  /// and vertices of its boundary not seen before. The graph is never built anew: O(changes) besides the visits.
  /// @throws Cancelled
  void walk(const Visit& visit, const Context& context) const;

  /// A direction in the cell, primitive. Of a vertex the vertex; else some direction inside, of small numbers where
  /// that is easy. O(boundary of the cell).
  SphereDirection direction_in(MotionCell cell) const;

 private:
  friend class MotionWalk;
  /// An arc of a region.
  struct Source {
    std::uint32_t group;
    std::uint32_t arc;
  };
  /// A vertex of a region at a vertex of the overlay.
  struct Coincidence {
    std::uint32_t vertex;
    std::uint32_t group;
    bool is_blocked;
  };

  void draw(const Context& context);
  void find_cuts();
  SphereDirection direction_in_edge(dcel::EdgeId e) const;
  SphereDirection direction_in_face(dcel::FaceId f) const;

  std::size_t part_count_;
  std::span<const RegionGroup> groups_;
  Arcs fixed_;
  GeodesicArrangement arrangement_;
  std::vector<Source> sources_;                   // by curve
  std::vector<Coincidence> coincidences_;         // sorted by vertex and group
  std::vector<std::uint32_t> first_coincidence_;  // by vertex
  std::vector<bool> is_cut_;
  std::vector<std::uint32_t> edge_cell_;
};

}  // namespace quoin
