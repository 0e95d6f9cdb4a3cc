// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// The convex hull of a list of points, by indices into the list. Of equal points it names the first.
///
/// The same points give the same hull, on any number of threads: vertices ascend, every facet begins at its smallest
/// vertex, and facets are in lexicographic order.
struct ConvexHull {
  int dimension = -1;                   ///< of the smallest flat through all points: -1 of no points, then 0, 1, 2 or 3
  std::vector<std::uint32_t> vertices;  ///< points that are in no convex combination of others
  std::vector<std::uint32_t> corners;   ///< of all facets
  std::vector<std::size_t> facet_begin{0};  ///< facet_count() + 1 offsets into corners

  /// Facets are maximal: coplanar ones are one polygon, and no corner lies on the line through its neighbours. Of
  /// dimension 2 there is one facet, the polygon itself; of lower dimensions none.
  std::size_t facet_count() const { return facet_begin.size() - 1; }
  /// Counterclockwise seen from outside; of dimension 2, seen from where the first of x, y, z that its normal is not
  /// perpendicular to increases.
  std::span<const std::uint32_t> facet(std::size_t f) const {
    return {corners.data() + facet_begin[f], facet_begin[f + 1] - facet_begin[f]};
  }
};

/// Exact for all finite doubles, in any position: equal, collinear, coplanar and cospherical points are ordinary.
///
/// Points enter in random rounds, each along a Hilbert curve; a point is located by a walk over the hull, and the
/// facets that it sees are replaced. Expected O(n log n) for any input whose random samples have hulls of linear size,
/// as all do in space; about 190 bytes for each vertex, 40 for each point. Threads share the insertions, each for
/// points on one side of a plane, and the passes over all points and facets; points that meet such a plane enter last.
/// Source: Clarkson and Shor 1989; Amenta, Choi and Rote 2003 (rounds); Edelsbrunner 1990 (why the walk ends).
/// @throws InputError naming a point that is not finite, Cancelled
ConvexHull convex_hull(std::span<const Point3> points, const Context& context);

/// Of points of a table, given or constructed: the same hull as of doubles, by indices into the list. Signs come from
/// the rounded points where their errors allow, else from the table.
/// @throws InputError naming a point that rounds to no finite double, Cancelled
ConvexHull convex_hull(const Constructions& table, std::span<const PointId> points, const Context& context);

/// Of rationals. @throws as that of a table
ConvexHull convex_hull(std::span<const RationalPoint3> points, const Context& context);

/// Of points of the plane: facets are edges for dimension 2, each from its first to its second corner with the hull on
/// the left; they are in counterclockwise order from the lexicographically smallest point.
/// O(n log n). Source: Andrew 1979.
/// @throws InputError naming a point that is not finite, Cancelled
ConvexHull convex_hull(std::span<const Point2> points, const Context& context);

/// Of rationals of the plane. @throws as that of a table
ConvexHull convex_hull(std::span<const RationalPoint2> points, const Context& context);

}  // namespace quoin
