// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/occupancy_grid.h"

namespace quoin {

OccupancyGrid::OccupancyGrid(const std::array<float, 6>& bounds)
    : bounds_{{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}}, rows_(std::size_t{cells} * cells) {
  for (std::size_t k = 0; k < 3; ++k) {
    scale_[k] = static_cast<float>(cells) / (bounds_.hi[k] - bounds_.lo[k]);
    if (!std::isfinite(scale_[k])) scale_[k] = 0;
  }
}

// Monotone in x (0 where extents overflow), and that is all that counts: boxes with a point in common have a cell in
// common.
std::uint32_t OccupancyGrid::cell(float x, std::size_t axis) const {
  const float at = (x - bounds_.lo[axis]) * scale_[axis];
  constexpr auto last = static_cast<float>(cells - 1);
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(std::max(0.0F, at), last)));
}

OccupancyGrid::Range OccupancyGrid::range(const FloatBox& box) const {
  Range result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.first[k] = cell(box.lo[k], k);
    result.last[k] = cell(box.hi[k], k);
  }
  return result;
}

std::size_t OccupancyGrid::add(const FloatBox& box) {
  const Range r = range(box);
  const std::uint64_t bits = r.row_bits();
  for (std::uint32_t z = r.first[2]; z <= r.last[2]; ++z) {
    for (std::uint32_t y = r.first[1]; y <= r.last[1]; ++y) rows_[z * cells + y] |= bits;
  }
  return std::size_t{r.last[2] - r.first[2] + 1} * (r.last[1] - r.first[1] + 1);
}

bool OccupancyGrid::may_meet(const FloatBox& box) const {
  if (!meet(box, bounds_)) return false;
  const Range r = range(box);
  const std::uint64_t bits = r.row_bits();
  for (std::uint32_t z = r.first[2]; z <= r.last[2]; ++z) {
    for (std::uint32_t y = r.first[1]; y <= r.last[1]; ++y) {
      if ((rows_[z * cells + y] & bits) != 0) return true;
    }
  }
  return false;
}

}  // namespace quoin
