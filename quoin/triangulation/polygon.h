// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/kernel/constructions.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Three indices into the points of a polygon, counterclockwise.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Triangulates a polygon with holes, exactly.
///
/// `loops` are index chains into `points`: the polygon's interior is on the left of every loop edge (outer loops
/// counterclockwise, holes clockwise), in any order, several outer loops allowed. Loops may touch each other and
/// themselves in vertices (a vertex index may occur more than once), and collinear vertices are kept: every loop edge
/// is an edge of the result, every vertex a vertex of it, no triangle has zero area, no vertex is added. What lies
/// inside and bounds nothing is kept likewise: an edge passed once in each direction (a slit; a loop of two is one by
/// itself) and a loop of one vertex.
///
/// Returns nothing when the loops do not bound such a polygon: edges cross, overlap or are passed twice in one
/// direction, a vertex lies inside another edge, two indices lie on one spot, a slit or a loop of one vertex lies
/// outside, or the orientation is wrong. Exact for all finite doubles, no tolerance.
/// Triangles and quadrilaterals take a direct path without allocation beyond the result; otherwise O(n log n).
std::optional<std::vector<PolygonTriangle>> triangulate_polygon(std::span<const Point2> points,
                                                                std::span<const std::vector<std::uint32_t>> loops);

/// The same over a caller's arrays, for many small polygons: appends to `triangles` and returns false, leaving it
/// as it was, where the other returns nothing. `loop_begin` holds loop count + 1 offsets into `loop_points`.
bool triangulate_polygon(std::span<const Point2> points, std::span<const std::uint32_t> loop_points,
                         std::span<const std::uint32_t> loop_begin, std::vector<PolygonTriangle>& triangles);

/// The same of explicit points of a table, rational ones too, projected along an axis: counterclockwise is as seen from
/// the positive end of the axis, or from the other one. O(n log n).
struct PolygonView {
  unsigned axis;
  bool from_positive;
};
bool triangulate_polygon(const Constructions& table, std::span<const PointId> points, const PolygonView& view,
                         std::span<const std::uint32_t> loop_points, std::span<const std::uint32_t> loop_begin,
                         std::vector<PolygonTriangle>& triangles);

}  // namespace quoin
