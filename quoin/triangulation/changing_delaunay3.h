// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/changing_triangulation3.h"

namespace quoin {

/// A Delaunay triangulation of space to which points are added and from which they are taken away; of any affine
/// dimension, -1 without points.
///
/// Exact; at any time its cells are those of Delaunay3 of the points that are there, ties included, whatever was done
/// before. What it offers besides is in ChangingTriangulation3; no point is hidden.
class ChangingDelaunay3 : public ChangingTriangulation3<ChangingPoints3> {
 public:
  ChangingDelaunay3() = default;
  /// The id of a vertex is its number in Delaunay3. @throws as Delaunay3, but takes no points for none
  explicit ChangingDelaunay3(std::span<const Point3> points, const Context& context = Context());

  /// The vertex of the point: a new one, or the one that is there, once more. O(1) expected on average for points
  /// spread evenly; O(n) where the dimension is below 2 or grows.
  /// @throws InputError  the point is not finite, or there are more than 2^30 vertices or cells
  /// @throws Cancelled   through `context`, where one is given
  std::uint32_t insert(const Point3& p);
  std::uint32_t insert(const Point3& p, const Context& context);

  /// The living vertex of least distance, of equal ones the one of the smallest id; as `locate`, but O(n) where the
  /// dimension is below 2. @throws InputError if the point is not finite, or there is no vertex
  std::uint32_t nearest(const Point3& p) const;
};

}  // namespace quoin
