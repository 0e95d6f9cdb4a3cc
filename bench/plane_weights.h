// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "random.h"

namespace plane_points {

/// Weights of points of plane_points.h, uniform up to so many times the area per point. The same on every platform.
inline std::vector<double> weights(const std::string& kind, std::size_t count, int times) {
  // Lattices and grids have a unit of length, all others a square of side 2.
  const bool has_unit = kind == "lattice" || kind == "jittered" || kind == "grid";
  const double area = kind == "grid" || !has_unit ? 4.0 : 1.0;
  Random random(11);
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double unit = (random.signed_unit() + 1) / 2;
    result.push_back(unit * times * (has_unit ? area : area / static_cast<double>(count)));
  }
  return result;
}

}  // namespace plane_points
