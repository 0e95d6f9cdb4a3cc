// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/base/parallel.h"

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
  find_inner_ball(hull);
}

/// For a plane with the rounded normal n and value v at the centre, the value at p is at most v + |n| |p - centre|; v
/// holds the slack once, and needs it once more for its own rounding. The radius is smaller by far more than its own.
void HullFilter::find_inner_ball(const HullBuilder& hull) {
  if (hull.centre() == nullptr) return;
  centre_ = *hull.centre();
  double radius = std::numeric_limits<double>::infinity();
  std::size_t index = 0;
  for (std::uint32_t t = 0; t < hull.triangles().size(); ++t) {
    if (hull.triangles()[t].is_free()) continue;
    const HullBuilder::Plane& outer = planes_[index++];
    const double value = outer.x * centre_.x + outer.y * centre_.y + outer.z * centre_.z - outer.offset;
    const double slack = hull.plane(t).offset - outer.offset;
    const double length = std::sqrt(outer.x * outer.x + outer.y * outer.y + outer.z * outer.z);
    const double reach = -(value + slack) / length;
    if (!(reach >= radius)) radius = reach > 0 ? reach : 0;  // 0 too where it is no number
  }
  const double squared = radius * radius * (1 - 0x1p-30);
  squared_radius_ = radius > 0x1p-400 && squared < 0x1p1000 ? squared : 0;
}

void HullFilter::append_others(std::span<const Point3> points, std::uint32_t step, std::vector<std::uint32_t>& others,
                               const Context& context) const {
  constexpr std::size_t grain = 65536;
  const std::size_t count = chunk_count(points.size(), step);
  std::vector<std::vector<std::uint32_t>> lists(chunk_count(count, grain));
  for_each_chunk(context, count, grain, [&](const Chunk& chunk) {
    Block block;
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const Point3& p = points[k * step];
      const Vector3 d{p.x - centre_.x, p.y - centre_.y, p.z - centre_.z};
      if (d.x * d.x + d.y * d.y + d.z * d.z < squared_radius_) continue;
      block.add(static_cast<std::uint32_t>(k * step), p);
      if (block.count == block_size) append_others(block, lists[chunk.index]);
    }
    append_others(block, lists[chunk.index]);
  });
  std::size_t total = others.size();
  for (const auto& list : lists) total += list.size();
  others.reserve(total);
  for (const auto& list : lists) others.insert(others.end(), list.begin(), list.end());
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
