// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/id.h"
#include "quoin/base/large_vector.h"

/// The cells of a subdivision of a surface and how they are joined, without any geometry.
namespace quoin::dcel {

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;
using BoundaryId = Id<struct BoundaryTag>;

/// One side of an edge. 2e runs from the lexicographically smaller end of edge e to the larger, 2e + 1 back.
struct HalfedgeId {
  std::uint32_t value = 0xFFFFFFFFU;

  constexpr HalfedgeId() = default;
  constexpr explicit HalfedgeId(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr HalfedgeId(EdgeId edge, bool backwards) : value(2 * edge.value + static_cast<std::uint32_t>(backwards)) {}
  constexpr bool is_none() const { return value == 0xFFFFFFFFU; }
  constexpr std::size_t index() const { return value; }
  constexpr HalfedgeId twin() const { return HalfedgeId(std::size_t{value ^ 1U}); }
  constexpr EdgeId edge() const { return EdgeId(std::size_t{value >> 1}); }
  /// From left to right.
  constexpr bool is_forward() const { return (value & 1U) == 0; }
  friend constexpr bool operator==(HalfedgeId, HalfedgeId) = default;
  friend constexpr auto operator<=>(HalfedgeId, HalfedgeId) = default;
};

/// Whether a cell is part of the answer. Fictitious cells close the plane at infinity, dead ones were removed.
enum class CellState : std::uint8_t { real, fictitious, dead };

struct Halfedge {
  HalfedgeId next;
  HalfedgeId previous;
  VertexId origin;
  BoundaryId boundary;
};

struct Vertex {
  HalfedgeId out;          ///< one of the halfedges that leave it; none if isolated
  FaceId face;             ///< of an isolated vertex: the face around it
  VertexId next_isolated;  ///< next isolated vertex of that face
  CellState state = CellState::real;
};

/// A cycle of halfedges with one face on its left.
struct Boundary {
  HalfedgeId halfedge;  ///< one of its halfedges; none if the boundary is gone
  FaceId face;
  BoundaryId next;        ///< next boundary of the face, of either kind
  bool is_outer = false;  ///< in the plane: the face lies inside; on other surfaces always true
};

struct Face {
  BoundaryId first_boundary;
  VertexId first_isolated;
  bool is_unbounded = false;
  CellState state = CellState::real;
};

/// A doubly connected edge list for subdivisions of any orientable surface: a face lies on the left of its halfedges,
/// and has any number of boundaries, outer ones too (on a sphere there may be several or none), and isolated vertices.
///
/// Halfedges name their boundary, not their face, so that a face changes hands in constant time. After a construction,
/// vertices are numbered in lexicographic order, edges by their smaller end and then from bottom to top; local edits
/// append and leave dead cells behind.
class Dcel {
 public:
  LargeVector<Halfedge> halfedges;
  std::vector<CellState> edges;
  LargeVector<Vertex> vertices;
  std::vector<Boundary> boundaries;
  std::vector<Face> faces;
  /// The face at the lower end of the left side of the parameter rectangle: of the plane, below and left of everything;
  /// of a sphere, at the south pole, just before the identification. It is the same place in every subdivision.
  FaceId base_face;

  const Halfedge& operator[](HalfedgeId h) const { return halfedges[h.index()]; }
  Halfedge& operator[](HalfedgeId h) { return halfedges[h.index()]; }
  const Vertex& operator[](VertexId v) const { return vertices[v.index()]; }
  Vertex& operator[](VertexId v) { return vertices[v.index()]; }
  const Boundary& operator[](BoundaryId b) const { return boundaries[b.index()]; }
  Boundary& operator[](BoundaryId b) { return boundaries[b.index()]; }
  const Face& operator[](FaceId f) const { return faces[f.index()]; }
  Face& operator[](FaceId f) { return faces[f.index()]; }

  HalfedgeId next(HalfedgeId h) const { return (*this)[h].next; }
  HalfedgeId previous(HalfedgeId h) const { return (*this)[h].previous; }
  VertexId origin(HalfedgeId h) const { return (*this)[h].origin; }
  VertexId target(HalfedgeId h) const { return (*this)[h.twin()].origin; }
  FaceId face(HalfedgeId h) const { return (*this)[(*this)[h].boundary].face; }
  /// The next halfedge out of the same vertex, clockwise.
  HalfedgeId clockwise(HalfedgeId out) const { return next(out.twin()); }
  /// The next halfedge out of the same vertex, counterclockwise.
  HalfedgeId counterclockwise(HalfedgeId out) const { return previous(out).twin(); }
  bool is_isolated(VertexId v) const { return (*this)[v].out.is_none(); }
  bool is_real(VertexId v) const { return (*this)[v].state == CellState::real; }
  bool is_real(EdgeId e) const { return edges[e.index()] == CellState::real; }
  bool is_real(FaceId f) const { return (*this)[f].state == CellState::real; }

  std::size_t degree(VertexId v) const;
  /// Makes `to` follow `from` on a boundary.
  void link(HalfedgeId from, HalfedgeId to) {
    (*this)[from].next = to;
    (*this)[to].previous = from;
  }
};

/// Numbers of real cells.
struct Counts {
  std::size_t vertices = 0;  ///< isolated ones too
  std::size_t isolated_vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t unbounded_faces = 0;
  std::size_t boundaries = 0;
  /// Connected pieces of vertices and edges; all curves that reach infinity count as one.
  std::size_t components = 0;
};

/// O(size).
Counts count_cells(const Dcel& dcel);

/// Verifies every link: next and previous, origins, boundaries, lists of faces, states, and Euler's formula
/// V - E + F = 1 + C with the fictitious cells counted in, and that boundaries are F + C - 1 - isolated vertices.
/// @throws InternalError that names the cell
void check_links(const Dcel& dcel);

}  // namespace quoin::dcel
