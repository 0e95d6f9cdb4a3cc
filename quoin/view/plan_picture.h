// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/view/scene.h"
#include "quoin/view/sphere_picture.h"

namespace quoin {

/// A part of an assembly, to draw.
struct PlanPart {
  std::string name{};
  std::vector<Point3> vertices{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< counterclockwise seen from outside
  std::vector<std::array<std::uint32_t, 2>> edges{};
};

/// Who stops whom in some direction, parts by index.
struct PlanGraph {
  std::vector<std::array<std::uint32_t, 2>> arcs{};   ///< a part, and one that it would meet
  std::vector<std::vector<std::uint32_t>> movable{};  ///< sets that can move
};

/// Some parts move away from others.
struct PlanMove {
  static constexpr std::uint32_t no_state = 0xFFFFFFFFU;
  std::vector<std::uint32_t> moving{};
  Vector3 direction{};      ///< unit vector
  std::string exact{};      ///< the direction as people read it
  std::uint32_t graph = 0;  ///< index into PlanPicture::graphs
  std::uint32_t moved_state = no_state;
  std::uint32_t rest_state = no_state;
};

/// Parts that are still together, and ways to part them.
struct PlanState {
  std::vector<std::uint32_t> parts{};
  std::vector<PlanMove> moves{};
  bool is_sought = true;  ///< moves were looked for
};

/// How an assembly comes apart, to look at.
struct PlanPicture {
  std::string title{};
  std::vector<ViewFact> facts{};
  std::vector<PlanPart> parts{};
  std::vector<PlanState> states{};
  std::vector<std::array<std::uint32_t, 2>> steps{};  ///< a state and the move that is made there
  std::vector<std::uint32_t> interlocked{};           ///< states at which the steps end
  std::vector<PlanGraph> graphs{};
  SpherePicture sphere{};                     ///< of directions; without a map where they are not shown
  std::vector<std::uint32_t> face_graphs{};   ///< for each face of the sphere, an index into graphs
  std::vector<std::uint32_t> edge_graphs{};   ///< for each edge
  std::vector<std::uint32_t> point_graphs{};  ///< for each point
};

}  // namespace quoin
