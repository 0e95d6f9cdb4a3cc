// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "quoin/kernel/rational_point.h"
#include "quoin/triangulation/delone2.h"

namespace quoin {

/// An edge of the Voronoi diagram: what is as near to one site as to another, and to no other nearer. It runs from
/// `from` to `to` with `left` on its left. An end that is none is at infinity; both are where only two sites count.
struct VoronoiEdge2 {
  Vertex2 left;
  Vertex2 right;
  DeloneCell2 from;
  DeloneCell2 to;
};

/// The Voronoi cell of a site: a convex polygon with these corners counterclockwise, each the centre of a Delone cell.
/// An unbounded one has its corners in order from the first unbounded side to the last, or none.
struct VoronoiCell2 {
  std::vector<DeloneCell2> corners;
  bool is_bounded = false;
};

/// The Voronoi diagram as a view of the Delone complex, without copies: its vertices are the centres of Delone cells,
/// its edges cross their sides, its cells go around their corners. No edge has length zero. Of
/// weighted points the power diagram: near is what has little power |x - p|^2 - weight. Those that are corners of no
/// Delone cell have no cell, as hidden ones have none: they are nearest nowhere alone.
///
/// Dimension 1 has lines between parallel strips, and no vertices. What it is made of must outlive the view.
class Voronoi2 {
 public:
  /// The complex is that of the triangulation, Delaunay or regular.
  Voronoi2(const TriangulationView2& triangulation, const Delone2& delone)
      : triangulation_(triangulation), delone_(&delone) {}

  std::size_t vertex_count() const { return delone_->cell_count(); }
  /// Exact; its coordinates have degrees 3 over 2 in those of the points.
  RationalPoint2 vertex(DeloneCell2 cell) const;
  /// The same, each coordinate rounded to nearest; beyond the largest double infinite.
  Point2 rounded(DeloneCell2 cell) const;
  /// Squared distance to the nearest sites, less their weights, exact.
  Rational squared_radius(DeloneCell2 cell) const;

  /// Whether the site has a cell: without weights all have.
  bool has_cell(Vertex2 site) const { return delone_->is_corner(site); }
  /// O(degree). Without corners and bounded where there is none.
  VoronoiCell2 cell(Vertex2 site) const;
  /// Nothing of an unbounded cell, zero where there is none. Exact, O(degree) rational operations.
  std::optional<Rational> area(Vertex2 site) const;
  /// All of them once each, in the order of the triangles.
  std::vector<VoronoiEdge2> edges() const;

 private:
  Vertex2 end_of_side(Edge2 e) const;

  TriangulationView2 triangulation_;
  const Delone2* delone_;
};

/// The point at the same distance from three points that are not collinear, exact.
RationalPoint2 circumcentre(const Point2& a, const Point2& b, const Point2& c);

/// The point of the same power of three weighted points that are not collinear, exact.
RationalPoint2 power_centre(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c);

}  // namespace quoin
