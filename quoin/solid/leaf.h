// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/mesh.h"

namespace quoin {

struct Brep;

/// One finding about a mesh, with the elements it concerns (at most `max_listed` of them; `count` is the full number).
template <class Element>
struct Finding {
  std::size_t count = 0;
  std::vector<Element> elements;
};

/// A directed edge of a mesh by its vertex indices.
struct MeshEdge {
  std::uint32_t from;
  std::uint32_t to;
  friend auto operator<=>(const MeshEdge&, const MeshEdge&) = default;
};

/// Two faces of a mesh.
struct FacePair {
  std::uint32_t a;
  std::uint32_t b;
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

/// What stands between a mesh and a solid; faces, vertices and edges by their indices in the mesh.
struct MeshDiagnosis {
  Finding<std::uint32_t> not_finite;        ///< vertices with NaN or infinity (refused)
  Finding<std::uint32_t> degenerate_faces;  ///< fewer than three distinct vertices, or all on one line
  Finding<std::uint32_t> not_planar_faces;  ///< polygons that were triangulated because their vertices are not coplanar
  Finding<std::uint32_t> not_simple_faces;  ///< polygons that cross or touch themselves
  Finding<FacePair> duplicate_faces;        ///< same vertices, same orientation
  Finding<MeshEdge> open_edges;             ///< used more often in one direction than in the other
  Finding<MeshEdge> misoriented_edges;      ///< used twice in one direction and never in the other
  Finding<std::vector<std::uint32_t>>
      one_sided_bands;  ///< of each component that no orientation fits, a cycle of faces that turns over (Moebius band)
  Finding<std::uint32_t> isolated_vertices;  ///< corners of no face (meshes only)
  Finding<MeshEdge> nonmanifold_edges;       ///< balanced, with more than two faces (legal)
  Finding<FacePair> crossing_faces;          ///< meet outside their shared vertices and edges
  Finding<std::uint32_t>
      inverted_components;  ///< a face of each connected component whose winding is not that of a solid

  bool is_closed() const { return open_edges.count == 0 && misoriented_edges.count == 0; }
};

/// A closed triangle mesh ready to be an operand: immutable, shared by all solids made from it.
///
/// Tiles are triangles with nonzero area; several tiles may stem from one mesh face (polygons are triangulated
/// exactly).
struct Leaf {
  std::vector<Point3> vertices;
  std::vector<RationalPoint3> exact_vertices;  ///< empty, or the points whose nearest doubles `vertices` are
  std::vector<Tile> tiles;
  std::vector<std::uint32_t> tile_face;  ///< face of the mesh it stems from
  /// Halfedge 3t+k runs from tiles[t][k] to tiles[t][(k+1)%3]. Its opposite one where exactly two tiles meet with
  /// opposite directions, else `no_twin`.
  std::vector<std::uint32_t> twins;
  bool has_all_twins = false;      ///< every edge is used once in each direction
  std::vector<std::uint8_t> flat;  ///< per halfedge, 1: has a twin, and both tiles lie in one plane with one normal
  BoxTree tree;
  bool crosses_itself = false;     ///< tiles meet outside shared vertices and edges (or that could not be excluded)
  std::vector<Color> face_colors;  ///< empty, or per mesh face
  std::string name;

  static constexpr std::uint32_t no_twin = 0xFFFFFFFFU;

  RationalPoint3 exact(std::uint32_t vertex) const {
    return exact_vertices.empty() ? exact_point(vertices[vertex]) : exact_vertices[vertex];
  }
};

struct LeafOptions {
  std::size_t max_listed = 100;  ///< elements listed per finding
  bool find_crossings = true;    ///< settle `crosses_itself`; otherwise it is taken as true
};

/// A leaf, or why there is none.
struct LeafResult {
  std::shared_ptr<const Leaf> leaf;  ///< null when the mesh is not closed, or a vertex is not finite
  MeshDiagnosis diagnosis;
};

/// Turns a mesh into an operand and says everything that is wrong with it.
///
/// Vertices are not welded (readers do that by exact equality). Exact; degenerate faces are dropped, and where one
/// leaves a vertex on a longer edge of its neighbour (a sliver of zero area), the neighbour's edge is split there, so
/// that the rest stays closed. O(n log n). @throws Cancelled through `context`.
LeafResult make_leaf(const Mesh& mesh, const LeafOptions& options, const Context& context);

/// The same of a mesh over rational points, of which its vertices are the nearest doubles.
LeafResult make_leaf(const Mesh& mesh, std::vector<RationalPoint3> exact_vertices, const LeafOptions& options,
                     const Context& context);

/// The same of an exact boundary, over rational points: faces are triangulated exactly, and indices in the diagnosis
/// are those of the boundary's faces and points. Of an unbounded set it is the leaf of the complement.
///
/// Equal points become one; tiles keep the edges and vertices that touch a face from one side. There is no leaf either
/// where a face's loops do not bound a polygon in its plane. O(n log n) rational operations at worst.
LeafResult make_leaf(const Brep& boundary, const std::string& name, const LeafOptions& options, const Context& context);

}  // namespace quoin
