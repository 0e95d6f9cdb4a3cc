// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"

namespace quoin {

/// Two faces that meet in an edge of no others.
struct FaceLink {
  std::uint32_t a;
  std::uint32_t b;
  bool agrees;  ///< they run along the edge in opposite directions
};

/// How faces would be turned so that neighbours agree.
struct Orientation {
  std::vector<std::uint32_t> component;  ///< per face: numbers of connected components, by their first faces
  std::uint32_t component_count = 0;
  std::vector<std::uint8_t> is_reversed;  ///< per face: turned against the first one of its component
  /// Of each component that no orientation fits, faces in a cycle, each a neighbour of the next, which turns a face
  /// over (a Moebius band); ordered by component.
  std::vector<std::vector<std::uint32_t>> one_sided_bands;
  std::vector<std::uint8_t> is_one_sided;  ///< per component
};

/// Flood fill across links. O(faces + links).
Orientation orient_faces(std::size_t face_count, std::span<const FaceLink> links, const Context& context);

}  // namespace quoin
