// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/mesh.h"
#include "quoin/solid/topology_counts.h"

namespace quoin {

/// The numbers that a file format holds.
enum class Precision { binary64, binary32 };

struct ExitOptions {
  Precision precision = Precision::binary64;
  unsigned max_rounds = 8;       ///< of snap rounding, when plain rounding makes faces cross
  std::size_t max_listed = 100;  ///< crossing pairs listed
  bool keep_polygons = false;    ///< find the faces that may stand as polygons
};

/// How a triangulated boundary relates to the exact one; the later, the worse.
enum class Rounding {
  exact,      ///< no vertex moved
  certified,  ///< vertices moved; an exact check found that no two triangles meet outside their shared vertices and
              ///< edges, and that material is on the same sides; after rounds of snapping the topology is the same,
              ///< except that the boundary may touch itself where it did not, or no longer
  changed,    ///< the same, but components, shells, voids or handles vanished, fused or fell apart
  failed      ///< vertices moved, and some triangles cross (the pairs are listed) or have material on the wrong side
};

/// Faces of more than three corners that may stand for their triangles: one loop that passes no vertex twice, planar
/// over the rounded vertices, exactly.
struct FacePolygons {
  std::vector<std::uint32_t>
      first_triangle;                   ///< ascending; a polygon of n corners covers n - 2 triangles from there on
  std::vector<std::uint32_t> begin{0};  ///< one more than polygons, offsets into corners
  std::vector<std::uint32_t> corners;   ///< vertices, counterclockwise seen from outside
};

/// A boundary as triangles over doubles.
struct Triangulated {
  std::vector<Point3> vertices;
  std::vector<Tile> triangles;               ///< counterclockwise seen from outside
  std::vector<std::uint32_t> triangle_face;  ///< face of the Brep; after snap rounding the face it stems from
  FacePolygons polygons;                     ///< only with `keep_polygons`, and not where rounding failed
  Rounding rounding = Rounding::exact;
  double max_displacement = 0;  ///< largest move of a coordinate, over all rounds; an upper bound
  std::size_t moved_vertices = 0;
  unsigned rounds = 0;                   ///< of snap rounding that were needed
  std::vector<TilePair> crossings;       ///< of triangles, only when rounding failed
  std::shared_ptr<const Brep> resolved;  ///< after snap rounding, the boundary whose faces the triangles make up; its
                                         ///< origins are triangles of the last round
  Topology topology_before;              ///< after snap rounding that did not fail, of the exact boundary
  Topology topology_after;               ///< and of the resolved one
};

/// Leaves for doubles, certified.
///
/// Vertices are rounded to nearest, then each face is triangulated in the projection of its rounded outline; an exact
/// check looks at every pair of triangles of which one has moved, and at the side on which each shell has its material.
/// Where triangles cross, the vertices around the crossing are snapped to a uniform grid of 24 bits and the boundary of
/// positive winding is taken anew, until no crossing is left (iterated snap rounding: Milenkovic and Sacks 2018, Valque
/// and Lazard 2025). What is thinner than the spacing of the numbers may vanish or fuse in that: the topology is
/// compared. O(n log n) for n vertices and a bounded number of rounds.
/// @throws InputError  a coordinate exceeds the range of the precision
/// @throws Cancelled
Triangulated triangulate_boundary(const Brep& boundary, const ExitOptions& options, const Context& context);

}  // namespace quoin
