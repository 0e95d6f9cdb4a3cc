// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/cli/scene_box.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// A place, and its point in a scene, if it is there.
struct SceneSpot {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  Point3 at;
  std::uint32_t point = none;
};

/// Adds segments to layers of a scene as far as they are in the box of its points: ends of those that go far.
class ClippedSegments {
 public:
  /// The scene has its points, and must outlive it.
  explicit ClippedSegments(LayeredScene& scene) : scene_(scene), box_(scene.points) {}

  const SceneBox& box() const { return box_; }

  /// What of a segment is not far outside, there from a stop on; nothing of one with an end beyond the largest double.
  void draw(SceneSpot& a, SceneSpot& b, std::uint32_t owner, std::uint32_t stop, SceneLayer& layer);

 private:
  std::uint32_t point_of(SceneSpot& spot);

  LayeredScene& scene_;
  SceneBox box_;
};

/// One more point, told in single precision; its number.
std::uint32_t add_near_point(LayeredScene& scene, const Point3& p);

}  // namespace quoin::cli
