// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delone.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

/// Of four points that are not coplanar: the point at the same distance from all. Exact.
RationalPoint3 circumcentre(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Of four points that are not coplanar, with weights: the point of the same power |x - p|^2 - weight of all, the
/// centre of the sphere orthogonal to theirs. Exact.
RationalPoint3 power_centre(const std::array<Point3, 4>& points, const std::array<double, 4>& weights);

/// A facet of the Voronoi diagram: the points that are nearest to both ends of a Delone edge.
struct VoronoiFacet {
  std::uint32_t neighbour = 0;  ///< the other vertex
  bool is_bounded = true;
  /// Corners in order around the edge, counterclockwise seen from the neighbour; consecutive ones differ, and so do
  /// the ends. Of an unbounded facet those between its two rays, in the same order. Of points of a plane or line those
  /// of the facet's section with it: of the edge, ray or point from which the facet goes off at right angles.
  std::vector<RationalPoint3> corners;
  std::vector<std::uint32_t> cells{};  ///< for each corner a cell of the triangulation with this centre
};

/// Voronoi diagrams as views of a triangulation, exact, without copies: a corner is the circumcentre of a Delone cell.
/// Of a regular triangulation power diagrams: a corner is a power centre, and nearest is what has the least power. The
/// triangulation must outlive it.
///
/// Weighted points may have no cell: hidden ones, and those that are corners of no Delone cell, which are nearest
/// nowhere alone. These have no facets and no volume, and are nobody's neighbours.
///
/// Where all points lie in a plane, on a line or in one place, of dimension d < 3, all cells and facets are infinite:
/// each is its section with the plane, line or place times all 3 - d directions across. The sections are the diagram of
/// d dimensions, and `corner` and the corners of facets are theirs: of dimension 2 a facet is a strip between the lines
/// across its two corners, or what is beyond that of one, and in order counterclockwise about the vertex as triangles
/// are; of dimension 1 the plane across its one corner. Of dimension 0 all space is one cell.
class Voronoi3 {
 public:
  explicit Voronoi3(const Delaunay3& triangulation) : Voronoi3(triangulation, nullptr) {}
  /// The labels are of this triangulation, and must outlive this, too.
  Voronoi3(const Regular3& triangulation, const DeloneLabels& labels) : Voronoi3(triangulation, &labels) {}

  /// Of all points, from 0 to 3.
  int dimension() const { return triangulation_.dimension(); }

  /// Computes all corners at once and keeps them, about 4 kB per point: for those who ask for most facets, which share
  /// their corners. @throws Cancelled
  void keep_corners(const Context& context);

  /// Whether the vertex has a cell: without weights all have.
  bool has_cell(std::uint32_t vertex) const { return labels_ == nullptr || labels_->is_corner(vertex); }

  /// Centre of a finite cell of the triangulation, in the plane or on the line of all points.
  RationalPoint3 corner(std::size_t cell) const;

  /// The facets of the cell of a vertex that have an area or are unbounded, by ascending neighbours. An edge of the
  /// triangulation that is a diagonal of a Delone facet or cell has none.
  std::vector<VoronoiFacet> facets(std::uint32_t vertex) const;

  /// Of the points nearest to the vertex; nothing where that is infinite: for vertices of the hull, and of a dimension
  /// below 3 for all. Zero without a cell.
  std::optional<Rational> volume(std::uint32_t vertex) const;
  /// The same from the facets of a vertex, all bounded, in other ways and in several times the time: the sum of the
  /// cones over them, whose areas are those of projections along an axis.
  Rational volume(std::uint32_t vertex, std::span<const VoronoiFacet> facets) const;
  /// Of the cell's section with the plane or line of all points, of dimension 1 or 2, the square of its length or area,
  /// as these need not be rational; nothing where they are infinite. One of dimension 0, zero without a cell.
  /// @throws InputError of dimension 3
  std::optional<Rational> squared_section(std::uint32_t vertex) const;
  /// Whether the cell is infinite: that of a vertex of the hull, and of a dimension below 3 all.
  bool is_unbounded(std::uint32_t vertex) const {
    return has_cell(vertex) && (dimension() < 3 || stars_.is_on_hull(vertex));
  }

 private:
  Voronoi3(const TriangulationView3& triangulation, const DeloneLabels* labels)
      : triangulation_(triangulation), stars_(triangulation), labels_(labels) {}
  std::uint32_t end_of_edge(std::uint32_t vertex, std::uint32_t neighbour) const;
  VoronoiFacet facet(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;
  std::vector<VoronoiFacet> facets_across_plane(std::uint32_t vertex) const;
  std::vector<VoronoiFacet> facets_across_line(std::uint32_t vertex) const;
  std::vector<VoronoiFacet> facets_in_space(std::uint32_t vertex) const;
  bool is_ray(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;

  TriangulationView3 triangulation_;
  VertexStars stars_;
  const DeloneLabels* labels_;           ///< of weighted points
  std::vector<RationalPoint3> corners_;  ///< by cell, if they are kept
};

}  // namespace quoin
