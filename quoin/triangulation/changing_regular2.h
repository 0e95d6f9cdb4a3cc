// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/changing_points2.h"
#include "quoin/triangulation/changing_triangles2.h"
#include "quoin/triangulation/hidden_lists.h"
#include "quoin/triangulation/id_table.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/triangulation2.h"

namespace quoin {

/// A regular triangulation of the plane to which weighted points are added and from which they are taken away.
///
/// Exact; at any time its triangles are those of Regular2 of the points that are there, ties included, whatever was
/// done before. Points that are hidden stay, and are vertices once what hides them has gone; of points at one place the
/// heaviest counts and hides the others. Each point has an id while it lives, as a vertex or hidden, which is used
/// again after; points of the same place and weight have one. The infinite vertex is 0. Triangles are numbered without
/// gaps, anew with each change. A change that ends with an exception, for want of memory too, leaves points and
/// triangles as they were. One that was moved from may be destroyed or assigned to, and no more.
class ChangingRegular2 {
 public:
  ChangingRegular2();
  /// Vertex v of Regular2 is vertex v + 1 here; hidden points follow. @throws as Regular2
  explicit ChangingRegular2(std::span<const WeightedPoint2> points, const Context& context = Context());

  /// The id of the point: a new one, or that of the same place and weight, once more. Expected O(n^(1/3) + h) for
  /// points spread evenly, of which h were hidden in the triangles that go; O(n) in dimension 1, O(n log n) expected
  /// where the dimension grows.
  /// @throws InputError  a coordinate or the weight is not finite, or there are more than 2^29 points
  /// @throws Cancelled   through `context`, where one is given
  Vertex2 insert(const WeightedPoint2& p);
  Vertex2 insert(const WeightedPoint2& p, const Context& context);
  /// Takes away one of the points with this id; the id goes with the last. Of a hidden one O(1). The star of a vertex
  /// is filled anew (Devillers and Teillaud 2011), and what was hidden in it inserted: expected O(d log d + h log h)
  /// for degree d and h hidden points, all spread evenly, O((d + h)^2) at worst; O(n log n) in dimension 1 and where
  /// all vertices but this lie on a line.
  /// @throws InputError  there is no such point
  /// @throws Cancelled   through `context`, where one is given
  void remove(Vertex2 v);
  void remove(Vertex2 v, const Context& context);
  /// The id of the point of this place and weight; none if it is not there. O(1) expected.
  Vertex2 find(const WeightedPoint2& p) const;

  /// Of the affine hull of the points, which is that of the vertices.
  int dimension() const { return dimension_; }
  /// Finite vertices, which live and are not hidden.
  std::size_t vertex_count() const { return points_.count() - hidden_.count(); }
  /// Ids that are hidden.
  std::size_t hidden_count() const { return hidden_.count(); }
  /// One past the largest id.
  std::size_t id_count() const { return points_.id_count(); }
  bool lives(Vertex2 v) const { return points_.lives(v); }
  /// Of one that lives.
  bool is_hidden(Vertex2 v) const { return hidden_.has(v.value); }
  const WeightedPoint2& point(Vertex2 v) const { return points_.point(v); }
  std::uint32_t multiplicity(Vertex2 v) const { return points_.multiplicity(v); }
  static constexpr Vertex2 infinite_vertex() { return Vertex2(0); }
  /// Corners and neighbours as in Triangulation2, with infinite_vertex() as the infinite corner.
  std::span<const TriangleLinks2> triangles() const { return triangles_.links(); }
  /// Some edge from a vertex that is not hidden; in dimension 2 only.
  Edge2 edge_from(Vertex2 v) const { return triangles_.edge_from(v); }
  /// In dimension 0 and 1 the vertices in lexicographic order.
  std::span<const Vertex2> line() const { return line_; }

 private:
  struct Holder;
  static constexpr std::uint32_t on_line = 0;  ///< holds what is hidden in dimension 0 and 1

  Vertex2 add(const WeightedPoint2& p);
  void forget(Vertex2 v);
  void insert_on_line(Vertex2 v, const Context& context);
  void insert_in_plane(Vertex2 v, const Context& context);
  void remove_from_line(Vertex2 v, const Context& context);
  void remove_from_plane(Vertex2 v, const Context& context);
  void remove_apex(const detail::VertexStar2& star, const std::vector<std::uint32_t>& held, const Context& context);
  void refill(detail::VertexStar2 star, const std::vector<std::uint32_t>& held, const Context& context);
  void build_over_line(std::span<const Vertex2> line, Vertex2 apex, const std::vector<std::uint32_t>& held,
                       const Context& context);
  std::vector<std::uint32_t> held_by(std::span<const std::uint32_t> triangles, const Context& context) const;
  std::vector<std::uint32_t> inside(const detail::TriangleRollback& before, std::span<const std::uint32_t> star,
                                    const Context& context) const;
  std::vector<std::uint32_t> along_curve(const std::vector<std::uint32_t>& ids, const Context& context) const;
  std::vector<Vertex2> revealed_between(std::size_t at, const Context& context) const;
  void hold(std::span<const Holder> holders);
  void drop(std::span<std::uint32_t> holes);
  const Point2& place(Vertex2 v) const { return point(v).point; }
  void set_line(std::vector<Vertex2> line);

  detail::ChangingPoints2<WeightedPoint2> points_;
  IdTable ids_;
  detail::ChangingTriangles2 triangles_;
  HiddenLists hidden_;
  std::vector<Vertex2> line_;
  int dimension_ = -1;
};

}  // namespace quoin
