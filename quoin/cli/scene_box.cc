// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/scene_box.h"

#include <algorithm>
#include <limits>

namespace quoin::cli {

SceneBox::SceneBox(const std::vector<Point3>& points) : low_(points[0]), high_(points[0]) {
  constexpr double largest = std::numeric_limits<double>::max();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Point3& p : points) {
      low_[axis] = std::min(low_[axis], p[axis]);
      high_[axis] = std::max(high_[axis], p[axis]);
    }
  }
  const Point3 half{high_.x / 2 - low_.x / 2, high_.y / 2 - low_.y / 2, high_.z / 2 - low_.z / 2};
  const double margin = std::max({half.x, half.y, half.z}) / 4;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::max(-largest, low_[axis] - margin);
    high_[axis] = std::min(largest, high_[axis] + margin);
  }
}

bool SceneBox::holds(const Point3& p) const {
  return low_.x <= p.x && p.x <= high_.x && low_.y <= p.y && p.y <= high_.y && low_.z <= p.z && p.z <= high_.z;
}

Point3 SceneBox::beyond(const Point3& from, const Vector3& direction) const {
  constexpr double largest = std::numeric_limits<double>::max();
  double half = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) half = std::max(half, high_[axis] / 2 - low_[axis] / 2);
  Point3 to = from;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = from[axis] / 4 + half * direction[axis];
    to[axis] = std::clamp(at, -largest / 4, largest / 4) * 4;
  }
  return to;
}

std::optional<std::pair<double, double>> SceneBox::part_of(const Point3& a, const Point3& b) const {
  double from = 0;
  double to = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = b[axis] / 4 - a[axis] / 4;
    if (along == 0) {
      if (a[axis] < low_[axis] || a[axis] > high_[axis]) return std::nullopt;
      continue;
    }
    const double enters = ((along > 0 ? low_ : high_)[axis] / 4 - a[axis] / 4) / along;
    const double leaves = ((along > 0 ? high_ : low_)[axis] / 4 - a[axis] / 4) / along;
    from = std::max(from, enters);
    to = std::min(to, leaves);
  }
  if (!(from < to)) return std::nullopt;
  return std::pair{from, to};
}

}  // namespace quoin::cli
