// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/triangulation/changing_points2.h"
#include "quoin/triangulation/changing_triangles2.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// A Delaunay triangulation of the plane to which points are added and from which they are taken away.
///
/// Exact; at any time its triangles are those of Delaunay2 of the points that are there, ties included, whatever was
/// done before. Vertex 0 is the infinite one. Ids of vertices stay while they live, and are used again after. Triangles
/// are numbered without gaps, anew with each change. A change that ends with an exception, for want of memory too,
/// leaves points and triangles as they were.
class ChangingDelaunay2 {
 public:
  ChangingDelaunay2();
  /// Vertex v of Delaunay2 is vertex v + 1 here. @throws as Delaunay2
  explicit ChangingDelaunay2(std::span<const Point2> points, const Context& context = Context());

  /// The vertex of the point: a new one, or the one that is there, once more. O(n^(1/3)) expected for points spread
  /// evenly; O(n) in dimension 1 and where the dimension grows.
  /// @throws InputError  the point is not finite, or there are more than 2^29 vertices
  /// @throws Cancelled   through `context`, where one is given
  Vertex2 insert(const Point2& p);
  Vertex2 insert(const Point2& p, const Context& context);
  /// Takes away one of the points at a vertex; the vertex goes with the last. Its star is filled anew (Devillers and
  /// Teillaud 2011): O(d log d) expected for degree d, O(d^2) at worst; O(n) in dimension 1 and where the dimension
  /// falls.
  /// @throws InputError  there is no such vertex
  /// @throws Cancelled   through `context`, where one is given
  void remove(Vertex2 v);
  void remove(Vertex2 v, const Context& context);

  int dimension() const { return dimension_; }
  /// Finite vertices that live.
  std::size_t vertex_count() const { return points_.count(); }
  /// One past the largest id.
  std::size_t id_count() const { return points_.id_count(); }
  bool lives(Vertex2 v) const { return points_.lives(v); }
  const Point2& point(Vertex2 v) const { return points_.point(v); }
  std::uint32_t multiplicity(Vertex2 v) const { return points_.multiplicity(v); }
  static constexpr Vertex2 infinite_vertex() { return Vertex2(0); }
  /// Corners and neighbours as in Triangulation2, with infinite_vertex() as the infinite corner.
  std::span<const TriangleLinks2> triangles() const { return triangles_.links(); }
  /// Some edge from a living vertex; in dimension 2 only.
  Edge2 edge_from(Vertex2 v) const { return triangles_.edge_from(v); }
  /// In dimension 0 and 1 the vertices in lexicographic order.
  std::span<const Vertex2> line() const { return line_; }

 private:
  Vertex2 add_vertex(const Point2& p);
  Vertex2 insert_on_line(const Point2& p, const Context& context);
  Vertex2 insert_in_plane(const Point2& p, const Context& context);
  void leave_line(Vertex2 apex, const Context& context);
  void remove_from_plane(Vertex2 v, const Context& context);
  void fall_to_line(Vertex2 gone, const Context& context);

  detail::ChangingPoints2<Point2> points_;
  detail::ChangingTriangles2 triangles_;
  std::vector<Vertex2> line_;
  int dimension_ = -1;
};

}  // namespace quoin
