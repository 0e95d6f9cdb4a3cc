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
  /// the ends. Of an unbounded facet those between its two rays, in the same order.
  std::vector<RationalPoint3> corners;
  std::vector<std::uint32_t> cells{};  ///< for each corner a cell of the triangulation with this centre
};

/// Voronoi diagrams as views of a triangulation of dimension 3, exact, without copies: a corner is the circumcentre of
/// a Delone cell. Of a regular triangulation power diagrams: a corner is a power centre, and nearest is what has the
/// least power. The triangulation must outlive it.
///
/// Weighted points may have no cell: hidden ones, and those that are corners of no Delone cell, which are nearest
/// nowhere alone. These have no facets and no volume, and are nobody's neighbours.
class Voronoi3 {
 public:
  /// @throws InputError of a lower dimension
  explicit Voronoi3(const Delaunay3& triangulation);
  /// The labels are of this triangulation, and must outlive this, too.
  Voronoi3(const Regular3& triangulation, const DeloneLabels& labels);

  /// Computes all corners at once and keeps them, about 4 kB per point: for those who ask for most facets, which share
  /// their corners. @throws Cancelled
  void keep_corners(const Context& context);

  /// Whether the vertex has a cell: without weights all have.
  bool has_cell(std::uint32_t vertex) const { return labels_ == nullptr || labels_->is_corner(vertex); }

  /// Centre of a finite cell of the triangulation.
  RationalPoint3 corner(std::size_t cell) const;

  /// The facets of the cell of a vertex that have an area or are unbounded, by ascending neighbours. An edge of the
  /// triangulation that is a diagonal of a Delone facet or cell has none.
  std::vector<VoronoiFacet> facets(std::uint32_t vertex) const;

  /// Of the points nearest to the vertex; nothing where that is infinite, for vertices of the hull. Zero without a
  /// cell.
  std::optional<Rational> volume(std::uint32_t vertex) const;
  /// The same from the facets of a vertex, all bounded, in other ways and in several times the time: the sum of the
  /// cones over them, whose areas are those of projections along an axis.
  Rational volume(std::uint32_t vertex, std::span<const VoronoiFacet> facets) const;
  /// Whether the cell is infinite: that of a vertex of the hull.
  bool is_unbounded(std::uint32_t vertex) const { return has_cell(vertex) && stars_.is_on_hull(vertex); }

 private:
  explicit Voronoi3(const TriangulationView3& triangulation, const DeloneLabels* labels);
  std::uint32_t end_of_edge(std::uint32_t vertex, std::uint32_t neighbour) const;
  VoronoiFacet facet(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;
  bool is_ray(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;

  TriangulationView3 triangulation_;
  VertexStars stars_;
  const DeloneLabels* labels_;           ///< of weighted points
  std::vector<RationalPoint3> corners_;  ///< by cell, if they are kept
};

}  // namespace quoin
