// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// The numbers that a file format holds.
enum class Precision { binary64, binary32 };

struct ExitOptions {
  Precision precision = Precision::binary64;
  unsigned max_rounds = 8;       ///< of snap rounding, when plain rounding makes faces cross
  std::size_t max_listed = 100;  ///< crossing pairs listed
};

/// How the coordinates of a triangulated boundary relate to the exact ones.
enum class Rounding {
  exact,      ///< no vertex moved
  certified,  ///< vertices moved, and an exact check found that no two triangles meet outside their shared vertices and
              ///< edges
  failed      ///< vertices moved, and some triangles cross; the pairs are listed
};

/// A boundary as triangles over doubles.
struct Triangulated {
  std::vector<Point3> vertices;
  std::vector<Tile> triangles;               ///< counterclockwise seen from outside
  std::vector<std::uint32_t> triangle_face;  ///< face of the Brep; after snap rounding the face it stems from
  Rounding rounding = Rounding::exact;
  double max_displacement = 0;  ///< largest move of a coordinate, over all rounds; an upper bound
  std::size_t moved_vertices = 0;
  unsigned rounds = 0;              ///< of snap rounding that were needed
  std::vector<TilePair> crossings;  ///< of triangles, only when rounding failed
};

/// Leaves for doubles, certified.
///
/// Vertices are rounded to nearest, then each face is triangulated in the projection of its rounded outline; an exact
/// check looks at every pair of triangles of which one has moved. Where they cross, the vertices around the crossing
/// are snapped to a uniform grid of 24 bits and the boundary of positive winding is taken anew, until no crossing is
/// left (iterated snap rounding: Milenkovic and Sacks 2018, Valque and Lazard 2025). O(n log n) for n vertices and a
/// bounded number of rounds.
/// @throws InputError  a coordinate exceeds the range of the precision
/// @throws Cancelled
Triangulated triangulate_boundary(const Brep& boundary, const ExitOptions& options, const Context& context);

}  // namespace quoin
