// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/base/context.h"
#include "quoin/polytope/cube_squares.h"
#include "quoin/polytope/map_arcs.h"

namespace quoin {

/// The Gaussian map of a polytope on the surface of a cube: six arrangements of segments in [-1, 1]^2, one for each
/// square (cube_squares.h), by central projection of the directions.
///
/// Cells of the map are *real*: a vertex where a normal of a facet meets the cube, an edge that lies on an arc, which
/// is a chain of up to four segments. What else is there is *artificial*: the sides and corners of the squares, and
/// vertices where arcs pass from one square to another. A vertex of the polytope has up to five faces, as the sides of
/// squares cut its directions.
struct CubicalMap {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  /// A vertex of a square.
  struct Place {
    std::uint32_t square = 0;
    dcel::VertexId vertex;
    friend bool operator==(const Place&, const Place&) = default;
  };

  enum class Location : std::uint8_t { interior, side, corner };

  struct Vertex {
    Location location = Location::interior;
    std::uint32_t facet = none;  ///< of the polytope; none: artificial
    /// The same point of the cube on another square: on a side the two name each other, at a corner the three lead
    /// around clockwise; in the interior the vertex itself.
    Place next;
    bool is_real() const { return facet != none; }
  };

  struct Square {
    LinearArrangement arrangement;
    std::vector<Vertex> vertices;               ///< by vertex of the arrangement, fictitious ones too
    std::vector<std::uint32_t> arc_of_edge;     ///< by edge: index into `arcs`; none: artificial
    std::vector<std::uint32_t> vertex_of_face;  ///< by face: vertex of the polytope; none: the unbounded one, and all
                                                ///< if there are no vertices
    std::array<dcel::VertexId, cube::corner_count> corners;
  };

  /// Numbers of vertices, edges and faces; of faces the unbounded one too.
  struct Counts {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t faces = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
  };

  std::array<Square, cube::square_count> squares;
  std::vector<MapArc> arcs;

  Counts counts(std::size_t square) const;
  /// Of all six squares together: what lies on sides is counted on each square that has it.
  Counts counts() const;
  const Vertex& operator[](const Place& place) const { return squares[place.square].vertices[place.vertex.index()]; }
};

/// Exact, in any position: normals on sides and corners of squares are ordinary, and arcs along sides. O(n log n).
/// Source: Fogel and Halperin 2007.
/// @throws InputError  of a segment; Cancelled
CubicalMap cubical_map(const Polytope& p, const Context& context);
/// Of what the arcs are of: a polytope, or a sum of two. @throws Cancelled
CubicalMap cubical_map(const MapArcs& arcs, const Context& context);

/// The inverse: the polytope that a map is of, from its cells, links and the labels of its faces alone.
///
/// Its facets as rings of vertices (labels), counterclockwise seen from outside, in the order of squares and their
/// vertices, each with its first place. Each ring may begin anywhere. O(n).
std::vector<std::vector<std::uint32_t>> facets_of_map(const CubicalMap& map);

}  // namespace quoin
