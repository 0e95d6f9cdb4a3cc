// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/triangulation/triangulation2.h"

namespace quoin::detail {

/// The triangles about a vertex, counterclockwise, and for each the edge from the vertex along which it begins: its
/// target, and the edge across from the vertex as seen from outside.
struct VertexStar2 {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> outer;
};

/// Links of a triangulation of the plane whose vertices come and go, without gaps, and an edge from each vertex.
class ChangingTriangles2 {
 public:
  /// For those who insert and fill; edges from vertices are to follow.
  TriangleArray2& array() { return triangles_; }
  std::span<const TriangleLinks2> links() const { return triangles_; }
  /// Of a vertex that is a corner.
  Edge2 edge_from(Vertex2 v) const { return Edge2(edge_from_[v.index()]); }
  VertexStar2 star(Vertex2 v) const;

  /// Room for edges from that many vertices.
  void reserve_vertices(std::size_t count);
  /// All triangles at once; of vertices for which there is room.
  void assign(TriangleArray2 triangles);
  /// The corners of this triangle have edges of it.
  void update_edges(std::uint32_t triangle);
  /// The last triangle takes the place of this one, with which no other is linked.
  void drop(std::uint32_t triangle);

 private:
  TriangleArray2 triangles_;
  std::vector<std::uint32_t> edge_from_;
};

/// Triangles that are about to be replaced: they come back unless the change is kept, and those at the end of the array
/// that were not there go.
class TriangleRollback {
 public:
  TriangleRollback(TriangleArray2& triangles, std::span<const std::uint32_t> replaced);
  ~TriangleRollback();
  TriangleRollback(const TriangleRollback&) = delete;
  TriangleRollback& operator=(const TriangleRollback&) = delete;

  void keep() { is_kept_ = true; }
  /// Those that are replaced, and as they were.
  std::span<const std::uint32_t> ids() const { return ids_; }
  std::span<const TriangleLinks2> links() const { return links_; }

 private:
  TriangleArray2& triangles_;
  std::size_t count_;
  std::vector<std::uint32_t> ids_;
  std::vector<TriangleLinks2> links_;
  bool is_kept_ = false;
};

}  // namespace quoin::detail
