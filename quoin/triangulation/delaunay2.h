// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/spatial_order2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

struct Delaunay2Options {
  /// Number triangles by their vertices, so that the bytes of the result are those of the set of triangles, whatever
  /// the order of insertion of this version. Takes as long again for a million points, three times as long for ten, and
  /// 20 bytes per point more for a while.
  bool canonical = false;
};

/// The Delaunay triangulation of points of the plane.
///
/// Exact for all finite doubles, cocircular, collinear and equal points included. Vertices are the distinct points in
/// an order along a curve that depends on their set alone. Where more than three points lie on an empty circle, the
/// triangles inside are those of an infinitesimal lift that coordinates alone determine (delaunay_predicates2.h): the
/// result is a function of the set of points; what should not depend on the choice is read from `Delone2`.
///
/// The links have triangles in dimension 2 only. Copies share nothing. Immutable, so threads may read it.
class Delaunay2 {
 public:
  /// O(n log n) expected, O(n) after sorting for points that are spread evenly; at most 75 bytes per point beyond the
  /// input from about a million on. On all threads from some ten thousand on, with the same bytes as on one.
  /// @throws InputError  a point is not finite (the first is named), or there are more than 2^29
  /// @throws Cancelled   through `context`
  explicit Delaunay2(std::span<const Point2> points, const Delaunay2Options& options = {},
                     const Context& context = Context());

  /// Of the affine hull: -1 of no points, 0, 1 or 2.
  int dimension() const { return dimension_; }
  const Triangulation2& links() const { return links_; }
  std::size_t vertex_count() const { return order_.points.size() - 1; }
  Vertex2 infinite_vertex() const { return Vertex2(vertex_count()); }

  /// Of a finite vertex; zeros are +0. (NaN, NaN) of the infinite one.
  const Point2& point(Vertex2 v) const { return order_.points[v.index()]; }
  /// Of all finite vertices, and (NaN, NaN).
  std::span<const Point2> points() const { return order_.points; }
  /// Which of the given points lie at a finite vertex, ascending; their number is its multiplicity.
  std::span<const std::uint32_t> inputs(Vertex2 v) const { return order_.inputs_of(v.index()); }
  std::size_t input_count() const { return order_.inputs.size(); }
  /// For each of the given points its vertex. O(n).
  std::vector<Vertex2> vertices_of_inputs() const;

  /// In dimension 0 and 1 all vertices in lexicographic order, which is that along the line; neighbours are Delaunay
  /// edges. Empty in dimension 2.
  std::span<const Vertex2> line() const { return line_; }

 private:
  SpatialOrder2 order_;
  Triangulation2 links_;
  std::vector<Vertex2> line_;
  int dimension_ = -1;
};

}  // namespace quoin
