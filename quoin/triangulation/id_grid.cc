// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/id_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quoin {

void IdGrid::build(std::span<const Point3> points, std::span<const std::uint32_t> ids) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  IdGrid grid;
  std::array<double, 3> high{-infinity, -infinity, -infinity};
  grid.low_ = {infinity, infinity, infinity};
  for (const std::uint32_t id : ids) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      grid.low_[axis] = std::min(grid.low_[axis], points[id][axis]);
      high[axis] = std::max(high[axis], points[id][axis]);
    }
  }
  // Where points are too far apart, too near, or too few, there is one box.
  std::array<double, 3> extent{};
  for (std::size_t axis = 0; axis < 3; ++axis) extent[axis] = std::max(high[axis] - grid.low_[axis], 0.0);
  grid.choose_boxes(extent, ids.size() / 2);
  grid.boxes_.assign(grid.counts_[0] * grid.counts_[1] * grid.counts_[2], none);
  for (const std::uint32_t id : ids) grid.put(points[id], id);
  grid.size_ = ids.size();
  *this = std::move(grid);
}

/// Cubes, as small as their number allows.
void IdGrid::choose_boxes(const std::array<double, 3>& extent, std::size_t most) {
  counts_ = {1, 1, 1};
  const double largest = std::max({extent[0], extent[1], extent[2]});
  if (!(largest > 0x1p-300 && largest < 0x1p300)) return;
  for (double per_extent = 1;; per_extent *= 1.25) {
    Place counts{};
    double all = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double count = std::floor(extent[axis] / largest * per_extent) + 1;
      all *= count;
      counts[axis] = static_cast<std::size_t>(count);
    }
    if (all > static_cast<double>(most)) return;
    counts_ = counts;
    per_side_ = per_extent / largest;
  }
}

IdGrid::Place IdGrid::place_of(const Point3& p) const {
  Place place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = (p[axis] - low_[axis]) * per_side_;
    // Beyond all boxes, and where it is no number, the boundary.
    const auto last = static_cast<double>(counts_[axis] - 1);
    place[axis] = static_cast<std::size_t>(along > 0 ? std::min(along, last) : 0);
  }
  return place;
}

/// By the sides of a box, 0 to 5; the place itself at the boundary.
IdGrid::Place IdGrid::beside(Place place, std::size_t side) const {
  std::size_t& along = place[side / 2];
  if (side % 2 == 0) {
    along = std::min(along + 1, counts_[side / 2] - 1);
  } else if (along > 0) {
    --along;
  }
  return place;
}

}  // namespace quoin
