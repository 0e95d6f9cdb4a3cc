// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_location.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace quoin {

DelaunayLocator::DelaunayLocator(const TriangulationView3& triangulation)
    : triangulation_(triangulation), stars_(triangulation) {
  if (triangulation.dimension() < 3) flat_.emplace(triangulation);
}

DelaunayLocation DelaunayLocator::locate(const Point3& p, std::uint32_t start) const {
  require_finite(p);
  const TriangulationView3& t = triangulation_;
  if (t.dimension() < 2) return flat_->locate_on_line(p);
  if (flat_ && !flat_->spans(p)) return {DelaunayLocation::Kind::outside_affine_hull, 0, 0};
  const auto walk = [&](std::uint32_t first, std::size_t steps) {
    if (flat_) return flat_->walk_in_plane(p, first, steps);
    return walk_to(p, steps, t.cells(), first, [&t](std::uint32_t v) { return t.point(v); });
  };
  const std::optional<std::uint32_t> hint = start < t.cells().size() ? std::optional(start) : std::nullopt;
  return walk_from(hint, walk, [&] { return stars_.cell(sampled_near(p)); });
}

int DelaunayLocator::compare(const Point3& p, std::uint32_t v, std::uint32_t w) const {
  const TriangulationView3& t = triangulation_;
  return compare_powers(p, t.point(v), t.weight(v), t.point(w), t.weight(w));
}

std::uint32_t DelaunayLocator::sampled_near(const Point3& p) const {
  const auto count = static_cast<std::uint32_t>(triangulation_.vertex_count());
  // As many samples as steps are saved by them.
  const auto samples = static_cast<std::uint32_t>(std::cbrt(static_cast<double>(count))) + 1;
  std::uint32_t best = triangulation_.cells()[0].vertices[0];
  if (best == vertex_at_infinity) best = triangulation_.cells()[0].vertices[1];
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto v = static_cast<std::uint32_t>(std::uint64_t{i} * count / samples);
    if (stars_.cell(v) != VertexStars::no_cell && compare(p, v, best) < 0) best = v;
  }
  return best;
}

std::uint32_t DelaunayLocator::nearest(const Point3& p) const {
  require_finite(p);
  if (triangulation_.dimension() < 2) return nearest_on_line(p);
  return walk_to_least(
      sampled_near(p), [&](std::uint32_t v, std::uint32_t w) { return compare(p, v, w); },
      [this](std::uint32_t v) { return stars_.neighbours(v); });
}

std::uint32_t DelaunayLocator::nearest_on_line(const Point3& p) const {
  const std::span<const std::uint32_t> line = flat_->line();
  // Distances, and powers, of vertices fall along it, stay and rise, as lifted points are convex: the next one is
  // nearer up to one of the nearest, which follow each other.
  std::size_t low = 0;
  std::size_t high = line.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const bool falls = compare(p, line[middle + 1], line[middle]) < 0;
    (falls ? low : high) = falls ? middle + 1 : middle;
  }
  std::uint32_t smallest = line[low];
  for (std::size_t i = low + 1; i < line.size() && compare(p, line[i], line[low]) == 0; ++i)
    smallest = std::min(smallest, line[i]);
  return smallest;
}

}  // namespace quoin
