// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/clipped_segments.h"

#include <cmath>

namespace quoin::cli {

namespace {

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Point3 between(const Point3& a, const Point3& b, double part) {
  return {a.x * (1 - part) + b.x * part, a.y * (1 - part) + b.y * part, a.z * (1 - part) + b.z * part};
}

}  // namespace

std::uint32_t add_near_point(LayeredScene& scene, const Point3& p) {
  scene.near_points.push_back(p);
  return static_cast<std::uint32_t>(scene.point_count() - 1);
}

void ClippedSegments::draw(SceneSpot& a, SceneSpot& b, std::uint32_t owner, std::uint32_t stop, SceneLayer& layer) {
  if (!is_finite(a.at) || !is_finite(b.at)) return;
  const auto part = box_.part_of(a.at, b.at);
  if (!part) return;
  const auto [first, last] = *part;
  const std::uint32_t from = first == 0 ? point_of(a) : add_near_point(scene_, between(a.at, b.at, first));
  const std::uint32_t to = last == 1 ? point_of(b) : add_near_point(scene_, between(a.at, b.at, last));
  layer.vertices.insert(layer.vertices.end(), {from, to});
  layer.begin.push_back(stop);
  layer.owners.push_back(owner);
}

std::uint32_t ClippedSegments::point_of(SceneSpot& spot) {
  if (spot.point == SceneSpot::none) spot.point = add_near_point(scene_, spot.at);
  return spot.point;
}

}  // namespace quoin::cli
