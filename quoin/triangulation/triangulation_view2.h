// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/regular2.h"

namespace quoin {

/// What a Delaunay triangulation of the plane and a regular one have in common, for what is read from either: links,
/// points and weights, which are zero of points that have none. The triangulation must outlive it and not move.
class TriangulationView2 {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): either is meant wherever the view is asked for.
  TriangulationView2(const Delaunay2& t)
      : links_(&t.links()), points_(t.points()), line_(t.line()), dimension_(t.dimension()) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  TriangulationView2(const Regular2& t)
      : links_(&t.links()), weighted_(t.points()), line_(t.line()), dimension_(t.dimension()) {}

  int dimension() const { return dimension_; }
  const Triangulation2& links() const { return *links_; }
  std::size_t vertex_count() const { return links_->vertex_count(); }
  std::span<const Vertex2> line() const { return line_; }
  const Point2& point(Vertex2 v) const { return points_.empty() ? weighted_[v.index()].point : points_[v.index()]; }
  bool is_weighted() const { return points_.empty(); }
  double weight(Vertex2 v) const { return points_.empty() ? weighted_[v.index()].weight : 0; }

 private:
  const Triangulation2* links_;
  std::span<const Point2> points_;  ///< never empty without weights: infinity is one
  std::span<const WeightedPoint2> weighted_;
  std::span<const Vertex2> line_;
  int dimension_;
};

}  // namespace quoin
