// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace quoin::io {

/// A side of a face, from corner to corner, and whose it is.
struct FaceSide {
  std::array<std::uint32_t, 2> corners;
  std::uint32_t face;  ///< from 0
};

/// What keeps faces, so many with these sides, from being the surface of a ball; empty if nothing does. They are one if
/// each side is met once each way, all faces hang together, and corners and faces are two more than edges: which leaves
/// no room for a corner where two fans of faces meet. O(n log n), n sides; reorders them.
std::string why_no_sphere(std::vector<FaceSide>& sides, std::uint32_t faces);

}  // namespace quoin::io
