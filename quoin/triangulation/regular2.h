// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/regular_predicates2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// The regular triangulation of weighted points of the plane: the projection of the lower hull of (x, y, x^2 + y^2 -
/// weight), dual to their power diagram. With equal weights it is that of Delaunay2.
///
/// Exact for all finite doubles. Points above the hull are hidden: they are no vertices. Where points are equal the
/// heaviest counts and hides the others; equal ones of equal weight are one vertex. Where more than three lifted points
/// lie in a plane below which there are none, the result is as if they were lifted a little more the lexicographically
/// larger they are: a function of the set of points.
class Regular2 {
 public:
  /// O(n log n) expected; exact arithmetic beyond a filter is by rationals (microseconds for each call). On all threads
  /// from some ten thousand points on, with the same bytes as on one.
  /// @throws InputError  a coordinate or weight is not finite (the first point is named), or there are more than 2^29
  /// @throws Cancelled
  explicit Regular2(std::span<const WeightedPoint2> points, const Context& context = Context());

  /// Of the affine hull of the vertices: -1 of no points, 0, 1 or 2. There are triangles in dimension 2 only.
  int dimension() const { return dimension_; }
  const Triangulation2& links() const { return links_; }
  /// Points that are not hidden, without equal ones.
  std::size_t vertex_count() const { return vertices_.size(); }
  const WeightedPoint2& point(Vertex2 v) const { return vertices_[v.index()]; }
  /// Of all vertices.
  std::span<const WeightedPoint2> points() const { return vertices_; }
  /// Which of the given points lie at a vertex with its weight, ascending.
  std::span<const std::uint32_t> inputs(Vertex2 v) const {
    return std::span(inputs_).subspan(input_begin_[v.index()], input_begin_[v.index() + 1] - input_begin_[v.index()]);
  }
  /// Given points that are no vertices, ascending.
  std::span<const std::uint32_t> hidden() const { return hidden_; }
  /// In dimension 0 and 1 all vertices in lexicographic order; empty in dimension 2.
  std::span<const Vertex2> line() const { return line_; }

 private:
  std::vector<WeightedPoint2> vertices_;
  std::vector<std::uint32_t> inputs_;
  std::vector<std::uint32_t> input_begin_;
  std::vector<std::uint32_t> hidden_;
  std::vector<Vertex2> line_;
  Triangulation2 links_;
  int dimension_ = -1;
};

}  // namespace quoin
