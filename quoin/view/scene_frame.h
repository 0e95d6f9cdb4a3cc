// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin {

/// Centre and half size of a scene; the size is a power of two, so that dividing by it is exact.
struct SceneFrame {
  Point3 center;
  double scale = 1;

  /// What pages hold of a coordinate, in single precision.
  float relative(double x, std::size_t axis) const { return static_cast<float>((x - center[axis]) / scale); }
  /// Whether center + scale * relative is the coordinate itself for all of the points.
  bool floats_hold(const std::vector<Point3>& points) const;
};

/// Finds the frame of points, which are finite.
class SceneBounds {
 public:
  void include(const Point3& point);
  SceneFrame frame() const;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 low_{infinity, infinity, infinity};
  Point3 high_{-infinity, -infinity, -infinity};
};

}  // namespace quoin
