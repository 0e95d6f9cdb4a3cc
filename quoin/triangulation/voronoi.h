// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delaunay3.h"

namespace quoin {

/// Of four points that are not coplanar: the point at the same distance from all. Exact.
RationalPoint3 circumcentre(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// A facet of the Voronoi diagram: the points that are nearest to both ends of a Delaunay edge.
struct VoronoiFacet {
  std::uint32_t neighbour = 0;  ///< the other vertex
  bool is_bounded = true;
  /// Corners in order around the edge, counterclockwise seen from the neighbour; consecutive ones differ, and so do
  /// the ends. Of an unbounded facet those between its two rays, in the same order.
  std::vector<RationalPoint3> corners;
  std::vector<std::uint32_t> cells{};  ///< for each corner a cell of the triangulation with this circumcentre
};

/// Voronoi diagrams as views of a triangulation of dimension 3, exact, without copies: a corner is the circumcentre of
/// a Delone cell. The triangulation must outlive it.
class Voronoi3 {
 public:
  /// @throws InputError of a lower dimension
  explicit Voronoi3(const Delaunay3& triangulation);

  /// Computes all corners at once and keeps them, about 4 kB per point: for those who ask for most facets, which share
  /// their corners. @throws Cancelled
  void keep_corners(const Context& context);

  /// Circumcentre of a finite cell of the triangulation.
  RationalPoint3 corner(std::size_t cell) const;

  /// The facets of the cell of a vertex that have an area or are unbounded, by ascending neighbours. An edge of the
  /// triangulation that is a diagonal of a Delone facet or cell has none.
  std::vector<VoronoiFacet> facets(std::uint32_t vertex) const;

  /// Of the points nearest to the vertex; nothing where that is infinite, for vertices of the hull.
  std::optional<Rational> volume(std::uint32_t vertex) const;
  /// The same from the facets of a vertex, all bounded, in other ways and in several times the time: the sum of the
  /// cones over them, whose areas are those of projections along an axis.
  Rational volume(std::uint32_t vertex, std::span<const VoronoiFacet> facets) const;
  /// Whether the cell is infinite: that of a vertex of the hull.
  bool is_unbounded(std::uint32_t vertex) const { return stars_.is_on_hull(vertex); }

 private:
  VoronoiFacet facet(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;
  bool is_ray(std::uint32_t vertex, std::uint32_t neighbour, std::uint32_t cell) const;

  const Delaunay3& triangulation_;
  VertexStars stars_;
  std::vector<RationalPoint3> corners_;  ///< by cell, if they are kept
};

}  // namespace quoin
