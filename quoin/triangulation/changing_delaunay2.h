// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
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
  std::size_t vertex_count() const { return count_; }
  /// One past the largest id.
  std::size_t id_count() const { return points_.size(); }
  bool lives(Vertex2 v) const { return v.index() < multiplicity_.size() && multiplicity_[v.index()] > 0; }
  const Point2& point(Vertex2 v) const { return points_[v.index()]; }
  std::uint32_t multiplicity(Vertex2 v) const { return multiplicity_[v.index()]; }
  static constexpr Vertex2 infinite_vertex() { return Vertex2(0); }
  /// Corners and neighbours as in Triangulation2, with infinite_vertex() as the infinite corner.
  std::span<const TriangleLinks2> triangles() const { return triangles_; }
  /// Some edge from a living vertex; in dimension 2 only.
  Edge2 edge_from(Vertex2 v) const { return Edge2(star_[v.index()]); }
  /// In dimension 0 and 1 the vertices in lexicographic order.
  std::span<const Vertex2> line() const { return line_; }

 private:
  Vertex2 add_vertex(const Point2& p);
  void take_back(Vertex2 v);
  Vertex2 insert_on_line(const Point2& p, const Context& context);
  Vertex2 insert_in_plane(const Point2& p, const Context& context);
  void leave_line(Vertex2 apex, const Context& context);
  void remove_from_plane(Vertex2 v, const Context& context);
  void fall_to_line(Vertex2 gone, const Context& context);
  bool falls_without(std::span<const std::uint32_t> ring, const Context& context) const;
  void fill_star(std::span<const std::uint32_t> ring, const Context& context);
  void drop_triangle(std::uint32_t t);
  void update_star(std::uint32_t t);
  std::uint32_t nearby_triangle(const Point2& p) const;

  LargeVector<Point2> points_;
  std::vector<std::uint32_t> multiplicity_;
  std::vector<std::uint32_t> free_;
  TriangleArray2 triangles_;
  std::vector<std::uint32_t> star_;
  std::vector<Vertex2> line_;
  std::size_t count_ = 0;
  int dimension_ = -1;
};

}  // namespace quoin
