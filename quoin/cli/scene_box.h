// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin::cli {

/// The box of points, grown on each side by an eighth of its longest one: what is drawn of a scene that has parts far
/// away. Up to roundings; nothing overflows.
class SceneBox {
 public:
  /// Of at least one point.
  explicit SceneBox(const std::vector<Point3>& points);

  bool holds(const Point3& p) const;
  /// From a point inside, straight along a direction whose largest coordinate is 1, to somewhere outside.
  Point3 beyond(const Point3& from, const Vector3& direction) const;
  /// The part of a segment that is inside, by fractions of it.
  std::optional<std::pair<double, double>> part_of(const Point3& a, const Point3& b) const;

 private:
  Point3 low_;
  Point3 high_;
};

}  // namespace quoin::cli
