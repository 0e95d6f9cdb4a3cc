// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/triangulation/changing_triangulation3.h"

namespace quoin {

/// A regular triangulation (weighted Delaunay triangulation) of points of space to which weighted points are added and
/// from which they are taken away; of any affine dimension, -1 without points.
///
/// Exact; at any time its cells are those of Regular3 of the points that are there, ties included, whatever was done
/// before. A hidden point stays, belongs to the cell that holds it, and becomes a vertex once what hides it has gone;
/// it counts for the dimension. Equal points with different weights have an id each, and the heaviest hides the others.
/// What it offers besides is in ChangingTriangulation3.
class ChangingRegular3 : public ChangingTriangulation3<ChangingWeightedPoints3> {
 public:
  ChangingRegular3() = default;
  /// As many weights as points. The id of the heaviest of equal points is its number in Regular3; others follow.
  /// @throws as Regular3, but takes no points for none
  ChangingRegular3(std::span<const Point3> points, std::span<const double> weights, const Context& context = Context());

  /// The id of the weighted point: a new one, or the one that is there, once more. O(1) expected on average for points
  /// spread evenly of which few are hidden, and O(1) for each hidden point of the cells that go, without interruption;
  /// O(n) where the dimension is below 2 or grows.
  /// @throws InputError  the point or weight is not finite, or there are more than 2^30 points or cells
  /// @throws Cancelled   through `context`, where one is given
  std::uint32_t insert(const Point3& p, double weight);
  std::uint32_t insert(const Point3& p, double weight, const Context& context);

  /// Of a point that lives.
  double weight(std::uint32_t v) const { return points_.weight(v); }
  /// Whether it lives, but is no vertex of any cell. O(log n) where the dimension is below 2, else O(1).
  bool is_hidden(std::uint32_t v) const;
  std::size_t hidden_count() const;
};

}  // namespace quoin
