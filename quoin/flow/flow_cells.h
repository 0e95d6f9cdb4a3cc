// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/cell_ring.h"
#include "quoin/flow/cell_signs.h"

namespace quoin {

/// A facet of a simplex, by its slot, or an edge of a facet, opposite to a corner of it.
struct CellFacet {
  std::uint32_t cell = 0;
  unsigned slot = 0;

  std::uint32_t number() const { return cell * 4 + slot; }
  friend bool operator==(const CellFacet&, const CellFacet&) = default;
};
struct CellSide {
  CellFacet facet;
  unsigned corner = 0;  ///< the side is opposite to it
};
/// A polygon by the facet that names it.
struct NamedPolygon {
  CellFacet facet{};
  bool is_same_side = true;  ///< its simplex is on the side of the facet that was asked about
};

/// Where orbits go on from a Voronoi vertex.
struct CellWay {
  enum class Kind : std::uint8_t {
    facet,    ///< along the Voronoi edge of a polygon
    edge,     ///< through the Voronoi facet of an edge
    maximum,  ///< nowhere: a critical point
    regular   ///< nowhere: a stationary point that is not critical
  };
  Kind kind = Kind::maximum;
  std::uint32_t cell = 0;
  unsigned place = 0;  ///< slot of the facet, or number of the edge
};

/// What FlowComplex knows of Delone faces, as a few bytes of each simplex of the triangulation: for surveys of all that
/// flows among millions of points. The same answers; of dimension 3 only. A Delone cell is named by the first of its
/// simplices, a polygon by the least number of a facet of it.
///
/// Exact for all finite doubles. Six bytes per simplex. Source: as FlowComplex.
class FlowCells {
 public:
  /// O(n) for n simplices and Delone cells of bounded size. The triangulation must outlive it.
  /// @throws InputError for points of a plane or line; Cancelled
  FlowCells(const Delaunay3& triangulation, const Context& context);

  const Delaunay3& triangulation() const { return triangulation_; }
  std::span<const TriangulationCell> cells() const { return cells_; }
  bool is_ghost(std::uint32_t cell) const { return (rows_[cell].edges & ghost) != 0; }
  const CellShape& shape(std::uint32_t cell) const { return rows_[cell].shape; }

  /// Critical points by index.
  const std::array<std::size_t, 4>& counts() const { return counts_; }
  const CellSignCounts& undecided() const { return undecided_; }

  /// Whether the edge of this number is critical.
  bool is_critical_edge(std::uint32_t cell, unsigned edge) const { return (rows_[cell].edges >> edge & 1) != 0; }
  /// Whether the facet is the one that names a critical polygon.
  bool is_critical_facet(std::uint32_t cell, unsigned slot) const { return (rows_[cell].bits >> (4 + slot) & 1) != 0; }
  /// Calls `visit(cell, edge)` for each critical edge, from one of its simplices, by ascending simplices.
  template <class Visit>
  void for_each_critical_edge(const Context& context, const Visit& visit) const {
    for (std::uint32_t c = 0; c < rows_.size(); ++c) {
      if (c % 1024 == 0) context.poll();
      for (unsigned e = 0; e < 6 && !is_ghost(c); ++e) {
        if (is_critical_edge(c, e) && is_first_at_edge(c, e)) visit(c, e);
      }
    }
  }
  /// Calls `visit(CellFacet)` for each critical polygon, ascending.
  template <class Visit>
  void for_each_saddle(const Context& context, const Visit& visit) const {
    for (std::uint32_t c = 0; c < rows_.size(); ++c) {
      if (c % 4096 == 0) context.poll();
      for (unsigned bits = rows_[c].bits >> 4, i = 0; bits != 0; bits >>= 1, ++i) {
        if ((bits & 1) != 0) visit(CellFacet{c, i});
      }
    }
  }

  /// The simplex that names the Delone cell of a simplex.
  std::uint32_t first_of(std::uint32_t cell) const;
  /// Where orbits go on from a Delone cell, given by any of its simplices.
  CellWay way(std::uint32_t cell) const;
  /// The facet behind whose polygon an orbit goes on if it passes the stationary point of a cell, as ArcTracer does.
  CellFacet way_past(std::uint32_t cell) const;
  /// The side of a polygon, given by any facet of it, in whose facet orbits go on; a corner equal to the slot if they
  /// stay on the polygon's Voronoi edge.
  CellSide way_of_polygon(CellFacet facet) const;
  /// The facet with the least number of a polygon, given by any facet of it, of all that are not at infinity.
  NamedPolygon named(CellFacet facet) const;
  /// Whether the facet is between two simplices of one Delone cell.
  bool is_inside_cell(CellFacet facet) const { return (inner(facet.cell) >> facet.slot & 1) != 0; }
  /// Whether a stationary orbit on the polygon's own Voronoi edge is at a critical point.
  bool is_critical_polygon(CellFacet facet) const;
  /// Whether the Delone cell has a smaller number than the other, in the order of DeloneComplex; no ghosts.
  bool is_before(std::uint32_t cell, std::uint32_t other) const;

  /// Stationary points that are not critical, in the duals of polygons and of cells, by their numbers. O(n).
  /// @throws Cancelled
  std::vector<CellFacet> regular_polygons(const Context& context) const;
  std::vector<std::uint32_t> regular_cells(const Context& context) const;

  /// Sides of a polygon from which orbits enter its Voronoi edge.
  void entering_sides(CellFacet facet, std::vector<CellSide>& sides) const;
  /// Edges of a Delone cell from which orbits enter its Voronoi vertex, each as the side of one polygon.
  void entering_edges(std::uint32_t cell, std::vector<CellSide>& sides) const;
  bool has_entering_polygon(std::uint32_t cell) const;

  /// All facets of a polygon, on this side of it, from one of them.
  std::vector<CellFacet> polygon(CellFacet facet) const;
  /// Vertices of the Delone cell of a simplex, and of the polygon of a facet, ascending.
  std::vector<std::uint32_t> vertices_of(std::uint32_t cell) const;
  std::vector<std::uint32_t> vertices_of_polygon(CellFacet facet) const;

  /// The same facet seen from the other side.
  CellFacet mate(CellFacet facet) const {
    const std::uint32_t other = cells_[facet.cell].neighbours[facet.slot];
    return {other >> 2, other & 3};
  }

 private:
  static constexpr std::uint8_t ghost = 64;
  struct Row {
    CellShape shape;
    std::uint8_t bits = 0;   ///< slots with cospherical neighbours; from 4 on, facets that name critical polygons
    std::uint8_t edges = 0;  ///< critical ones; and whether it is a ghost
    std::uint8_t way = 0;
  };
  struct Member {
    std::uint32_t cell;
    std::uint32_t first;
  };
  struct ClusterWay {
    std::uint32_t first;
    CellWay way;
  };
  using Ring = std::vector<std::pair<std::uint32_t, std::uint8_t>>;
  bool is_regular_polygon(CellFacet named) const;
  bool is_first_at_edge(std::uint32_t cell, unsigned edge) const;
  unsigned inner(std::uint32_t cell) const { return rows_[cell].bits & 15U; }
  bool is_triangle(CellFacet facet) const;
  CellSide turned_inside(CellSide side) const;
  bool is_inside_polygon(CellSide side) const;
  std::vector<std::uint32_t> cluster(std::uint32_t cell) const;
  std::vector<CellFacet> polygons_of(std::uint32_t cell) const;

  void fetch_neighbours(std::size_t cell) const;
  void find_shapes(const Context& context);
  bool walk_ring(std::uint32_t cell, OtherSlots off, Ring& ring) const;
  void find_critical_edges(const Context& context);
  void find_simple_saddles(std::uint32_t cell);
  void find_polygon_saddles(std::uint32_t cell);
  void find_in_clusters(const Context& context);
  void find_cluster_way(std::uint32_t first);
  std::uint8_t simple_way(const CellShape& shape) const;

  const Delaunay3& triangulation_;
  std::span<const TriangulationCell> cells_;
  DelaunaySigns signs_;
  LargeVector<Row> rows_;
  std::vector<Member> members_;  ///< simplices of larger Delone cells but the first, ascending
  std::vector<ClusterWay> cluster_ways_;
  std::array<std::size_t, 4> counts_{};
  CellSignCounts undecided_;
};

}  // namespace quoin
