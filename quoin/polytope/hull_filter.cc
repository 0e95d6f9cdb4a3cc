// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_filter.h"

#include <algorithm>

namespace quoin {

HullFilter::HullFilter(const HullBuilder& hull, double largest_coordinate) {
  // Bounds grow with the largest coordinate; that of few points may be smaller than that of all.
  const double growth = std::max(1.0, largest_coordinate / hull.largest_coordinate());
  for (std::uint32_t t = 0; t < hull.triangles().size(); ++t) {
    const HullBuilder::Triangle& triangle = hull.triangles()[t];
    if (triangle.is_free()) continue;
    HullBuilder::Plane plane = hull.plane(t);
    // Rounded once more, by less than what the slack has to spare.
    plane.offset -= growth * double{triangle.slack};
    planes_.push_back(plane);
  }
}

void HullFilter::append_others(std::span<const Point3> points, std::size_t begin, std::size_t end, std::uint32_t step,
                               std::vector<std::uint32_t>& others) const {
  Block block;
  for (std::size_t i = begin; i < end; ++i) {
    block.add(static_cast<std::uint32_t>(i * step), points[i * step]);
    if (block.count == block_size) append_others(block, others);
  }
  append_others(block, others);
}

/// Without branches, so that several points are tested at once. A value that is no number lets its point pass.
void HullFilter::append_others(Block& block, std::vector<std::uint32_t>& others) const {
  std::array<std::uint64_t, block_size> is_inside;
  is_inside.fill(1);
  for (const HullBuilder::Plane& plane : planes_) {
    for (std::size_t k = 0; k < block.count; ++k) {
      const double value = plane.x * block.x[k] + plane.y * block.y[k] + plane.z * block.z[k] - plane.offset;
      is_inside[k] &= static_cast<std::uint64_t>(value < 0);
    }
  }
  for (std::size_t k = 0; k < block.count; ++k) {
    if (is_inside[k] == 0) others.push_back(block.names[k]);
  }
  block.count = 0;
}

}  // namespace quoin
