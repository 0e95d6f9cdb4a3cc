// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/base/id.h"
#include "quoin/base/large_vector.h"

namespace quoin {

/// A vertex of a triangulation of the plane. One id past the finite ones is the infinite vertex, which makes a closed
/// surface of the plane: every edge of the convex hull is in a triangle with it.
using Vertex2 = Id<struct Vertex2Tag>;
using Triangle2 = Id<struct Triangle2Tag>;

/// An edge directed counterclockwise about the triangle on its left: the one opposite corner `slot` of it.
struct Edge2 {
  std::uint32_t code = Vertex2::none_value;  ///< 4 triangle + slot

  constexpr Edge2() = default;
  constexpr explicit Edge2(std::uint32_t value) : code(value) {}
  constexpr Edge2(Triangle2 triangle, unsigned slot) : code(4 * triangle.value + slot) {}
  constexpr bool is_none() const { return code == Vertex2::none_value; }
  constexpr Triangle2 triangle() const { return Triangle2(code / 4); }
  constexpr unsigned slot() const { return code % 4; }
  friend constexpr bool operator==(Edge2, Edge2) = default;
  friend constexpr auto operator<=>(Edge2, Edge2) = default;
};

constexpr unsigned next_slot(unsigned slot) {
  return slot == 2 ? 0 : slot + 1;
}
constexpr unsigned previous_slot(unsigned slot) {
  return slot == 0 ? 2 : slot - 1;
}

/// Three corners, counterclockwise, and across from each the same edge as seen from the neighbour. 24 bytes.
struct TriangleLinks2 {
  std::array<std::uint32_t, 3> corner;
  std::array<std::uint32_t, 3> across;  ///< codes of Edge2
};

using TriangleArray2 = UnsetVector<TriangleLinks2>;

/// Edges have codes of 32 bits, four for each triangle, and there are two triangles for each vertex.
/// @throws InputError  for more than 2^29 vertices
void require_edge_codes(std::size_t vertices);

namespace detail {

/// The last triangle takes a place in which there is none that others are linked with.
inline void close_hole(TriangleArray2& triangles, std::uint32_t hole) {
  const auto last = static_cast<std::uint32_t>(triangles.size() - 1);
  if (hole != last) {
    triangles[hole] = triangles[last];
    for (unsigned slot = 0; slot < 3; ++slot) {
      const std::uint32_t other = triangles[hole].across[slot];
      triangles[other / 4].across[other % 4] = 4 * hole + slot;
    }
  }
  triangles.pop_back();
}

}  // namespace detail

/// The links of a triangulation of the plane, without coordinates: triangles 0 ... triangle_count() - 1, infinite ones
/// among them. All members are O(1) unless they say otherwise.
class Triangulation2 {
 public:
  Triangulation2() = default;
  Triangulation2(TriangleArray2 triangles, std::size_t vertex_count, const Context& context = Context({.threads = 1}));

  /// Finite vertices.
  std::size_t vertex_count() const { return vertex_count_; }
  /// Finite and infinite triangles: 2 (vertex_count() - 1) where there are any.
  std::size_t triangle_count() const { return triangles_.size(); }
  /// One pass over the triangles.
  std::size_t finite_triangle_count() const;
  Vertex2 infinite_vertex() const { return Vertex2(vertex_count_); }
  std::span<const TriangleLinks2> links() const { return triangles_; }

  Vertex2 corner(Triangle2 t, unsigned slot) const { return Vertex2(triangles_[t.index()].corner[slot]); }
  std::array<Vertex2, 3> corners(Triangle2 t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }
  bool is_infinite(Vertex2 v) const { return v.index() == vertex_count_; }
  bool is_infinite(Triangle2 t) const {
    const auto& corner = triangles_[t.index()].corner;
    return corner[0] == vertex_count_ || corner[1] == vertex_count_ || corner[2] == vertex_count_;
  }

  Vertex2 source(Edge2 e) const { return corner(e.triangle(), next_slot(e.slot())); }
  Vertex2 target(Edge2 e) const { return corner(e.triangle(), previous_slot(e.slot())); }
  /// The corner across from the edge, on its left.
  Vertex2 apex(Edge2 e) const { return corner(e.triangle(), e.slot()); }
  /// The same edge from the other side, in the other direction.
  Edge2 twin(Edge2 e) const { return Edge2(triangles_[e.triangle().index()].across[e.slot()]); }
  static Edge2 next(Edge2 e) { return {e.triangle(), next_slot(e.slot())}; }
  static Edge2 previous(Edge2 e) { return {e.triangle(), previous_slot(e.slot())}; }
  /// The next edge counterclockwise with the same source.
  Edge2 around_source(Edge2 e) const { return twin(previous(e)); }
  bool is_infinite(Edge2 e) const { return is_infinite(source(e)) || is_infinite(target(e)); }

  /// Some edge with the vertex as its source, none if it has none.
  Edge2 edge_from(Vertex2 v) const { return Edge2(edge_from_[v.index()]); }
  /// Calls visit(Edge2) for all edges from v, counterclockwise, infinite ones among them. O(degree).
  template <class Visit>
  void for_edges_from(Vertex2 v, const Visit& visit) const {
    const Edge2 first = edge_from(v);
    if (first.is_none()) return;
    Edge2 e = first;
    do {
      visit(e);
      e = around_source(e);
    } while (e != first);
  }

  /// Numbers triangles by their corners, the smallest first in each: a function of the set of triangles alone.
  /// O(n log d) for degrees d, with 8 bytes for each triangle besides.
  void renumber();
  /// What is wrong with the links, or nothing: mutual neighbours with common edges, corners in range, one cycle of
  /// triangles about each vertex, Euler's relation. O(n).
  const char* defect() const;

 private:
  void index_edges(const Context& context);

  TriangleArray2 triangles_;
  LargeVector<std::uint32_t> edge_from_;
  std::size_t vertex_count_ = 0;
};

}  // namespace quoin
