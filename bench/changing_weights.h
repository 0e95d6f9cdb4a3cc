// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "random.h"

/// Weights of points for changing_bench and its peer, the same on every platform: uniform from 0 to `most` times the
/// square of the spacing that so many points have if they fill a cube around them.
inline std::vector<double> changing_weights(const std::vector<std::array<double, 3>>& points, double most) {
  double extent = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    extent = std::max(extent, (*high)[axis] - (*low)[axis]);
  }
  const double spacing = extent / std::cbrt(static_cast<double>(points.size()));
  Random random(17);
  std::vector<double> weights(points.size());
  for (double& w : weights) w = (random.signed_unit() + 1) / 2 * most * spacing * spacing;
  return weights;
}
