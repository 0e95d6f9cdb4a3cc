// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "quoin/polytope/cubical_map.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

/// "x = -1" and the like.
const char* cube_square_name(std::size_t square);

/// What a caller says of the cells of a cubical map; by default their numbers.
struct CubePictureOptions {
  std::string title{};
  std::function<std::string(std::uint32_t)> vertex_name{};
  bool has_labels = false;  ///< numbers of vertices in their faces
};

/// The cube of a map, unfolded as a cross and seen from outside: x grows to the right on the square in the middle (y =
/// -1), z upward on the four of the row; above them z = 1, below z = -1.
///
/// Faces have the colours of their vertices, real edges are strong, sides of squares that lie on no arc are faint;
/// points are normals of facets. Where two squares meet in the picture, what lies there is drawn once. O(size).
PlanarPicture cube_picture_of(const CubicalMap& map, const CubePictureOptions& options = {});

}  // namespace quoin
