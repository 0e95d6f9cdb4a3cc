// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/scene_frame.h"

#include <algorithm>
#include <cmath>

namespace quoin {

bool SceneFrame::floats_hold(const std::vector<Point3>& points) const {
  const auto holds = [&](const Point3& p, std::size_t axis) {
    return center[axis] + scale * double{relative(p[axis], axis)} == p[axis];
  };
  return std::ranges::all_of(points, [&](const Point3& p) { return holds(p, 0) && holds(p, 1) && holds(p, 2); });
}

void SceneBounds::include(const Point3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::min(low_[axis], point[axis]);
    high_[axis] = std::max(high_[axis], point[axis]);
  }
}

SceneFrame SceneBounds::frame() const {
  SceneFrame frame;
  double half_size = 0;
  for (std::size_t axis = 0; axis < 3 && low_.x <= high_.x; ++axis) {
    frame.center[axis] = low_[axis] / 2 + high_[axis] / 2;
    half_size = std::max(half_size, high_[axis] / 2 - low_[axis] / 2);
  }
  if (half_size > 0) {
    int exponent = 0;
    std::frexp(half_size, &exponent);
    frame.scale = std::ldexp(1.0, std::clamp(exponent, -1022, 1023));
  }
  return frame;
}

}  // namespace quoin
